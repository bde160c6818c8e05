#include "polishing/experiments/shipped_tasks.hpp"

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {

Task shipped_task(const std::string& name) {
  for (const auto& [known, text] : shipped_task_texts())
    if (known == name) return parse_task(std::string(text), name + ".yaml");
  throw Error("no task " + in_quotes(name) + " comes along");
}

}  // namespace burnish::polishing

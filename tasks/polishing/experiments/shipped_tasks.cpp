#include "polishing/experiments/shipped_tasks.hpp"

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {

Task shipped_task(const std::string& name) {
  for (const auto& [file, text] : shipped_task_texts())
    if (file == name) return parse_task(std::string(text), name + ".yaml");
  throw Error("there is no bundled task " + in_quotes(name));
}

}  // namespace burnish::polishing

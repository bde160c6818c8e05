#include <sstream>
#include <stdexcept>

#include "burnish/tasks/polishing/task_file.hpp"
#include "fuzz/readers.hpp"

namespace burnish::fuzz {
namespace {

/// Comments such as "#set path.kind=spiral" are overrides of the command line.
std::vector<std::string> overrides_in(const std::string& text) {
  constexpr std::string_view mark = "#set ";
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(mark)) result.push_back(line.substr(mark.size()));
  return result;
}

void read(const std::string& text) {
  const polishing::Task task =
      polishing::parse_task(text, "nowhere/input.yaml", overrides_in(text));
  const std::string written = polishing::task_text(task);
  std::string again;
  try {
    again = polishing::task_text(polishing::parse_task(written, "nowhere/written.yaml"));
  } catch (const Error& refusal) {
    throw std::logic_error(std::string("a task that was written is refused: ") + refusal.what());
  }
  if (again != written) throw std::logic_error("a task that was written reads back as another");
}

}  // namespace

const Reader task{"task", read};

}  // namespace burnish::fuzz

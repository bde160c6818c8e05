#include <sstream>
#include <stdexcept>

#include "burnish/tasks/polishing/task_file.hpp"
#include "fuzz/readers.hpp"
#include "named_tasks.hpp"
#include "polishing/descriptions.hpp"

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

template <class Task>
void read_as(const std::string& text) {
  const auto said = files::parse_said<Task>(text, "nowhere/input.yaml", overrides_in(text));
  files::placed(said.texts, [&] { check_task(said.spec); });
  const std::string written = task_text(said.spec);
  std::string again;
  try {
    const Task back = files::parse_said<Task>(written, "nowhere/written.yaml").spec;
    check_task(back);
    again = task_text(back);
  } catch (const Error& refusal) {
    throw std::logic_error(std::string("a task that was written is refused: ") + refusal.what());
  }
  if (again != written) throw std::logic_error("a task that was written reads back as another");
}

void read(const std::string& text) {
  const auto task = document::Reader::parse(text, "nowhere/input.yaml").find("task");
  bool named = false;
  each_named_task([&](const auto& known) {
    if (named || !task || !task->is(known.name)) return;
    named = true;
    read_as<typename std::decay_t<decltype(known)>::Task>(text);
  });
  if (!named) read_as<polishing::Task>(text);
}

}  // namespace

const Reader task{"task", read};

}  // namespace burnish::fuzz

#include <sstream>
#include <stdexcept>

#include "burnish/tasks/polishing/task_file.hpp"
#include "fuzz/readers.hpp"
#include "named_tasks.hpp"
#include "polishing/descriptions.hpp"

namespace burnish::fuzz {
namespace {

/// Returns overrides of the command line, taken from comments such as "#set path.kind=spiral".
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
  const auto parsed = files::parse_said<Task>(text, "nowhere/input.yaml", overrides_in(text));
  files::placed(parsed.texts, [&] { check_task(parsed.spec); });
  const std::string written = task_text(parsed.spec);
  std::string again;
  try {
    const Task reread = files::parse_said<Task>(written, "nowhere/written.yaml").spec;
    check_task(reread);
    again = task_text(reread);
  } catch (const Error& refusal) {
    throw std::logic_error(std::string("reading refuses a written task: ") + refusal.what());
  }
  if (again != written) throw std::logic_error("a written task changes when it is read again");
}

void read(const std::string& text) {
  const auto task = document::Reader::parse(text, "nowhere/input.yaml").find("task");
  bool named = false;
  each_named_task([&](const auto& candidate) {
    if (named || !task || !task->is(candidate.name)) return;
    named = true;
    read_as<typename std::decay_t<decltype(candidate)>::Task>(text);
  });
  if (!named) read_as<polishing::Task>(text);
}

}  // namespace

const Reader task{"task", read};

}  // namespace burnish::fuzz

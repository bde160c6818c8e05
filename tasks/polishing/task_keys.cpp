#include "polishing/task_keys.hpp"

#include <algorithm>
#include <sstream>

#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {
namespace {

std::vector<TaskSection> all_sections() {
  std::vector<TaskSection> sections = where_sections();
  for (TaskSection& section : controller_sections()) sections.push_back(std::move(section));
  sections.push_back(disturbances_section());
  return sections;
}

const TaskKey& key_of(const TaskSection& section, const std::string& name) {
  return *std::find_if(section.keys.begin(), section.keys.end(),
                       [&](const TaskKey& key) { return key.name == name; });
}

void read_section(Task& task, const TaskSection& section, const files::YamlReader& reader) {
  if (!section.word_is.empty() && !reader.is_map()) {
    key_of(section, section.word_is).read(task, reader);
    return;
  }
  std::vector<std::string> names;
  for (const TaskKey& key : section.keys) names.push_back(key.name);
  reader.allow_only(names);
  for (const TaskKey& key : section.keys)
    if (const auto value = reader.find(key.name)) key.read(task, *value);
}

/// Lines of text as comments.
std::string comment(const std::string& text, const std::string& indent) {
  std::istringstream lines(text);
  std::string result, line;
  while (std::getline(lines, line)) result += indent + "# " + line + "\n";
  return result;
}

/// The comment stands behind the value where there is room for it, above it otherwise.
std::string line_of(const std::string& indent, const std::string& value, const TaskKey& key) {
  constexpr std::size_t column = 34, width = 118;
  std::string line = indent + key.name + ": " + value;
  if (key.meaning.empty()) return line + "\n";
  const std::size_t before = std::max(line.size() + 2, column);
  if (before + 2 + key.meaning.size() > width) return comment(key.meaning, indent) + line + "\n";
  line.resize(before, ' ');
  return line + "# " + key.meaning + "\n";
}

}  // namespace

const std::vector<TaskSection>& task_sections() {
  static const std::vector<TaskSection> sections = all_sections();
  return sections;
}

void read_sections(Task& task, const files::YamlReader& file) {
  std::vector<std::string> names;
  for (const TaskSection& section : task_sections()) {
    if (!section.name.empty()) names.push_back(section.name);
    if (section.name.empty())
      for (const TaskKey& key : section.keys) names.push_back(key.name);
  }
  file.allow_only(names);
  // The surface's name sets a posture too; one that is stated counts.
  for (const TaskSection& section : task_sections())
    if (!section.name.empty())
      if (const auto value = file.find(section.name)) read_section(task, section, *value);
  for (const TaskSection& section : task_sections())
    if (section.name.empty())
      for (const TaskKey& key : section.keys)
        if (const auto value = file.find(key.name)) key.read(task, *value);
}

std::string task_text(const Task& task) {
  std::string text =
      "# A polishing task for `burnish polish`. SI units, angles in rad. A key that is left out "
      "has\n"
      "# its default.\n";
  for (const TaskSection& section : task_sections()) {
    std::string lines, indent;
    if (!section.name.empty()) {
      lines = "\n" + comment(section.meaning, "") + section.name + ":\n";
      indent = "  ";
    }
    for (const TaskKey& key : section.keys)
      if (const auto value = key.write(task)) lines += line_of(indent, *value, key);
    text += lines;
  }
  return text;
}

}  // namespace burnish::polishing

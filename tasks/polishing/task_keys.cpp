#include "polishing/task_keys.hpp"

#include <algorithm>
#include <sstream>

#include "burnish/tasks/polishing/task_file.hpp"
#include "files/csv_table.hpp"
#include "files/described.hpp"
#include "files/read_values.hpp"
#include "polishing/descriptions.hpp"

namespace burnish::polishing {
namespace {

using document::Reader;

/// Keys that set several entries at once, and are not written; the others of a section count
/// behind.
TaskKey surface_key() {
  return {"name", "",
          [](Task& task, const Reader& reader) {
            std::vector<std::string> names;
            for (const NamedSurface& surface : named_surfaces()) names.push_back(surface.name);
            put_on(task, reader.word(names));
          },
          [](const Task& /*task*/) -> std::optional<std::string> { return std::nullopt; }};
}
TaskKey preset_key() {
  return {"preset", "",
          [](Task& task, const Reader& reader) {
            const std::uint64_t seed = task.disturbances.seed;
            task.disturbances = disturbance_preset(reader.word(disturbance_presets()));
            task.disturbances.seed = seed;
          },
          [](const Task& /*task*/) -> std::optional<std::string> { return std::nullopt; }};
}

std::vector<Eigen::Vector2d> points_of_table(const Reader& reader) {
  std::vector<Eigen::Vector2d> points;
  const std::filesystem::path folder = std::filesystem::path(reader.file()).parent_path();
  reader.named([&] {
    const files::CsvTable table = files::read_csv(files::beside(folder, reader.text()));
    const Eigen::VectorXd u = table.column("u"), w = table.column("w");
    for (Eigen::Index i = 0; i < u.size(); ++i) points.emplace_back(u[i], w[i]);
  });
  return points;
}

/// An entry of the task, or of a value that it holds at `offset`.
TaskKey described_key(const Field& field, std::size_t offset) {
  return {field.key, field.comment(),
          [&field, offset](Task& task, const Reader& reader) {
            if (field.key == "points" && !reader.is_list())
              task.path.points = points_of_table(reader);
            else
              files::read_entry(field, reinterpret_cast<char*>(&task) + offset, reader);
          },
          [&field, offset](const Task& task) {
            return files::entry_text(field, reinterpret_cast<const char*>(&task) + offset);
          }};
}

/// Limits are of the tool, the controller and the task; what a file says first is most asked for.
void put_in_order(TaskSection& limits) {
  static const std::vector<std::string> first{"force",
                                              "force_window",
                                              "tool_speed",
                                              "joint_speed_ratio",
                                              "joint_margin",
                                              "stale",
                                              "bad",
                                              "contact_lost",
                                              "contact_threshold",
                                              "late_contact_travel",
                                              "late_contact_time",
                                              "unexpected_force",
                                              "release"};
  const auto place = [](const TaskKey& key) {
    return std::find(first.begin(), first.end(), key.name);
  };
  std::stable_sort(limits.keys.begin(), limits.keys.end(),
                   [&](const TaskKey& a, const TaskKey& b) { return place(a) < place(b); });
}

/// A value that the task holds is a section; so is a group of its own entries.
std::vector<TaskSection> all_sections() {
  const Description& task = description_of(static_cast<const Task*>(nullptr));
  std::vector<TaskSection> sections{{"", "", {}}};
  auto group = task.groups.begin();
  for (std::size_t i = 0; i < task.fields.size(); ++i) {
    const Field& field = task.fields[i];
    if (group != task.groups.end() && group->begin == i) {
      if (!group->key.empty()) sections.push_back({group->key, group->meaning, {}});
      ++group;
    }
    if (field.type->kind == ValueType::Kind::Struct) {
      if (sections.back().name != field.key) sections.push_back({field.key, field.comment(), {}});
      for (const Field& entry : field.type->description().fields)
        sections.back().keys.push_back(described_key(entry, field.offset));
    } else {
      sections.back().keys.push_back(described_key(field, 0));
    }
  }
  for (TaskSection& section : sections) {
    if (section.name == "surface") section.keys.insert(section.keys.begin(), surface_key());
    if (section.name == "disturbances") section.keys.insert(section.keys.begin(), preset_key());
    if (section.name == "limits") put_in_order(section);
    section.word_is = section.name == "surface"        ? "name"
                      : section.name == "disturbances" ? "preset"
                      : section.name == "path"         ? "kind"
                                                       : "";
  }
  return sections;
}

const TaskKey& key_of(const TaskSection& section, const std::string& name) {
  return *std::find_if(section.keys.begin(), section.keys.end(),
                       [&](const TaskKey& key) { return key.name == name; });
}

void read_section(Task& task, const TaskSection& section, const Reader& reader) {
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

void read_sections(Task& task, const document::Reader& file) {
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

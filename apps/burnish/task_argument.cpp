#include "task_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "named_tasks.hpp"
#include "pressing/arm.hpp"
#include "robots/known_robots.hpp"
#include "shell_word.hpp"

namespace burnish::app {

std::string place_name(const std::string& surface, const polishing::Task& task) {
  std::string name = surface;
  for (const polishing::NamedSurface& named : polishing::named_surfaces()) {
    if (named.name != surface) continue;
    const Eigen::Vector3d normal = task.normal_base.normalized();
    const double tilt = std::acos(std::clamp(normal.z(), -1.0, 1.0)) * 180.0 / M_PI;
    if ((normal - named.normal_world.normalized()).norm() > 1e-6)
      name = fmt::format("tilt_{:.0f}", tilt);
  }
  if (!task.shape.is_flat()) name += "_" + name_of(task.shape.kind);
  return name;
}

namespace {

/// Kind of a YAML file, with the command for this kind.
struct FileKind {
  std::string what, command;
};
/// Returns the kind of a file, from its top-level keys. `command` is empty if the keys do not
/// determine the kind.
FileKind kind_of_file(const std::string& file) {
  const auto top = files::Reader::parse(read_text(file, "YAML file"), file);
  if (!top.is_map()) return {};
  const auto has = [&](const char* key) { return top.find(key).has_value(); };
  if (const auto task = top.find("task")) {
    if (task->is("polishing")) return {"a task file of burnish polish", "polish"};
    if (did_you_mean(task->node().text, {"polishing"}).empty())
      return {"a task file of burnish run", "run"};
    return {};
  }
  if (has("terms")) return {"an optimal-control problem", "solve"};
  if (has("urdf") || has("mjcf")) return {"a robot's settings file", "show"};
  if (has("surface")) return {"a task file of burnish polish", "polish"};
  return {};
}
}  // namespace

bool is_polishing_task(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && kind_of_file(file).command == "polish";
}

namespace {
void refuse_robot(const std::string& file, const std::string& option) {
  const std::string kind = std::filesystem::path(file).extension().string();
  std::error_code ignored;
  const bool is_description = kind == ".urdf" || kind == ".xml" || kind == ".mjcf";
  if (!is_description && (std::filesystem::exists(file, ignored) || !robot_file(file))) return;
  throw Error(fmt::format("{} is a robot; wanted a task file; did you mean {} {}?", in_quotes(file),
                          option, shell_word(file)));
}
/// Refuses the name of a task in place of a task file.
void refuse_task_name(const std::string& file) {
  std::error_code ignored;
  const std::vector<std::string> names = task_names();
  if (std::filesystem::exists(file, ignored) ||
      std::find(names.begin(), names.end(), file) == names.end())
    return;
  throw Error(fmt::format(
      "{} is the name of a task; wanted a task file with `task: {}`, such as a copy of a file in "
      "tasks/{}",
      in_quotes(file), file, file));
}
std::string wanted_of(const std::string& command) {
  if (command == "show") return "a robot";
  return command == "solve" ? "an optimal-control problem" : "a task file of burnish " + command;
}

}  // namespace

void refuse_file_of_another_command(const std::string& file, const std::string& wanted) {
  const std::string extension = std::filesystem::path(file).extension().string();
  std::error_code ignored;
  if ((extension != ".yaml" && extension != ".yml") ||
      !std::filesystem::is_regular_file(file, ignored))
    return;
  const FileKind kind = kind_of_file(file);
  const bool is_task = kind.command == "polish" && wanted == "run";  // `run` runs all tasks
  if (kind.command.empty() || kind.command == wanted || is_task) return;
  throw Error(fmt::format("{} is {}; wanted {}; did you mean burnish {} {}?", in_quotes(file),
                          kind.what, wanted_of(wanted), kind.command, shell_word(file)));
}

void refuse_other_file(const std::string& file, const std::string& wanted,
                       const std::string& robot_option) {
  refuse_robot(file, robot_option);
  refuse_task_name(file);
  refuse_file_of_another_command(file, wanted);
}

bool is_overridden(const std::vector<files::Reader>& texts, const std::string& key) {
  return std::any_of(
      texts.begin() + (texts.empty() ? 0 : 1), texts.end(),
      [&](const files::Reader& text) { return files::stated(text, key).has_value(); });
}

void check_stated_feet(const Model& model, const Standing& standing,
                       const std::vector<files::Reader>& texts) {
  if (is_overridden(texts, "robot") && !is_overridden(texts, "standing.feet")) return;
  if (standing.feet == std::vector<std::string>{"auto"}) return;
  for (const std::string& foot : standing.feet)
    if (!model.has_frame(foot))
      throw EntryError("standing.feet", "frame " + pressing::none_of(model, foot));
}

}  // namespace burnish::app

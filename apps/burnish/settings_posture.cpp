#include "settings_posture.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "base/text_file.hpp"
#include "base/whole_file.hpp"
#include "base/yaml_word.hpp"
#include "burnish/base/error.hpp"
#include "robots/known_robots.hpp"
#include "robots/robot_settings.hpp"

namespace burnish::app {
namespace {

double rounded(double value) {
  constexpr double digits = 1e4;
  return std::round(digits * value) / digits + 0.0;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::size_t indentation(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool is_blank(const std::string& line) {
  const std::size_t at = line.find_first_not_of(" \t\r");
  return at == std::string::npos || line[at] == '#';
}

/// Returns the settings text with the line `entry` inserted as the first entry under the key
/// `postures`.
std::string with_entry(const std::string& text, const std::string& entry) {
  std::vector<std::string> lines = lines_of(text);
  const std::string key = "postures:";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].starts_with(key)) continue;
    if (!is_blank(lines[i].substr(key.size())))
      throw Error(
          "the entries of the key 'postures' are on the same line as the key; move them to the "
          "lines below it, and add this line by hand: " +
          entry);
    std::size_t next = i + 1, indent = 2;
    while (next < lines.size() && is_blank(lines[next])) ++next;
    if (next < lines.size() && indentation(lines[next]) > 0) indent = indentation(lines[next]);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 std::string(indent, ' ') + entry);
    return fmt::format("{}\n", fmt::join(lines, "\n"));
  }
  return text + (text.empty() || text.back() == '\n' ? "" : "\n") + key + "\n  " + entry + "\n";
}

}  // namespace

Posture posture_of(const Model& model, const Eigen::VectorXd& q) {
  Posture posture;
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    std::vector<double>& values = posture[joint.name];
    if (joint.kind == JointKind::Continuous || joint.kind == JointKind::Planar) {
      const Eigen::Index angle = joint.q_index + joint.nq - 2;
      for (Eigen::Index i = joint.q_index; i < angle; ++i) values.push_back(rounded(q[i]));
      values.push_back(rounded(std::atan2(q[angle + 1], q[angle])));
      continue;
    }
    // Writes quaternions with all digits, because rounded ones would not have unit length.
    for (int i = 0; i < joint.nq; ++i)
      values.push_back(joint.nq > 1 ? q[joint.q_index + i] : rounded(q[joint.q_index + i]));
  }
  return posture;
}

std::string posture_text(const Posture& posture) {
  std::string text;
  for (const auto& [name, values] : posture) {
    const std::string entries = fmt::format("{}", fmt::join(values, ", "));
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", yaml_word(name),
                        values.size() == 1 ? entries : "[" + entries + "]");
  }
  return "{" + text + "}";
}

std::filesystem::path settings_file_of(const std::string& robot) {
  for (const std::string& name : {robot, robot.substr(0, robot.rfind(':'))}) {
    const auto file = robot_file(name);
    if (!file) continue;
    const std::string extension = file->extension().string();
    if (extension == ".yaml" || extension == ".yml") return *file;
  }
  throw Error(fmt::format(
      "robot '{}' has no settings file to add a posture to; wanted a settings file, which "
      "`burnish show ROBOT --write-settings DIR --tool FRAME` drafts",
      robot));
}

void add_posture(const std::filesystem::path& settings, const std::string& name,
                 const Posture& posture) {
  const std::string origin = settings.string();
  const std::string text = read_text(settings, "settings file");
  const std::string entry = fmt::format("{}: {}", yaml_word(name), posture_text(posture));
  if (parse_robot_settings(text, origin).common.postures.contains(name))
    throw Error(fmt::format("{}: posture '{}' already exists; wanted another name", origin, name));
  try {
    const std::string changed = with_entry(text, entry);
    (void)parse_robot_settings(changed, origin);
    write_whole_file(settings, changed);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: posture '{}' cannot be added: {}", origin, name, error.what()));
  }
}

}  // namespace burnish::app

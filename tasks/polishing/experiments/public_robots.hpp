// List of robots in public repositories: their files, and the settings of their tasks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/results_table.hpp"

namespace burnish::polishing {

struct PublicRobot {
  std::string name;
  std::string repository = {};  ///< OWNER/NAME at GitHub; empty: `file` is in the folder itself.
  std::string commit = {};      ///< Tested commit of the repository; may be empty.
  std::string file;             ///< Path of the description in the repository.
  std::string tool = {};        ///< Frame of the tool, for an arm.
  std::vector<std::string> feet = {};     ///< Frames of the feet, for a robot with legs.
  std::string task = {};                  ///< Legged robots: file in tasks/stand without .yaml.
  std::vector<std::string> changes = {};  ///< Changes of the task, see override_task().
  std::string because = {};               ///< Reason for `changes`; empty without changes.

  bool stands() const { return !feet.empty(); }
  /// Returns the URL of the description at the tested commit, or the path of a file without a
  /// repository.
  std::string url() const;
};

/// Name of the file that lists the robots of a folder, in place of the bundled list.
inline constexpr const char* public_robots_file = "robots.yaml";

/// Reads a list; `name` is its name in errors:
///
///     repositories: {OWNER/NAME: commit, ...}
///     arms: {NAME: {repository: OWNER/NAME, file: path, tool: frame}, ...}
///     legged: {NAME: {repository: OWNER/NAME, file: path, feet: [frames], task: quadruped}, ...}
///
/// `repository` may be omitted. Each entry may have `set: [key=value, ...]` with `because: reason`.
/// Throws Error with line, key and requirement.
std::vector<PublicRobot> parse_public_robots(const std::string& text, const std::string& name);
/// Returns the bundled list.
std::vector<PublicRobot> shipped_public_robots();

/// Returns the path of a description file, or nothing if it is missing. The repository may lie in
/// the folder as OWNER+NAME, OWNER/NAME or NAME.
std::optional<std::filesystem::path> find_description(const std::filesystem::path& folder,
                                                      const PublicRobot& robot);

struct PublicRobotFile {
  PublicRobot robot;
  std::optional<std::filesystem::path> file = {};
};
/// Returns the robots of a folder, as listed in its robots.yaml or else in the bundled list. Throws
/// Error if the folder is missing, if the list is malformed, or if the folder contains none of the
/// listed descriptions.
std::vector<PublicRobotFile> public_robots_in(const std::filesystem::path& folder);

/// Returns a table with a row per robot: its source and the settings of its task.
ResultTable public_robots_table(const std::vector<PublicRobot>& robots);

}  // namespace burnish::polishing

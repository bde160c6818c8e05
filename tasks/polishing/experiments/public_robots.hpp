// Robots of public repositories: which file of which one, and what a task is told of each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/results_table.hpp"

namespace burnish::polishing {

struct PublicRobot {
  std::string name;
  std::string repository = {};  ///< OWNER/NAME at GitHub; empty: the file lies in the folder itself
  std::string commit = {};      ///< of that repository, with which it was tried; may be empty
  std::string file;             ///< the description's path in the repository
  std::string tool = {};        ///< of an arm: frame that holds the tool
  std::vector<std::string> feet = {};     ///< of a robot with legs: frames
  std::string task = {};                  ///< with feet: of tasks/stand, without ending
  std::vector<std::string> changes = {};  ///< of the task, as override_task() takes them
  std::string because = {};               ///< why there are changes; empty without

  bool stands() const { return !feet.empty(); }
  /// Of the description at that commit; of a file of the folder its path.
  std::string url() const;
};

/// The file in a folder of that list, in place of the shipped one.
inline constexpr const char* public_robots_file = "robots.yaml";

/// Reads a list, called `name` in refusals:
///
///     repositories: {OWNER/NAME: commit, ...}
///     arms: {NAME: {repository: OWNER/NAME, file: path, tool: frame}, ...}
///     legged: {NAME: {repository: OWNER/NAME, file: path, feet: [frames], task: quadruped}, ...}
///
/// `repository` may be left out, and `set: [key=value, ...]` with `because: why` added to each.
/// Throws Error naming line, key and what was wanted.
std::vector<PublicRobot> parse_public_robots(const std::string& text, const std::string& name);
/// The list that is shipped.
std::vector<PublicRobot> shipped_public_robots();

/// Where a description lies in a folder: in OWNER+NAME, OWNER/NAME or NAME; none where it does not.
std::optional<std::filesystem::path> find_description(const std::filesystem::path& folder,
                                                      const PublicRobot& robot);

struct PublicRobotFile {
  PublicRobot robot;
  std::optional<std::filesystem::path> file = {};
};
/// All of the folder's own list, or of the shipped one. Throws Error for a folder that is not
/// there, a list that is none, and where none of the descriptions is there.
std::vector<PublicRobotFile> public_robots_in(const std::filesystem::path& folder);

/// A row per robot: where it comes from and what the task is told of it.
ResultTable public_robots_table(const std::vector<PublicRobot>& robots);

}  // namespace burnish::polishing

// The arguments by which every command names a robot.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

struct RobotArguments {
  std::string robot;
  bool free_flyer = false, fixed = false, strict = false;
  std::vector<std::string> locked, free;
  std::string lock_posture, srdf;

  /// Adds ROBOT, --free-flyer, --fixed, --lock, --free, --lock-posture, --srdf and --strict.
  void add_to(CLI::App& command);
  /// Throws Error as load_robot does; warnings go to standard error.
  Robot load() const;
};

/// Adds --strict to a command whose robot is named elsewhere.
void add_strict(CLI::App& command, bool& strict);

/// Prints the robot's warnings to standard error, of more than 10 how many more there are, and its
/// notes. Throws
/// Error with them where `strict`.
void print_warnings(const Robot& robot, bool strict = false);
/// The same for a robot by name. Throws Error as load_robot does.
void print_warnings_of(const std::string& robot, bool strict);

}  // namespace burnish::app

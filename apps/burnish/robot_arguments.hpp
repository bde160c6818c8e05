// Arguments that select a robot, shared by the commands.
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

  /// Adds the arguments ROBOT, --free-flyer, --fixed, --lock, --free, --lock-posture, --srdf and
  /// --strict.
  void add_to(CLI::App& command);
  /// Loads the robot and prints its warnings to the standard error. Throws Error if load_robot()
  /// fails.
  Robot load() const;
};

/// Adds --strict to a command that selects the robot by arguments of its own.
void add_strict(CLI::App& command, bool& strict);

/// Prints the robot's notes and at most 10 of its warnings to the standard error, with the number
/// of omitted warnings. Throws Error with the warnings if `strict`.
void print_warnings(const Robot& robot, bool strict = false);
/// Loads a robot by name and prints its warnings. Throws Error if load_robot() fails.
void print_warnings_of(const std::string& robot, bool strict);

}  // namespace burnish::app

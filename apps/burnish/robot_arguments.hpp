// The arguments by which every command names a robot.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "burnish/model/robot.hpp"

namespace burnish::app {

struct RobotArguments {
  std::string robot;
  bool free_flyer = false, fixed = false;
  std::vector<std::string> locked, free;
  std::string lock_posture;

  /// Adds ROBOT, --free-flyer, --fixed, --lock, --free and --lock-posture.
  void add_to(CLI::App& command);
  /// Throws Error as load_robot does.
  Robot load() const;
};

}  // namespace burnish::app

#include "robot_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/findings.hpp"
#include "burnish/base/error.hpp"
#include "task_argument.hpp"

namespace burnish::app {

void RobotArguments::add_to(CLI::App& command) {
  command
      .add_option(
          "ROBOT", robot,
          "URDF or MJCF file, folder with robot.yaml, or a name that burnish --robots lists")
      ->type_name("")
      ->required();
  command.add_flag("--free-flyer", free_flyer, "Let the base move freely");
  command.add_flag("--fixed", fixed, "Fix the base to the world");
  command
      .add_option("--lock", locked,
                  "Joints to lock, in addition to the locked joints of the settings")
      ->type_name("JOINT")
      ->delimiter(',');
  command.add_option("--free", free, "Joints to leave free; all other joints are locked")
      ->type_name("JOINT")
      ->delimiter(',');
  command.add_option("--lock-posture", lock_posture, "Posture at which joints are locked")
      ->type_name("NAME");
  command
      .add_option("--srdf", srdf,
                  "SRDF file whose group states become postures [the SRDF file with the name of "
                  "the URDF file, in its folder]")
      ->type_name("FILE");
  add_strict(command, strict);
}

Robot RobotArguments::load() const {
  if (free_flyer && fixed) throw Error("--free-flyer and --fixed exclude each other");
  refuse_file_of_another_command(robot, "show");
  RobotOverrides overrides;
  if (free_flyer) overrides.base = Base::FreeFlyer;
  if (fixed) overrides.base = Base::Fixed;
  overrides.locked = locked;
  overrides.free = free;
  overrides.posture = lock_posture;
  overrides.srdf = srdf;
  overrides.strict = strict;
  Robot loaded = load_robot(robot, overrides);
  print_warnings(loaded);
  return loaded;
}

void add_strict(CLI::App& command, bool& strict) {
  command.add_flag("--strict", strict, "Treat warnings about the robot's description as errors");
}

void print_warnings_of(const std::string& robot, bool strict) {
  print_warnings(load_robot(robot), strict);
}

void print_warnings(const Robot& robot, bool strict) {
  if (strict) refuse_warnings("", robot.warnings);
  constexpr std::size_t max_printed = 10;
  const std::size_t count = robot.warnings.size();
  for (std::size_t i = 0; i < std::min(count, max_printed); ++i)
    fmt::print(stderr, "burnish: warning: {}\n", robot.warnings[i]);
  if (count > max_printed)
    fmt::print(stderr, "burnish: {} more warnings; burnish show ROBOT --json prints all\n",
               count - max_printed);
  for (const std::string& note : robot.notes) fmt::print(stderr, "burnish: note: {}\n", note);
}

}  // namespace burnish::app

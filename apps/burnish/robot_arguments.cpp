#include "robot_arguments.hpp"

#include "burnish/base/error.hpp"

namespace burnish::app {

void RobotArguments::add_to(CLI::App& command) {
  command.add_option("ROBOT", robot, "URDF file, folder with robot.yaml, or known name")
      ->type_name("")
      ->required();
  command.add_flag("--free-flyer", free_flyer, "Let the base float free");
  command.add_flag("--fixed", fixed, "Hold the base");
  command.add_option("--lock", locked, "Hold these joints as well")
      ->type_name("JOINT")
      ->delimiter(',');
  command.add_option("--free", free, "Hold all joints but these")
      ->type_name("JOINT")
      ->delimiter(',');
  command.add_option("--lock-posture", lock_posture, "Posture at which joints are held")
      ->type_name("NAME");
}

Robot RobotArguments::load() const {
  if (free_flyer && fixed) throw Error("--free-flyer and --fixed exclude each other");
  RobotOverrides overrides;
  if (free_flyer) overrides.base = Base::FreeFlyer;
  if (fixed) overrides.base = Base::Fixed;
  overrides.locked = locked;
  overrides.free = free;
  overrides.posture = lock_posture;
  return load_robot(robot, overrides);
}

}  // namespace burnish::app

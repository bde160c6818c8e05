// Task of controllers that make no plans: approach a surface, press on it and follow a path.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace burnish {

/// Target of the tip at one time: motion of the origin of the tip's frame, and force of the surface
/// on the tip.
/// @described sim
struct TaskPoint {
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< Position, world axes [m]
  Eigen::Vector3d v_world = Eigen::Vector3d::Zero();  ///< Velocity, world axes [m/s]
  Eigen::Vector3d a_world = Eigen::Vector3d::Zero();  ///< Acceleration, world axes [m/s^2]
  double force = 0.0;                                 ///< Force along the surface's normal [N]
  /// Unit normal of the surface at this point; zero: the controller's constant normal is used
  Eigen::Vector3d normal_world = Eigen::Vector3d::Zero();
};

/// Circle in a plane. The path starts at the centre, at rest, and its radius grows smoothly.
/// @described sim
struct CirclePath {
  Eigen::Vector3d center_world = Eigen::Vector3d::Zero();  ///< Centre of the circle, world axes [m]
  /// Normal of the circle's plane, of any nonzero length
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  double radius = 0.07;   ///< Final radius of the circle [m]
  double rate = 1.0;      ///< Angular rate about the normal [rad/s]
  double start_up = 2.0;  ///< Time until the final radius is reached, positive [s]
  double force = 30.0;    ///< Normal force to press with [N]

  /// Returns the point of the circle at time `t` after the start [s]. For t < 0, returns the start.
  TaskPoint at(double t) const noexcept;
};

/// Task of a controller that makes no plans, in three phases: approach the surface until contact,
/// ramp up the force, then follow the path. These phases are Approach, Ramp and Track in the
/// enumeration Phase.
/// @described sim
struct PressingPath {
  std::string tool = "tool";  ///< Frame of the tool; its origin follows the path
  /// Normal of the surface, pointing towards the robot, not zero
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// Target of the tip as a function of the time since the end of the ramp, in s
  /// @more The function must not throw. During approach and ramp, the target is the start of the
  /// path.
  std::function<TaskPoint(double t)> task;
  Eigen::VectorXd posture;       ///< Target posture for the motion in the null space, nq entries
  double period = 1e-3;          ///< Time between two ticks [s], > 0
  double approach_speed = 0.05;  ///< Speed of the approach, against the normal [m/s], >= 0
  /// Measured normal force at which the approach ends [N], >= 0
  /// @more PressingTask describes how contact is detected.
  double contact_threshold = 2.0;
  double touch_force = 2.0;  ///< Target force at contact, where the ramp starts [N], >= 0
  double ramp = 0.5;         ///< Duration of the ramp from contact to the task's force [s], >= 0
};

}  // namespace burnish

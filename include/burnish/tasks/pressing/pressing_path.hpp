// What controllers without a plan are told of a task that presses along a path.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace burnish {

/// Where the tip frame's origin shall be and how hard the surface shall push back.
/// @described sim
struct TaskPoint {
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v_world = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d a_world = Eigen::Vector3d::Zero();  ///< [m/s^2]
  double force = 0.0;                                 ///< [N], along the surface's normal
  /// of the surface there, of length one; zero: the controller's own
  Eigen::Vector3d normal_world = Eigen::Vector3d::Zero();
};

/// A circle in a plane. It starts at the centre, at rest, and its radius grows smoothly.
/// @described sim
struct CirclePath {
  Eigen::Vector3d center_world = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of the plane, any length but zero
  double radius = 0.07;                                     ///< [m]
  double rate = 1.0;                                        ///< [rad/s], about the normal
  double start_up = 2.0;  ///< [s] until the radius is reached; positive
  double force = 30.0;    ///< [N]

  /// At t s from the start; before it, the start.
  TaskPoint at(double t) const noexcept;
};

/// The task of a controller without a plan: down to the surface, until it is felt, up to the force,
/// along the path. These are the phases Approach, Ramp and Track of Phase.
/// @described sim
struct PressingPath {
  std::string tool = "tool";  ///< frame whose origin follows the path
  /// of the surface, towards the robot, not zero
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// The task at t s after the ramp; before, it stays at its start. Must not throw.
  std::function<TaskPoint(double t)> task;
  Eigen::VectorXd posture;       ///< nq, what the null space is drawn to
  double period = 1e-3;          ///< [s] between ticks, > 0
  double approach_speed = 0.05;  ///< [m/s], against the normal, >= 0
  /// [N] of measured normal force that end the approach; see PressingTask, >= 0
  double contact_threshold = 2.0;
  double touch_force = 2.0;  ///< [N], asked for where contact is made; the ramp starts there, >= 0
  double ramp = 0.5;         ///< [s] from contact to the task's force, >= 0
};

}  // namespace burnish

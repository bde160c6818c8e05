// The baseline without optimal control: an impedance of the tool in the world, the wanted force fed
// forward, its error integrated, a posture in the null space (O. Khatib, "A unified approach for
// motion and force control of robot manipulators", 1987). With L = (J M^-1 J^T)^-1 of the tip,
//   tau = J^T (L (a - dJ/dt v) + f_friction - f n) + b + (1 - J^T L J M^-1) tau_posture,
//   a   = a_path + kp e + kd de/dt along the surface,  -kd_normal v_n along its normal n,
//   f   = f_path + ki * integral of (f_path - f_measured).
#pragma once

#include <functional>
#include <memory>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"

namespace burnish {

/// Where the tip frame's origin shall be and how hard the surface shall push back.
struct TaskPoint {
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d v_world = Eigen::Vector3d::Zero();  ///< m/s
  Eigen::Vector3d a_world = Eigen::Vector3d::Zero();  ///< m/s^2
  double force = 0.0;                                 ///< N, along the surface's normal
  /// of the surface there, of length one; zero: the controller's own
  Eigen::Vector3d normal_world = Eigen::Vector3d::Zero();
};

/// A circle in a plane. It starts at the centre, at rest, and its radius grows smoothly.
struct CirclePath {
  Eigen::Vector3d center_world = Eigen::Vector3d::Zero();   ///< m
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of the plane, any length but zero
  double radius = 0.07;                                     ///< m
  double rate = 1.0;                                        ///< rad/s, about the normal
  double start_up = 2.0;  ///< s until the radius is reached; positive
  double force = 30.0;    ///< N

  /// At t s from the start; before it, the start.
  TaskPoint at(double t) const noexcept;
};

struct ImpedanceSpec {
  std::string tool = "tool";                                ///< frame whose origin follows the path
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();  ///< of the surface, towards the robot
  /// The task at t s after the ramp; before, it stays at its start. Must not throw.
  std::function<TaskPoint(double t)> task;
  Eigen::VectorXd posture;  ///< nq, what the null space is drawn to
  double period = 1e-3;     ///< s between ticks

  double kp = 900.0;             ///< 1/s^2, along the surface
  double kd = 60.0;              ///< 1/s, along the surface
  double kd_normal = 30.0;       ///< 1/s, along the normal
  double ki = 10.0;              ///< 1/s, of the force error; 0: no force feedback
  double integral_limit = 30.0;  ///< N, largest correction by the integral
  double posture_kp = 20.0;      ///< 1/s^2
  double posture_kd = 6.0;       ///< 1/s
  double friction = 0.0;         ///< of the surface, fed forward along the path's velocity
  double approach_speed = 0.05;  ///< m/s, of a point that draws the tip against the normal
  /// N of measured normal force that end the approach; see PressingTask
  double contact_threshold = 2.0;
  double ramp = 0.5;  ///< s from the threshold to the task's force
};

/// Phases (see Phase): Approach, Ramp, Track. A measurement that is no state, or a tip that cannot
/// move in all directions, gives the command before again with the status that says so. Throws
/// Error for an unknown frame, an empty task, a posture of the wrong size, a zero normal, and
/// gains, times and thresholds that are negative or not finite.
std::unique_ptr<Controller> make_impedance_controller(const Model& model,
                                                      const ImpedanceSpec& spec);

}  // namespace burnish

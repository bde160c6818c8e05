// The baseline without optimal control: an impedance of the tool in the world, the wanted force fed
// forward, the errors of force and place integrated, a posture in the null space (O. Khatib, "A
// unified approach for motion and force control of robot manipulators", 1987). With
// L = (J M^-1 J^T)^-1 of the tip,
//   tau = J^T (L (a - dJ/dt v) + f_friction - f n) + b + (1 - J^T L J M^-1) tau_posture,
//   a   = a_path + kp e + kd de/dt + ki_position * integral of e along the surface,
//         -kd_normal v_n along its normal n,
//   f   = f_path + ki * integral of (f_path - f_measured).
// Both integrals are bounded, start anew where contact is made, and stand still while a torque is
// at its limit.
#pragma once

#include <memory>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"

namespace burnish {

/// Of the impedance; with e the tool's position error along the surface.
/// @described sim
struct ImpedanceGains {
  double kp = 14000.0;  ///< [1/s^2], along the surface, >= 0
  double kd = 147.0;    ///< [1/s], along the surface, >= 0
  /// [1/s^3], of the position's error along the surface; 0: no integral, >= 0
  double ki_position = 445000.0;
  double position_integral_limit = 20.0;  ///< [m/s^2], largest correction by that integral, >= 0
  double kd_normal = 48.0;                ///< [1/s], along the normal, >= 0
  double ki = 66.0;                       ///< [1/s], of the force error; 0: no force feedback, >= 0
  double integral_limit = 30.0;           ///< [N], largest correction by that integral, >= 0
  double posture_kp = 9.0;                ///< [1/s^2], >= 0
  double posture_kd = 10.0;               ///< [1/s], >= 0
};

/// The baseline without optimal control: an impedance of the tool in the world, the wanted force
/// fed forward, the errors of force and place integrated, a posture in the null space. With e the
/// tool's position error along the surface, v_n its velocity along the normal n and f the force
/// along n: a = a_path + kp e + kd de/dt + ki_position * integral of e - kd_normal v_n n and f =
/// f_path + ki * integral of (f_path - f_measured), by the tool's inertia and its Jacobian as
/// torques. Both integrals are bounded, start anew where contact is made, and stand still while a
/// torque is at its limit.
/// @described sim
struct ImpedanceSpec {
  PressingPath path = {};
  ImpedanceGains gains = {};
  double friction = 0.0;  ///< of the surface, fed forward along the path's velocity, >= 0
};

/// Phases (see Phase): Approach, Ramp, Track. A measurement that is no state, or a tip that cannot
/// move in all directions, gives the command before again with the status that says so. Throws
/// Error for an unknown frame, an empty task, a posture of the wrong size, a zero normal, and
/// gains, times and thresholds that are negative or not finite.
std::unique_ptr<Controller> make_impedance_controller(const Model& model,
                                                      const ImpedanceSpec& spec);

}  // namespace burnish

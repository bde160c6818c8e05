// Impedance controller: the baseline without optimal control. Source: O. Khatib, "A unified
// approach for motion and force control of robot manipulators", 1987.
#pragma once

#include <memory>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"

namespace burnish {

/// Gains of the impedance controller. The gains act on the tool's position error along the surface,
/// on the force error along the normal, and on the posture error.
/// @described sim
struct ImpedanceGains {
  double kp = 14000.0;  ///< Proportional gain on the position error along the surface [1/s^2], >= 0
  double kd = 147.0;    ///< Derivative gain on the position error along the surface [1/s], >= 0
  /// Integral gain on the position error along the surface (0: no integral) [1/s^3], >= 0
  double ki_position = 445000.0;
  /// Largest correction by the integral of the position error [m/s^2], >= 0
  double position_integral_limit = 20.0;
  double kd_normal = 48.0;  ///< Damping of the tool's velocity along the normal [1/s], >= 0
  double ki = 66.0;         ///< Integral gain on the force error (0: no force feedback) [1/s], >= 0
  /// Largest correction by the integral of the force error [N], >= 0
  double integral_limit = 30.0;
  /// Proportional gain on the posture error in the null space [1/s^2], >= 0
  double posture_kp = 9.0;
  double posture_kd = 10.0;  ///< Derivative gain on the posture error in the null space [1/s], >= 0
};

/// Baseline controller without optimal control: an impedance of the tool in the world. It has
/// feedforward of the target force, integrals of the force and position errors, and control of the
/// posture in the null space.
///
/// The controller computes the acceleration a = a_path + kp e + kd de/dt + ki_position * integral
/// of e - kd_normal v_n n and the force f = f_path + ki * integral of (f_path - f_measured). The
/// tool's inertia and Jacobian turn a and f into torques. Here n is the surface's normal, e the
/// tool's position error along the surface, and v_n the tool's velocity along n. a_path and f_path
/// are the targets of acceleration and force. All forces are along n. Both integrals are bounded,
/// restart at contact, and pause while a torque is at its limit.
/// @described sim
/// make_impedance_controller() states the whole control law.
struct ImpedanceSpec {
  PressingPath path = {};     ///< Approach, force and path of the tool
  ImpedanceGains gains = {};  ///< Gains on position, force and posture
  /// Friction coefficient that the feedforward of friction along the path assumes, >= 0
  double friction = 0.0;
};

/// Creates the impedance controller. It computes
///   tau = J^T (L (a - dJ/dt v) + f_friction - f n) + b + (1 - J^T L J M^-1) tau_posture,
///   a   = a_path + kp e + kd de/dt + ki_position * integral of e   along the surface,
///         -kd_normal v_n                                           along the normal n,
///   f   = f_path + ki * integral of (f_path - f_measured).
/// n is the surface's normal, J the Jacobian of the tip, L = (J M^-1 J^T)^-1 the tip's inertia, M
/// the mass matrix, and b the bias torques. e is the tip's position error, and v_n the tip's
/// velocity along n. a_path and f_path are the targets of acceleration and force, f_friction is the
/// friction feedforward, and tau_posture the torque of the posture gains. During the approach, f is
/// zero, and the tip follows a point that moves along n with the approach speed. Both integrals are
/// bounded, restart at contact, and pause while a torque is at its limit.
///
/// The phases are Approach, Ramp and Track; see Phase. If a measurement is invalid, or if the tip
/// cannot move in all directions, the previous command is repeated. Command::status then gives the
/// reason.
///
/// Throws Error for an unknown frame, an empty PressingPath::task, a posture of the wrong size or a
/// zero normal. Also throws Error for gains, times and thresholds that are negative or not finite.
std::unique_ptr<Controller> make_impedance_controller(const Model& model,
                                                      const ImpedanceSpec& spec);

}  // namespace burnish

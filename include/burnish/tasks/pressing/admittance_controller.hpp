// Admittance controller: a force loop around joint position control, as for arms with a position
// interface. Source: N. Hogan, "Impedance control: an approach to manipulation", 1985.
#pragma once

#include <memory>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"

namespace burnish {

/// Gains of the admittance controller: an outer force loop and an inner joint position loop. The
/// inner loop uses the robot's mass matrix and gravity.
/// @described sim
struct AdmittanceGains {
  /// Rate of the outer loop [Hz], > 0
  /// @more The period is rounded to whole ticks, at least one.
  double rate = 500.0;
  /// Delay between the outer loop and the inner loop [s], 0 to 1
  /// @more The delay counts from the measurement of the outer loop and is rounded to ticks.
  double delay = 4e-3;
  /// Cutoff of the low-pass filter on the measured force in the outer loop [rad/s], > 0
  double force_cutoff = 200.0;
  /// Mass of the admittance, as a multiple of the tool's inertia along the normal, >= 0
  double mass = 0.5;
  /// Damping of the admittance, as a multiple of the tool's inertia along the normal [1/s], > 0
  double damping = 250.0;
  double ki = 5.0;  ///< Integral gain on the force error (0: no integral) [1/s], >= 0
  /// Largest correction by the integral of the force error [N], >= 0
  double integral_limit = 30.0;
  /// Gain from the position error along the surface to the tool's velocity [1/s], >= 0
  /// @more The error is the distance between the path and the tip at the commanded joint positions.
  double path_gain = 20.0;
  /// Damping of the inverse kinematics (damped least squares) [m/rad], > 0
  double ik_damping = 0.01;
  /// Gain from the posture error to the joint velocities in the null space [1/s], >= 0
  double posture_gain = 1.0;
  double joint_kp = 10000.0;   ///< Proportional gain of the inner loop [1/s^2], >= 0
  double joint_kd = 150.0;     ///< Derivative gain of the inner loop [1/s], >= 0
  double joint_ki = 150000.0;  ///< Integral gain of the inner loop (0: no integral) [1/s^3], >= 0
  /// Largest correction of joint accelerations by the integral of the inner loop [rad/s^2], >= 0
  double joint_integral_limit = 50.0;
};

/// Controller with two loops, as for arms with a position interface. The outer loop turns the force
/// error into a motion of the tool along the surface's normal n. Inverse kinematics turn this
/// motion into joint positions q_c, which the inner loop tracks.
///
/// Outer loop: the commanded speed v_n along n solves
/// l (mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of (f - f_path), where f is the
/// low-pass filtered force along n, and l the tool's inertia along n. The tool's velocity is v_n n
/// along n, and v_path + path_gain (p_path - p) along the surface. f_path, p_path and v_path are
/// the targets of force, position and velocity, and p is the tip's position at q_c. Damped least
/// squares compute dq_c/dt from the tool's velocity.
///
/// The inner loop computes, `delay` later, the torques tau = M (joint_kp (q_c - q) + joint_kd
/// (dq_c/dt - v) + joint_ki * integral of (q_c - q)) + b. M is the mass matrix and b the bias
/// torques. Both integrals are bounded, restart at contact, and pause while a torque is at its
/// limit.
/// @described sim
/// make_admittance_controller() states the whole control law.
struct AdmittanceSpec {
  PressingPath path = {};      ///< Approach, force and path of the tool
  AdmittanceGains gains = {};  ///< Gains of both loops
};

/// Creates the admittance controller. At the rate `rate`, the outer loop computes
///   l (mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of (f - f_path),
///   v_tool = v_n n + (1 - n n^T) (v_path + path_gain (p_path - p)),
///   dq_c/dt = J^T (J J^T + ik_damping^2)^-1 (v_tool - J s) + s,
///   s = posture_gain (posture - q_c).
/// n is the surface's normal, f the low-pass filtered force along n, and v_n the commanded speed
/// along n. q_c are the commanded joint positions. J and p are the tip's Jacobian and position at
/// q_c. l = 1 / (n^T J M^-1 J^T n) is the tip's inertia along n. f_path, p_path and v_path are the
/// targets of force, position and velocity. They are evaluated `delay` ahead, because the inner
/// loop receives the command that much later.
///
/// At every tick the inner loop computes
///   tau = M (joint_kp (q_c - q) + joint_kd (dq_c/dt - v) + joint_ki * integral of (q_c - q)) + b.
/// M is the mass matrix and b the bias torques.
///
/// The phases are Approach, Ramp and Track; see Phase. During the approach, the tool moves towards
/// the surface with the approach speed. Both integrals restart at contact and pause while a torque
/// is at its limit. If a measurement is invalid, the previous command is repeated, and
/// Command::status gives the reason.
///
/// Throws Error for an unknown frame, an empty PressingPath::task, a posture of the wrong size or a
/// zero normal. Also throws Error for gains, times and thresholds that are negative or not finite.
std::unique_ptr<Controller> make_admittance_controller(const Model& model,
                                                       const AdmittanceSpec& spec);

}  // namespace burnish

// A controller in two loops, as arms with a position interface are driven through ROS: an outer one
// that turns the force's error into a motion of the tool along the surface's normal (N. Hogan,
// "Impedance control: an approach to manipulation", 1985) and that by inverse kinematics into joint
// positions, and an inner one that holds these. With f the force along the normal n behind a
// low-pass, v_n the commanded speed along it, q_c the commanded joints, J, p the tip's Jacobian and
// place there and l = 1 / (n^T J M^-1 J^T n) its inertia along the normal, the outer loop computes
//   l (mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of (f - f_path),
//   v_tool = v_n n + (1 - n n^T) (v_path + path_gain (p_path - p)),
//   dq_c/dt = J^T (J J^T + ik_damping^2)^-1 (v_tool - J s) + s,   s = posture_gain (posture - q_c),
// with the path as it will be `delay` later, when the inner one gets that and, at every tick, gives
//   tau = M (joint_kp (q_c - q) + joint_kd (dq_c/dt - v) + joint_ki * integral of (q_c - q)) + b.
#pragma once

#include <memory>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"

namespace burnish {

/// Of both loops. The inner one knows the robot's mass matrix and gravity.
/// @described sim
struct AdmittanceGains {
  double rate = 500.0;  ///< [Hz], of the outer loop; rounded to ticks, one at least, > 0
  double delay = 4e-3;  ///< [s], from its measurement to the inner loop; rounded to ticks, 0 to 1
  double force_cutoff = 200.0;  ///< [rad/s], low-pass of the measured force in the outer loop, > 0
  /// of the admittance, as a multiple of the tool's inertia along the normal, >= 0
  double mass = 0.5;
  double damping = 250.0;              ///< [1/s], of the admittance; times that inertia, > 0
  double ki = 5.0;                     ///< [1/s], of the force error; 0: no integral of it, >= 0
  double integral_limit = 30.0;        ///< [N], largest correction by that integral, >= 0
  double path_gain = 20.0;             ///< [1/s], of the commanded tool's way to the path, >= 0
  double ik_damping = 0.01;            ///< of the inverse kinematics, m/rad, > 0
  double posture_gain = 1.0;           ///< [1/s], of the commanded joints to the posture, >= 0
  double joint_kp = 10000.0;           ///< [1/s^2], of the inner loop, >= 0
  double joint_kd = 150.0;             ///< [1/s], of the inner loop, >= 0
  double joint_ki = 150000.0;          ///< [1/s^3], of the inner loop; 0: no integral, >= 0
  double joint_integral_limit = 50.0;  ///< [rad/s^2], largest correction by that integral, >= 0
};

/// A controller in two loops, as arms with a position interface are driven: an outer one that turns
/// the force's error into a motion of the tool along the surface's normal, and that by inverse
/// kinematics into joint positions, and an inner one that holds these. With f the force along the
/// normal n behind a low-pass, q_c the commanded joints and p the tip's place there, l its inertia
/// along n: l (mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of it; v_tool = v_n n and
/// along the surface v_path + path_gain (p_path - p); dq_c/dt by damped least squares; and delay s
/// later tau = M (joint_kp (q_c - q) + joint_kd (dq_c/dt - v) + joint_ki * integral of (q_c - q)) +
/// b. Integrals are bounded, start anew where contact is made, and stand still while a torque is at
/// its limit.
/// @described sim
struct AdmittanceSpec {
  PressingPath path = {};
  AdmittanceGains gains = {};
};

/// Phases (see Phase): Approach, Ramp, Track. On the approach v_n is the approach's speed;
/// integrals start anew where contact is made, and stand still while a torque is at its limit. A
/// measurement that is no state gives the command before again with the status that says so. Throws
/// Error as make_impedance_controller() does.
std::unique_ptr<Controller> make_admittance_controller(const Model& model,
                                                       const AdmittanceSpec& spec);

}  // namespace burnish

// Inverse dynamics of robots with closed loops: from the motion of the motors to their torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

/// Input of loop_inverse(): motion of the driven joints, and forces of all contacts except loops.
struct LoopMotion {
  Eigen::VectorXd q;  ///< Configuration with closed loops, nq entries

  /// Velocity, nv entries [rad/s, m/s]. Entries of passive joints (without a motor) are used only
  /// if the loops do not determine their motion.
  Eigen::VectorXd v;
  /// Acceleration, nv entries [rad/s^2, m/s^2]. Entries of passive joints (without a motor) are
  /// used only if the loops do not determine their motion.
  Eigen::VectorXd a;
  /// Contact forces, one entry per row of all contacts [N, Nm]. The entries of loop contacts are
  /// ignored.
  Eigen::VectorXd lambda;
};

/// Result of loop_inverse(): a motion that satisfies the loop constraints, with the torques and
/// forces that produce the motion.
struct LoopInverse {
  /// Velocity and acceleration, nv entries each. Driven joints move as requested, as far as the
  /// loops permit. The motion of passive joints (without a motor) follows from the driven joints.
  Eigen::VectorXd v, a;
  /// Torques, nv entries [Nm, N]. Torques of passive joints (without a motor) are at most
  /// `unbalanced`.
  Eigen::VectorXd tau;

  /// Contact forces, one entry per row of all contacts [N, Nm]. Forces of loop contacts are
  /// computed; the other forces are copied from the input.
  Eigen::VectorXd lambda;
  double unbalanced = 0.0;  ///< Largest torque that a joint without a motor would need [Nm, N]
  Status status = Status::Ok;
};

/// Computes the motion of the passive joints from the motion of the driven joints, then torques and
/// loop forces. A passive joint is a joint without a motor. If the torques are not unique, the
/// motor torques have the least norm. `dynamics` must belong to `model` and contain its loops as
/// contacts. All contacts must be active. If the computation fails (is_usable() is false), `tau` is
/// empty. Throws Error if `actuation` names an unknown joint.
LoopInverse loop_inverse(const Model& model, ContactDynamics& dynamics, const LoopMotion& motion,
                         const ActuationSpec& actuation = {});

}  // namespace burnish

// Inverse dynamics of robots with closed loops: from the motion of the motors to their torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

/// Input of loop_inverse(): motion of the driven joints, and forces at contacts that close no
/// loop.
struct LoopMotion {
  Eigen::VectorXd q;  ///< Configuration with closed loops, nq entries

  /// Velocity, nv entries [rad/s, m/s]. Entries of passive joints matter only if the loops do not
  /// determine them.
  Eigen::VectorXd v;
  /// Acceleration, nv entries [rad/s^2, m/s^2]. Entries of passive joints matter only if the loops
  /// do not determine them.
  Eigen::VectorXd a;
  /// Contact forces, one entry per row of all contacts [N, Nm]. Entries of loops are not read.
  Eigen::VectorXd lambda;
};

/// Result of loop_inverse(): a motion that satisfies the loop constraints, with the torques and
/// forces that produce the motion.
struct LoopInverse {
  /// Velocity and acceleration, nv entries each. Driven joints move as requested, as far as the
  /// loops allow. The motion of passive joints follows from the driven joints.
  Eigen::VectorXd v, a;
  /// Torques, nv entries [Nm, N]. Zero at passive joints, up to `unbalanced`.
  Eigen::VectorXd tau;

  /// Contact forces, one entry per row of all contacts [N, Nm]. Forces of loops are computed; other
  /// forces are copied from the input.
  Eigen::VectorXd lambda;
  double unbalanced = 0.0;  ///< Largest torque that a passive joint would need [Nm, N]
  Status status = Status::Ok;
};

/// Computes the velocities and accelerations of the passive joints from the driven joints, then
/// torques and loop forces. A passive joint is a joint without a motor. If the torques are not
/// unique, the motor torques have the least norm. `dynamics` must belong to `model` with its loops,
/// and all contacts must be active. If the status is more severe than NotConverged, `tau` is empty.
/// Throws Error if `actuation` names an unknown joint.
LoopInverse loop_inverse(const Model& model, ContactDynamics& dynamics, const LoopMotion& motion,
                         const ActuationSpec& actuation = {});

}  // namespace burnish

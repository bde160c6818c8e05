// Inverse dynamics of robots with closed loops: from the motion of the motors to their torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

/// Motion of the driven joints, and forces at contacts other than loops.
struct LoopMotion {
  Eigen::VectorXd q;  ///< nq; the loops are closed
  /// nv; entries of passive joints count only where the loops leave them free [rad/s, m/s]
  Eigen::VectorXd v;
  Eigen::VectorXd a;       ///< nv, likewise [rad/s^2, m/s^2]
  Eigen::VectorXd lambda;  ///< rows of all contacts, those of loops are not read [N, Nm]
};

/// Motion that satisfies the loop constraints, and the torques and forces that produce it.
struct LoopInverse {
  /// nv: driven joints as requested, as far as the loops allow; passive ones follow from these
  Eigen::VectorXd v, a;
  Eigen::VectorXd tau;      ///< nv: zero at passive joints, up to `unbalanced` [Nm, N]
  Eigen::VectorXd lambda;   ///< rows of all contacts: loops computed, others as stated [N, Nm]
  double unbalanced = 0.0;  ///< largest torque that a passive joint would need [Nm, N]
  Status status = Status::Ok;
};

/// Computes velocities and accelerations of the passive joints (those without a motor) from the
/// driven ones, then torques and loop forces. If the torques are not unique, those of the motors
/// have the least norm. `dynamics`: of the model with its loops, all contacts active. On a status
/// above NotConverged `tau` is empty. Throws Error for an unknown joint of `actuation`.
LoopInverse loop_inverse(const Model& model, ContactDynamics& dynamics, const LoopMotion& motion,
                         const ActuationSpec& actuation = {});

}  // namespace burnish

// Inverse dynamics of robots with closed loops: from the motion of the motors to their torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "request.hpp"

namespace burnish::app {

/// Motion that satisfies the loop constraints, and the torques and forces that produce it.
struct LoopMotion {
  /// nv: driven joints as requested, as far as the loops allow; passive ones follow from these
  Eigen::VectorXd v, a;
  Eigen::VectorXd tau;      ///< nv: zero at passive joints, up to `unbalanced` [Nm, N]
  Eigen::VectorXd lambda;   ///< rows of all contacts: loops computed, others as stated [N, Nm]
  double unbalanced = 0.0;  ///< largest torque that a passive joint would need [Nm, N]
  Status status = Status::Ok;
};

/// Computes velocities and accelerations of the passive joints (those without a motor) from the
/// driven ones, then torques and loop forces. If the torques are not unique, those of the motors
/// have the least norm.
LoopMotion loop_motion(const EvalRequest& request, const EvalState& state,
                       ContactDynamics& dynamics);

}  // namespace burnish::app

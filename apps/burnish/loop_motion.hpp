// Inverse dynamics of robots whose loops close: from the motion of the motors to their torques.
#pragma once

#include "burnish/derivatives/contact_dynamics.hpp"
#include "request.hpp"

namespace burnish::app {

/// A motion that the loops allow, and what moves the robot so.
struct LoopMotion {
  Eigen::VectorXd v, a;  ///< nv: motors as asked for where the loops allow it, hinges as they must
  Eigen::VectorXd tau;   ///< nv: zero at joints without a motor [Nm, N]
  Eigen::VectorXd lambda;   ///< rows of all contacts: loops as found, others as stated [N, Nm]
  double unbalanced = 0.0;  ///< largest torque of a joint without a motor that nothing balances
  Status status = Status::Ok;
};

/// Velocities and accelerations of joints without a motor follow those of the motors. Of several
/// torques that move the robot so, those of the motors are the least ones.
LoopMotion loop_motion(const EvalRequest& request, const EvalState& state,
                       ContactDynamics& dynamics);

}  // namespace burnish::app

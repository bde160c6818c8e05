// Outer loop of the admittance controller: computes joint commands from the force error. The loop
// integrates its own model of the robot (the commanded robot), which has no noise and no lag.
#pragma once

#include <Eigen/Cholesky>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "dynamics/tree.hpp"

namespace burnish::pressing {

/// Desired joint positions and velocities.
struct JointCommand {
  Eigen::VectorXd q;  ///< Configuration (nq).
  Eigen::VectorXd v;  ///< Velocity (nv).
};

class AdmittanceLoop {
 public:
  /// `period`: time between two calls of step() [s]. Throws Error for an unknown frame.
  AdmittanceLoop(const Model& model, const PressingPath& path, const AdmittanceGains& gains,
                 double period);

  /// Resets the commanded robot to the configuration `q` at rest.
  Status reset(const Eigen::VectorXd& q) noexcept;
  /// Handles the first contact: clears the integral of the force error and stops the tool along the
  /// normal.
  void touch() noexcept;
  /// Advances the commanded robot by one period; command() then returns the command for the start
  /// of this period. `pressing`: true to control the force, false to control the speed of the
  /// approach. `may_integrate`: true if no torque is at its limit. `mass_matrix`: mass matrix of
  /// the robot, nv x nv. If the returned status is an error, the command is unchanged.
  Status step(const TaskPoint& target, const Eigen::Vector3d& force_world, bool pressing,
              bool may_integrate, const Eigen::MatrixXd& mass_matrix) noexcept;
  const JointCommand& command() const noexcept { return command_; }

 private:
  double inertia_along(const Eigen::Vector3d& n, const Eigen::MatrixXd& mass_matrix) noexcept;
  double normal_speed(const TaskPoint& target, double inertia, bool may_integrate) noexcept;
  void solve_joints(const Eigen::Vector3d& v_tool) noexcept;

  AdmittanceGains gains_;
  double period_, approach_speed_;
  Tree tree_;
  RigidBody body_;  ///< Commanded robot.
  int tool_;
  FrameDerivatives motion_;
  JointCommand command_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();  ///< Low-pass filtered force, world axes [N].
  double integral_ = 0.0;                            ///< Integral term of the force error [N].
  double speed_ = 0.0;                               ///< Speed along the normal [m/s].
  Eigen::VectorXd q_, zero_, posture_, velocity_limit_, homing_, step_, inverse_M_Jt_;
  Eigen::MatrixXd J_;
  Eigen::LLT<Eigen::Matrix3d> damped_;  ///< Factorization of J J^T + ik_damping^2 I.
  Eigen::LLT<Eigen::MatrixXd> factor_;  ///< Factorization of the mass matrix.
};

}  // namespace burnish::pressing

// The outer loop of a controller in two: force error in, joint positions out. It moves a robot of
// its own, the commanded one, which has no noise and no lag.
#pragma once

#include <Eigen/Cholesky>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "dynamics/tree.hpp"

namespace burnish::pressing {

/// Where the joints shall be, and how fast.
struct JointCommand {
  Eigen::VectorXd q;  ///< nq
  Eigen::VectorXd v;  ///< nv
};

class AdmittanceLoop {
 public:
  /// `period`: s, of its own. Throws Error for an unknown frame.
  AdmittanceLoop(const Model& model, const PressingPath& path, const AdmittanceGains& gains,
                 double period);

  /// Starts at a configuration, at rest.
  Status reset(const Eigen::VectorXd& q) noexcept;
  /// Contact was made: what was integrated is forgotten, and the tool stops along the normal.
  void touch() noexcept;
  /// One period further. `pressing`: the force counts, else the speed of the approach;
  /// `may_integrate`: no torque is at its limit; `mass_matrix`: nv x nv, of the robot. The command
  /// is that at its begin. Nothing happens unless the status is Ok.
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
  RigidBody body_;  ///< the commanded one
  int tool_;
  FrameDerivatives motion_;
  JointCommand command_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero();  ///< N, world, behind the low-pass
  double integral_ = 0.0;                            ///< N
  double speed_ = 0.0;                               ///< m/s, along the normal
  Eigen::VectorXd q_, zero_, posture_, velocity_limit_, homing_, step_, inverse_M_Jt_;
  Eigen::MatrixXd J_;
  Eigen::LLT<Eigen::Matrix3d> damped_;  ///< of J J^T + ik_damping^2
  Eigen::LLT<Eigen::MatrixXd> factor_;  ///< of the mass matrix
};

}  // namespace burnish::pressing

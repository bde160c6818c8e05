// Friction over one step: the impulses with which the velocity at its end obeys Coulomb's law.
#pragma once

#include <Eigen/Core>

#include "burnish/base/views.hpp"

namespace burnish {

/// Joints, one entry of v each, and two tangential directions of a point on a surface. With u = v +
/// W p the velocity at the end of the step: for every joint p in -h (viscous u + coulomb Sgn u),
/// for the point the same with its sliding velocity and a disc in place of the interval. Solved by
/// projected Gauss-Seidel, starting at the last impulses.
///
/// Nothing allocates after construction.
class CoulombStep {
 public:
  explicit CoulombStep(int nv);

  Eigen::VectorXd joint_viscous, joint_coulomb;  ///< nv: Nms/rad, Nm
  double tip_viscous = 0.0, tip_coulomb = 0.0;   ///< Ns/m, N: the largest sliding friction
  Eigen::MatrixXd tangents;                      ///< 2 x nv: Jacobian of the sliding velocity

  /// v_free (nv): velocity at the end of a step of h s without friction. A (nv x nv): acceleration
  /// per torque, symmetric. Fills torque() and sliding_force().
  void solve(const Eigen::VectorXd& v_free, const MatrixView& A, double h) noexcept;
  void reset() noexcept;
  /// The results of an earlier solve(), to start the next one at.
  void start_at(const ConstVectorRef& joint_torque, const Eigen::Vector2d& sliding_force,
                const ConstVectorRef& torque) noexcept {
    joint_torque_ = joint_torque;
    sliding_force_ = sliding_force;
    torque_ = torque;
  }

  const Eigen::VectorXd& torque() const { return torque_; }                ///< nv, joints and tip
  const Eigen::VectorXd& joint_torque() const { return joint_torque_; }    ///< nv, joints alone
  const Eigen::Vector2d& sliding_force() const { return sliding_force_; }  ///< N, on the tip

 private:
  double solve_joints(const MatrixView& A, double h) noexcept;
  double solve_tip(double h) noexcept;

  Eigen::VectorXd torque_, joint_torque_, u_;
  Eigen::Vector2d sliding_force_ = Eigen::Vector2d::Zero();
  Eigen::MatrixXd tip_response_;  ///< nv x 2: acceleration per sliding force
};

}  // namespace burnish

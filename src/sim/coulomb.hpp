// Coulomb friction over one time step of a plant, solved implicitly.
#pragma once

#include <Eigen/Core>

#include "burnish/base/views.hpp"

namespace burnish {

/// Friction in the joints, and friction of the tip on a surface. Friction impulses p change the
/// velocity v at the end of the step to u = v + W p. p and u satisfy Coulomb's law:
/// - For each entry of v, p is in -h (viscous u + coulomb Sgn u).
/// - For the tip, the law couples the two sliding velocities: a disc replaces the interval Sgn.
/// Projected Gauss-Seidel iterations solve these equations, starting from the impulses of the
/// previous step. Only the constructor allocates.
class CoulombStep {
 public:
  explicit CoulombStep(int nv);

  Eigen::VectorXd joint_viscous, joint_coulomb;  ///< Joint friction, nv entries [Nms/rad, Nm]
  double tip_viscous = 0.0;                      ///< Viscous friction of the tip [Ns/m]
  double tip_coulomb = 0.0;                      ///< Largest Coulomb friction of the tip [N]
  Eigen::MatrixXd tangents;                      ///< Jacobian of the sliding velocity, 2 x nv

  /// Computes torque() and sliding_force() for a time step of `h` [s]. `v_free`: velocity at the
  /// end of the step without friction (nv). `A`: acceleration per torque (nv x nv, symmetric).
  void solve(const Eigen::VectorXd& v_free, const MatrixView& A, double h) noexcept;
  /// Sets all results to zero.
  void reset() noexcept;
  /// Sets all results to those of an earlier solve(), as the starting point of the next solve().
  void start_at(const ConstVectorRef& joint_torque, const Eigen::Vector2d& sliding_force,
                const ConstVectorRef& torque) noexcept {
    joint_torque_ = joint_torque;
    sliding_force_ = sliding_force;
    torque_ = torque;
  }

  /// Returns the joint torques of all friction, nv entries [Nm or N].
  const Eigen::VectorXd& torque() const { return torque_; }
  /// Returns the joint torques of the friction in the joints themselves, nv entries [Nm or N].
  const Eigen::VectorXd& joint_torque() const { return joint_torque_; }
  /// Returns the friction force on the tip, along the two tangents [N].
  const Eigen::Vector2d& sliding_force() const { return sliding_force_; }

 private:
  double solve_joints(const MatrixView& A, double h) noexcept;
  double solve_tip(double h) noexcept;

  Eigen::VectorXd torque_, joint_torque_, u_;
  Eigen::Vector2d sliding_force_ = Eigen::Vector2d::Zero();
  Eigen::MatrixXd tip_response_;  ///< Acceleration per sliding force, nv x 2
};

}  // namespace burnish

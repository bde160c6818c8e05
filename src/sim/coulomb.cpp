#include "sim/coulomb.hpp"

#include <algorithm>
#include <cmath>

#include "sim/small_product.hpp"

namespace burnish {
namespace {

constexpr int max_sweeps = 100;      // largest number of Gauss-Seidel sweeps, chosen by hand
constexpr double tolerance = 1e-10;  // largest change of a force in the last sweep [Nm or N]

/// Returns the friction force for a motion whose speed at the end of the step would be `speed`
/// without friction. `w`: change of this speed per unit of force. The force stops the motion if
/// Coulomb friction is large enough.
double friction_against(double speed, double w, double viscous, double coulomb) {
  if (std::abs(speed) <= w * coulomb) return -speed / w;
  const double slowed = speed - std::copysign(w * coulomb, speed);
  return (slowed / (1.0 + w * viscous) - speed) / w;
}

}  // namespace

CoulombStep::CoulombStep(int nv)
    : joint_viscous(Eigen::VectorXd::Zero(nv)),
      joint_coulomb(Eigen::VectorXd::Zero(nv)),
      tangents(Eigen::MatrixXd::Zero(2, nv)),
      torque_(Eigen::VectorXd::Zero(nv)),
      joint_torque_(Eigen::VectorXd::Zero(nv)),
      u_(Eigen::VectorXd::Zero(nv)),
      tip_response_(Eigen::MatrixXd::Zero(nv, 2)) {}

void CoulombStep::reset() noexcept {
  torque_.setZero();
  joint_torque_.setZero();
  sliding_force_.setZero();
}

void CoulombStep::solve(const Eigen::VectorXd& v_free, const MatrixView& A, double h) noexcept {
  const bool slides = tip_viscous > 0.0 || tip_coulomb > 0.0;
  if (!slides) sliding_force_.setZero();
  multiply(A, tangents.transpose(), tip_response_);
  u_ = v_free;
  add_product(h, A, joint_torque_, u_);
  add_product(h, tip_response_, sliding_force_, u_);
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double change = solve_joints(A, h);
    if (slides) change = std::max(change, solve_tip(h));
    if (change < tolerance) break;
  }
  torque_ = joint_torque_;
  add_product(1.0, tangents.transpose(), sliding_force_, torque_);
}

double CoulombStep::solve_joints(const MatrixView& A, double h) noexcept {
  double largest = 0.0;
  for (Eigen::Index k = 0; k < u_.size(); ++k) {
    const double w = h * A(k, k);
    // A joint with w of zero is held by a contact, and does not move even without friction.
    if (joint_viscous[k] + joint_coulomb[k] == 0.0 || w < 1e-12) continue;
    const double without = u_[k] - w * joint_torque_[k];
    const double next = friction_against(without, w, joint_viscous[k], joint_coulomb[k]);
    const double change = next - joint_torque_[k];
    joint_torque_[k] = next;
    u_ += h * change * A.col(k);
    largest = std::max(largest, std::abs(change));
  }
  return largest;
}

/// Solves for the friction along both tangents together. In place of the 2 x 2 response matrix,
/// uses its larger eigenvalue, so that the friction is opposite to the sliding velocity.
double CoulombStep::solve_tip(double h) noexcept {
  Eigen::Matrix2d W = Eigen::Matrix2d::Zero();
  add_product(h, tangents, tip_response_, W);
  const double w = 0.5 * (W.trace() + std::hypot(W(0, 0) - W(1, 1), 2.0 * W(0, 1)));
  if (w < 1e-12) return 0.0;
  Eigen::Vector2d without = -w * sliding_force_;
  add_product(1.0, tangents, u_, without);
  const double speed = without.norm();
  Eigen::Vector2d next = Eigen::Vector2d::Zero();
  if (speed > 0.0) next = without / speed * friction_against(speed, w, tip_viscous, tip_coulomb);
  const Eigen::Vector2d change = next - sliding_force_;
  sliding_force_ = next;
  add_product(h, tip_response_, change, u_);
  return change.norm();
}

}  // namespace burnish

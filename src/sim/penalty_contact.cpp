#include "sim/penalty_contact.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// Returns the point of a disc about the origin that is nearest to f.
Eigen::Vector2d within(const Eigen::Vector2d& f, double radius) {
  const double length = f.norm();
  return length > radius ? Eigen::Vector2d(f * (radius / length)) : f;
}

}  // namespace

/// Solves for normal force and friction by projected Gauss-Seidel iterations, which alternate
/// between the two. The normal force is linear in the normal velocity. The friction makes a
/// gradient step against the remaining sliding velocity, and is then projected onto its disc.
Eigen::Vector3d penalty_force(const PenaltyContact& contact, const TipStep& tip) noexcept {
  if (!(tip.depth > 0.0)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d seed =
      std::abs(tip.n.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d axes;
  axes.col(2) = tip.n;
  axes.col(0) = seed.cross(tip.n).normalized();
  axes.col(1) = tip.n.cross(axes.col(0));
  const Eigen::Matrix3d A = axes.transpose() * tip.A * axes;
  const Eigen::Vector3d v = axes.transpose() * tip.v;
  // Normal force for stiffness K, damping D, and the normal velocity v_n at the end of the step:
  // f_n = K (depth - dt v_n) - D v_n.
  const double resistance = contact.stiffness * tip.dt + contact.damping;
  const double slope = 1.0 + resistance * tip.dt * A(2, 2);
  const Eigen::Matrix2d across = A.topLeftCorner<2, 2>();
  const double mean = 0.5 * across.trace();
  // Larger eigenvalue of `across`.
  const double largest = mean + std::hypot(0.5 * (across(0, 0) - across(1, 1)), across(0, 1));
  const double rate = 1.0 / std::max(tip.dt * largest, 1e-300);
  Eigen::Vector3d f = Eigen::Vector3d::Zero();
  constexpr int max_iterations = 200;  // chosen by hand
  for (int i = 0; i < max_iterations; ++i) {
    const Eigen::Vector3d before = f;
    const double free = v.z() + tip.dt * (A(2, 0) * f.x() + A(2, 1) * f.y());
    f.z() = std::max(0.0, (contact.stiffness * tip.depth - resistance * free) / slope);
    if (!(contact.friction > 0.0)) break;
    const Eigen::Vector2d slip = v.head<2>() + tip.dt * (A * f).head<2>();
    f.head<2>() = within(f.head<2>() - rate * slip, contact.friction * f.z());
    if ((f - before).norm() <= 1e-12 * (1.0 + f.norm())) break;
  }
  return axes * f;
}

}  // namespace burnish

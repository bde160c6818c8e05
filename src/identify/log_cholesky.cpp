#include "identify/log_cholesky.hpp"

#include <algorithm>
#include <cmath>

namespace burnish::identify_detail {
namespace {

/// Returns U without its factor e^alpha, where U U^T is the pseudo-inertia.
Eigen::Matrix4d root(const Vector10& eta) {
  Eigen::Matrix4d V = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i) V(i, i) = std::exp(eta[1 + i]);
  V(0, 1) = eta[4];
  V(1, 2) = eta[5];
  V(0, 2) = eta[6];
  V.block<3, 1>(0, 3) = eta.tail<3>();
  return V;
}

}  // namespace

Vector10 LogCholesky::of(const InertiaSpec& inertia) {
  // Lower limits of mass and radii of gyration, because the coordinates of a body without mass or
  // extent would be infinite. Smaller values do not matter.
  constexpr double min_mass = 1e-4, min_radius = 1e-3;  // [kg], [m]
  const double mass = std::max(inertia.mass, min_mass);
  const Eigen::Matrix3d I = inertia.inertia_at_com / mass;
  Eigen::Matrix3d S = 0.5 * I.trace() * Eigen::Matrix3d::Identity() - I;
  const double min_moment = min_radius * min_radius;
  Vector10 eta;
  eta[0] = 0.5 * std::log(mass);
  eta.tail<3>() = inertia.com;
  // Factors S = U3 U3^T with U3 upper triangular, from the last row up.
  const double u33 = std::sqrt(std::max(S(2, 2), min_moment));
  const double s13 = S(0, 2) / u33, s23 = S(1, 2) / u33;
  const double u22 = std::sqrt(std::max(S(1, 1) - s23 * s23, min_moment));
  const double s12 = (S(0, 1) - s13 * s23) / u22;
  const double u11 = std::sqrt(std::max(S(0, 0) - s12 * s12 - s13 * s13, min_moment));
  eta.segment<6>(1) << std::log(u11), std::log(u22), std::log(u33), s12, s23, s13;
  return eta;
}

Vector10 LogCholesky::parameters(const Vector10& eta) {
  const Eigen::Matrix4d V = root(eta);
  return parameters_of_pseudo_inertia(std::exp(2.0 * eta[0]) * V * V.transpose());
}

Matrix10 LogCholesky::derivative(const Vector10& eta) {
  const Eigen::Matrix4d V = root(eta);
  const double scale = std::exp(2.0 * eta[0]);
  Matrix10 D;
  D.col(0) = parameters_of_pseudo_inertia(2.0 * scale * V * V.transpose());
  constexpr int entries[9][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2},
                                 {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  for (int k = 0; k < 9; ++k) {
    const auto [i, j] = entries[k];
    Eigen::Matrix4d dV = Eigen::Matrix4d::Zero();
    dV(i, j) = i == j ? V(i, i) : 1.0;
    const Eigen::Matrix4d half = scale * dV * V.transpose();
    D.col(1 + k) = parameters_of_pseudo_inertia(half + half.transpose());
  }
  return D;
}

}  // namespace burnish::identify_detail

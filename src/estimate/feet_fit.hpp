// Where a unit is and how it moves by feet that stay where they were put down, and joints: without
// a gyroscope and an accelerometer.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimate/contact_filter.hpp"
#include "estimate/foot_kinematics.hpp"
#include "math/logarithm.hpp"

namespace burnish {

/// Rotation vectors, rad, to matrices and back.
inline Eigen::Matrix3d turned_by(const Eigen::Vector3d& turn) {
  const Vec3<double> phi = from_eigen(turn);
  return to_eigen(exp_matrix(phi, rotation_series(phi)));
}
inline Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
  double angle = 0.0;
  return to_eigen(log_rotation(from_eigen(R), angle));
}

/// The unit in the world.
struct UnitPose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// Feet that are put down stay: of a ball its place d_k, of a sole its rotation C_k too. Seen from
/// the unit at h_k with the rotation Q_k, they are fitted by
///   min sum |R h_k + p - d_k|^2 + length^2 sum over soles |log(C_k (R Q_k)^T)|^2.
/// Allocates nothing after construction.
class FeetFit {
 public:
  /// Per foot, whether it is a sole; m that a radian counts as.
  FeetFit(const std::vector<char>& soles, double length);

  /// Where they are seen from the unit.
  void put(FootSet feet, const UnitPose& unit, const std::vector<SeenFoot>& seen) noexcept;
  /// The unit, from nearby on. False, and nothing changes, where these feet leave it free.
  bool fit(FootSet feet, const std::vector<SeenFoot>& seen, UnitPose& unit) const noexcept;
  /// Its velocity and how it turns, in its own axes; false where these feet leave it free.
  bool fit_velocity(FootSet feet, const FootKinematics& kinematics, Eigen::Vector3d& v,
                    Eigen::Vector3d& w) const noexcept;
  /// How far a foot is from where it was put down, m and rad (of a ball 0).
  struct Apart {
    double place, turn;
  };
  Apart apart(int k, const SeenFoot& seen, const UnitPose& unit) const noexcept;
  /// Whether they say more than where the unit is: by the numbers that they are seen with.
  bool are_redundant(FootSet feet) const noexcept;
  Eigen::Vector3d middle(FootSet feet) const noexcept;  ///< of where they were put down

 private:
  struct Anchor {
    bool sole;
    Eigen::Vector3d d;
    Eigen::Matrix3d C;
  };
  std::vector<Anchor> feet_;
  double square_;  ///< of the length
};

}  // namespace burnish

// Pose and velocity of an inertial measurement unit (IMU) from standing feet and joints, without
// gyroscope and accelerometer.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimate/contact_filter.hpp"
#include "estimate/foot_kinematics.hpp"
#include "math/logarithm.hpp"

namespace burnish {

/// Converts a rotation vector [rad] to a rotation matrix, and back.
inline Eigen::Matrix3d turned_by(const Eigen::Vector3d& turn) {
  const Vec3<double> phi = from_eigen(turn);
  return to_eigen(exp_matrix(phi, rotation_series(phi)));
}
inline Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
  double angle = 0.0;
  return to_eigen(log_rotation(from_eigen(R), angle));
}

/// Pose of the IMU in the world.
struct UnitPose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
};

/// Least-squares fit of the IMU's pose to standing feet. Each foot keeps the position d_k at which
/// it was put down; a planar foot (sole) also keeps its rotation C_k. With h_k and Q_k, position
/// and rotation of the foot seen from the IMU, the pose (R, p) minimizes
///   sum |R h_k + p - d_k|^2 + length^2 sum over soles |log(C_k (R Q_k)^T)|^2.
/// Allocates nothing after construction.
class FeetFit {
 public:
  /// `soles`: one entry per foot, nonzero for a planar foot. `length`: weight of a rotation error
  /// [m/rad].
  FeetFit(const std::vector<char>& soles, double length);

  /// Records that feet are put down, at their present poses. `unit`: pose of the IMU; `seen`: poses
  /// of the feet, seen from the IMU.
  void put(FootSet feet, const UnitPose& unit, const std::vector<SeenFoot>& seen) noexcept;
  /// Fits the pose of the IMU to the feet. `unit`: initial guess near the result, replaced by the
  /// result. Returns false and leaves `unit` unchanged if the feet do not determine the pose.
  bool fit(FootSet feet, const std::vector<SeenFoot>& seen, UnitPose& unit) const noexcept;
  /// Fits the velocity v and the angular velocity w of the IMU to resting feet, in the axes of the
  /// IMU. Returns false if the feet do not determine them.
  bool fit_velocity(FootSet feet, const FootKinematics& kinematics, Eigen::Vector3d& v,
                    Eigen::Vector3d& w) const noexcept;
  /// Deviation of a foot from the pose at which it was put down: distance [m] and angle [rad]. The
  /// angle of a point foot is 0.
  struct Apart {
    double place, turn;
  };
  Apart apart(int k, const SeenFoot& seen, const UnitPose& unit) const noexcept;
  /// Returns true if the feet give more equations than the pose of the IMU needs.
  bool are_redundant(FootSet feet) const noexcept;
  /// Returns the mean of the positions at which feet were put down.
  Eigen::Vector3d middle(FootSet feet) const noexcept;

 private:
  struct Anchor {
    bool sole;
    Eigen::Vector3d d;
    Eigen::Matrix3d C;
  };
  std::vector<Anchor> feet_;
  double square_;  ///< Square of `length` [m^2/rad^2].
};

}  // namespace burnish

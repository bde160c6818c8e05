// Kinematics of feet relative to an inertial measurement unit (IMU), computed from joint readings.
// Jacobians convert encoder noise to noise of the feet.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"
#include "estimate/contact_filter.hpp"

namespace burnish {

/// Rotation and position of a frame.
template <class S>
struct FramePose {
  Mat3<S> R;
  Vec3<S> p;
};
/// Returns the pose of a frame, in the world of `kinematics`.
template <class S>
FramePose<S> pose_of(const CompiledFrame& frame, const Kinematics<S>& kinematics) {
  const BodyState<S>& body = kinematics.bodies[to_size(frame.body)];
  return {body.R * lift<S>(frame.R), body.p + body.R * lift<S>(frame.p)};
}
/// Returns the frame `other` relative to the frame `pose`: R^T R_other, R^T (p_other - p).
template <class S>
FramePose<S> seen_from(const FramePose<S>& pose, const FramePose<S>& other) {
  return {transpose_times(pose.R, other.R), transpose_times(pose.R, other.p - pose.p)};
}

/// Kinematics of the feet of a robot whose first joint is its floating base. Allocates nothing
/// after construction.
class FootKinematics {
 public:
  /// `unit`: frame of the IMU; empty: the body of the floating base. Throws Error for frames that
  /// are unknown or fixed to the world, and for a robot with a fixed base.
  FootKinematics(const Model& model, const std::string& unit, const std::vector<std::string>& feet);

  /// Updates the kinematics to the joint readings q (nq) and v (nv), whose entries for the base are
  /// ignored. If the readings are those of the last update, nothing is computed again. Returns Ok,
  /// or an error (WrongSize, NotFinite, NotNormalized) that leaves the kinematics unchanged.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

  int feet() const { return static_cast<int>(feet_.size()); }
  /// Returns the pose of a foot seen from the IMU.
  const SeenFoot& seen(int foot) const { return seen_[to_size(foot)]; }
  const std::vector<SeenFoot>& all_seen() const { return seen_; }
  /// Returns the velocity of the foot's origin relative to the IMU, in the axes of the IMU [m/s].
  const Vec3<double>& velocity(int foot) const { return velocities_[to_size(foot)]; }
  /// Returns the angular velocity of the foot relative to the IMU, in the axes of the IMU [rad/s].
  const Vec3<double>& turning(int foot) const { return turnings_[to_size(foot)]; }
  /// Returns the Jacobian d(p, theta)/d(q) of a foot's pose seen from the IMU, in the axes of the
  /// IMU. It has 6 rows and one column for each entry of v in columns().
  Eigen::MatrixXd::ConstRowsBlockXpr jacobian(int foot) const {
    return jacobian_.middleRows(6 * foot, 6);
  }
  const std::vector<int>& columns() const { return columns_; }

  /// Returns the pose of the IMU in the axes of the base's body. unit_in_base_velocity() returns
  /// the twist of the IMU relative to the base, at the IMU's origin.
  const FramePose<double>& unit_in_base() const { return unit_in_base_; }
  const Motion<double>& unit_in_base_velocity() const { return unit_in_base_velocity_; }
  /// Returns the pose of the frame of the floating-base joint in the world.
  const FramePose<double>& base_joint() const { return base_joint_; }
  const Tree& tree() const { return tree_; }

 private:
  void update_jacobian(int foot) noexcept;

  Tree tree_;
  CompiledFrame unit_;
  std::vector<CompiledFrame> feet_;
  Kinematics<double> kinematics_;
  Eigen::VectorXd q_, v_;
  std::vector<int> columns_, column_of_v_;
  FramePose<double> base_joint_, unit_in_base_, unit_pose_;
  Motion<double> unit_in_base_velocity_;
  std::vector<SeenFoot> seen_;
  std::vector<Vec3<double>> velocities_, turnings_;
  Eigen::MatrixXd jacobian_;
  bool is_updated_ = false;  ///< True after the first update.
};

}  // namespace burnish

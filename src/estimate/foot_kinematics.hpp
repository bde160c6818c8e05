// Where feet are, seen from an inertial measurement unit, by joints alone, and what noise of the
// encoders does to it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"
#include "estimate/contact_filter.hpp"

namespace burnish {

/// R and p of a frame.
template <class S>
struct FramePose {
  Mat3<S> R;
  Vec3<S> p;
};
/// In the world of the kinematics.
template <class S>
FramePose<S> pose_of(const CompiledFrame& frame, const Kinematics<S>& kinematics) {
  const BodyState<S>& body = kinematics.bodies[static_cast<std::size_t>(frame.body)];
  return {body.R * lift<S>(frame.R), body.p + body.R * lift<S>(frame.p)};
}
/// `other` in `pose`: R^T R_other, R^T (p_other - p).
template <class S>
FramePose<S> seen_from(const FramePose<S>& pose, const FramePose<S>& other) {
  return {transpose_times(pose.R, other.R), transpose_times(pose.R, other.p - pose.p)};
}

/// Of a robot whose first joint is its floating base; allocates nothing after construction.
class FootKinematics {
 public:
  /// `unit`: frame of the measurement unit, empty for the body of the floating base. Throws Error
  /// for frames that are unknown or fixed to the world, and for a robot without a floating base.
  FootKinematics(const Model& model, const std::string& unit, const std::vector<std::string>& feet);

  /// q: nq, v: nv; entries of the base are passed over. WrongSize, NotFinite, NotNormalized or Ok;
  /// unless Ok nothing changes.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;

  int feet() const { return static_cast<int>(feet_.size()); }
  /// The foot seen from the unit.
  const SeenFoot& seen(int foot) const { return seen_[static_cast<std::size_t>(foot)]; }
  const std::vector<SeenFoot>& all_seen() const { return seen_; }
  /// Velocity of the foot's origin seen from the unit, m/s, its axes.
  const Vec3<double>& velocity(int foot) const {
    return velocities_[static_cast<std::size_t>(foot)];
  }
  /// How the foot turns seen from the unit, rad/s, its axes.
  const Vec3<double>& turning(int foot) const { return turnings_[static_cast<std::size_t>(foot)]; }
  /// d(p, theta)/d(q) of the foot seen from the unit, both in its axes: 6 rows, a column for each
  /// entry of v in columns().
  Eigen::MatrixXd::ConstRowsBlockXpr jacobian(int foot) const {
    return jacobian_.middleRows(6 * foot, 6);
  }
  const std::vector<int>& columns() const { return columns_; }

  /// The unit in the axes of the base's body, and its twist there (at the unit's origin) where the
  /// base rests.
  const FramePose<double>& unit_in_base() const { return unit_in_base_; }
  const Motion<double>& unit_in_base_velocity() const { return unit_in_base_velocity_; }
  /// The base's joint before it moves: world to the joint's frame.
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
};

}  // namespace burnish

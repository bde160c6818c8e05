#include "mpc/sole_limits.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {
namespace {

/// Returns the smallest and the largest moment about a joint axis `a` due to a force of 1 N upwards
/// at a corner of the sole [m]. `R`: axes of the sole's frame. `at_origin`: moment of the force at
/// the origin of the frame [m].
std::pair<double, double> moments_of_corners(const SoleLimits::Sole& sole, const Eigen::Matrix3d& R,
                                             const Eigen::Vector3d& a, double at_origin) {
  double lower = at_origin, upper = at_origin;
  for (const double x : {-sole.half_x, sole.half_x})
    for (const double y : {-sole.half_y, sole.half_y}) {
      const double moment = at_origin + a.cross(R * Eigen::Vector3d(x, y, 0.0)).z();
      lower = std::min(lower, moment);
      upper = std::max(upper, moment);
    }
  return {lower, upper};
}

}  // namespace

SoleLimits::SoleLimits(const Model& model, const Eigen::VectorXd& q, const std::vector<Sole>& soles,
                       double stiffness) {
  if (soles.empty() || !model.loops.empty()) return;
  // Limits, chosen by hand.
  // - `near`: largest distance of an ankle from its sole, relative to the height of the centre of
  //   mass.
  // - `upright`: largest cosine between ankle axis and vertical, to exclude yaw joints, which do
  //   not move the centre of pressure.
  // - `stretch`: spring deflection whose torque is allowed for a foot without load [rad].
  constexpr double near = 0.3;
  constexpr double upright = 0.8;
  constexpr double stretch = 1.0;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  RigidBody body(model);
  ContactDynamics open(model);
  if (!is_usable(body.update(q, rest)) || !is_usable(open.forward(q, rest, rest))) return;
  FrameDerivatives motion;
  for (const Sole& sole : soles) {
    const int frame = body.frame(sole.frame);
    const Eigen::Isometry3d at = body.placement(frame);
    body.frame_derivatives(frame, Reference::centered(), motion);
    const Frame& foot = model.frames[to_size(model.frame_index(sole.frame))];
    int joint = foot.body;
    for (; joint >= 0; joint = model.joints[to_size(joint)].parent) {
      const Joint& one = model.joints[to_size(joint)];
      if (one.nv != 1 || one.kind == JointKind::Prismatic) break;
      const Eigen::Vector3d a = motion.jacobian.col(one.v_index).tail<3>();
      const Eigen::Vector3d linear = motion.jacobian.col(one.v_index).head<3>();
      // Stops at a joint whose axis is too far from the sole. The length of `linear` is the
      // distance between them.
      if (linear.norm() > near * (body.com().z() - at.translation().z())) break;
      if (std::abs(a.z()) > upright) continue;
      const auto [lower, upper] = moments_of_corners(sole, at.linear(), a, linear.z());
      ankles_.push_back({one.v_index, sole.sensor, -upper, -lower,
                         stretch * stiffness * open.mass_matrix()(one.v_index, one.v_index)});
    }
  }
}

void SoleLimits::keep(const Wrenches& wrenches, Eigen::VectorXd& tau) const noexcept {
  for (const Ankle& ankle : ankles_) {
    if (ankle.sensor >= wrenches.cols()) return;
    const double load = wrenches.col(ankle.sensor).head<3>().norm();
    if (!std::isfinite(load)) continue;
    const double lower = std::min(0.0, load * ankle.lower) - ankle.hanging;
    const double upper = std::max(0.0, load * ankle.upper) + ankle.hanging;
    tau[ankle.entry] = std::clamp(tau[ankle.entry], lower, upper);
  }
}

}  // namespace burnish

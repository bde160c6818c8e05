#include "mpc/sole_limits.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"

namespace burnish {
namespace {

const residual::CenterOfPressure* sole_of(const MpcSpec& spec, const std::string& contact) {
  if (spec.problem.stages.empty()) return nullptr;
  for (const Constraint& rows : spec.problem.stages.front().constraints)
    if (const auto* sole = std::get_if<residual::CenterOfPressure>(&rows.residual))
      if (sole->contact == contact) return sole;
  return nullptr;
}

/// Least and most moment about a joint's axis `a` by 1 N upwards at the corners of the sole, whose
/// frame has the axes R; `at_origin`: by 1 N at its origin [m].
std::pair<double, double> moments_of_corners(const residual::CenterOfPressure& sole,
                                             const Eigen::Matrix3d& R, const Eigen::Vector3d& a,
                                             double at_origin) {
  double least = at_origin, most = at_origin;
  for (const double x : {-sole.half_x, sole.half_x})
    for (const double y : {-sole.half_y, sole.half_y}) {
      const double moment = at_origin + a.cross(R * Eigen::Vector3d(x, y, 0.0)).z();
      least = std::min(least, moment);
      most = std::max(most, moment);
    }
  return {least, most};
}

}  // namespace

SoleLimits::SoleLimits(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  if (!spec.support_sensors || !model.loops.empty()) return;
  constexpr double near =
      0.3;  // of the height of the centre of mass, that an ankle is off its sole
  constexpr double upright = 0.8;  // cosine: axes of the yaw of a foot move no pressure
  constexpr double stretch = 1.0;  // rad, that a foot which hangs may be off
  const Eigen::VectorXd q = spec.problem.initial_state.head(model.nq);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  RigidBody body(model);
  ContactDynamics open(model);
  if (body.update(q, rest) > Status::NotConverged ||
      open.forward(q, rest, rest) > Status::NotConverged)
    return;
  FrameDerivatives motion;
  for (std::size_t i = 0; i < spec.supports.size(); ++i) {
    const auto contact =
        std::find_if(spec.problem.contacts.begin(), spec.problem.contacts.end(),
                     [&](const ContactSpec& known) { return known.name == spec.supports[i]; });
    const auto* sole =
        contact == spec.problem.contacts.end() ? nullptr : sole_of(spec, contact->name);
    if (sole == nullptr) continue;
    const int frame = body.frame(contact->tool);
    const Eigen::Isometry3d at = body.placement(frame);
    body.frame_derivatives(frame, Reference::centered(), motion);
    const Frame& foot = model.frames[static_cast<std::size_t>(model.frame_index(contact->tool))];
    int joint = foot.body;
    for (; joint >= 0; joint = model.joints[static_cast<std::size_t>(joint)].parent) {
      const Joint& one = model.joints[static_cast<std::size_t>(joint)];
      if (one.nv != 1 || one.kind == JointKind::Prismatic) break;
      const Eigen::Vector3d a = motion.jacobian.col(one.v_index).tail<3>();
      const Eigen::Vector3d linear = motion.jacobian.col(one.v_index).head<3>();
      // Across the axis, the joint is so far from the sole.
      if (linear.norm() > near * (body.com().z() - at.translation().z())) break;
      if (std::abs(a.z()) > upright) continue;
      const auto [least, most] = moments_of_corners(*sole, at.linear(), a, linear.z());
      ankles_.push_back(
          {one.v_index, static_cast<Eigen::Index>(i), -most, -least,
           stretch * spec.fallback.stiffness * open.mass_matrix()(one.v_index, one.v_index)});
    }
  }
}

void SoleLimits::keep(const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
                      Eigen::VectorXd& tau) const noexcept {
  for (const Ankle& ankle : ankles_) {
    if (ankle.sensor >= wrenches.cols()) return;
    const double load = wrenches.col(ankle.sensor).head<3>().norm();
    if (!std::isfinite(load)) continue;
    const double least = std::min(0.0, load * ankle.least) - ankle.hanging;
    const double most = std::max(0.0, load * ankle.most) + ankle.hanging;
    tau[ankle.entry] = std::clamp(tau[ankle.entry], least, most);
  }
}

}  // namespace burnish

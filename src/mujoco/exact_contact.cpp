#include "mujoco/exact_contact.hpp"

namespace burnish::mujoco {

ExactContact::ExactContact(const TouchSpec& touch, const TouchIds& ids, const mjModel& m)
    : touch_(touch),
      surface_(surface_of(touch.surface)),
      contact_{touch.surface.stiffness, touch.surface.damping, touch.surface.friction},
      ids_(ids),
      J_(3, m.nv),
      J_surface_(3, ids.surface_site < 0 ? 0 : m.nv),
      J_by_M_(3, m.nv) {
  J_.setZero();
  J_surface_.setZero();
  J_by_M_.setZero();
}

Vector6 ExactContact::apply_force(const mjModel& m, mjData& d, double time, bool touched) noexcept {
  using Axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
  const double dt = m.opt.timestep;
  const SurfaceMotion& motion = touch_.surface.motion;
  const double moved = motion.displacement(time);
  const Eigen::Vector3d& along = touch_.surface.normal;
  const Eigen::Vector3d tip_world = Eigen::Map<const Eigen::Vector3d>(d.site_xpos + 3 * ids_.site);
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // the surface's axes in the world
  Eigen::Vector3d tip = tip_world;
  if (ids_.surface_site >= 0) {
    R = Axes(d.site_xmat + 9 * ids_.surface_site);
    tip = R.transpose() *
          (tip_world - Eigen::Map<const Eigen::Vector3d>(d.site_xpos + 3 * ids_.surface_site));
  }
  tip -= moved * along;  // position relative to the moved surface
  const SurfaceDistance at = surface_.at(tip);
  const double radius = touch_.radius;
  if (!(at.distance < radius) || !is_over(touch_, tip, touched)) return Vector6::Zero();
  const Eigen::Vector3d n = R * at.normal;
  const Eigen::Vector3d point = tip_world - radius * n;
  mj_jac(&m, &d, J_.data(), nullptr, point.data(), ids_.body);
  if (ids_.surface_site >= 0) {
    mj_jac(&m, &d, J_surface_.data(), nullptr, point.data(), m.site_bodyid[ids_.surface_site]);
    J_ -= J_surface_;
  }
  mj_solveM(&m, &d, J_by_M_.data(), J_.data(), 3);
  const Eigen::Map<const Eigen::VectorXd> v(d.qvel, m.nv), a(d.qacc_smooth, m.nv);
  // Approximates the forces of joint friction and followers by their values in the previous step.
  const Eigen::Map<const Eigen::VectorXd> others(d.qfrc_constraint, m.nv);
  TipStep step{.dt = dt, .depth = radius - at.distance, .n = n, .v = {}, .A = {}};
  step.v = J_ * v + dt * (J_ * a + J_by_M_ * others) -
           (motion.displacement(time + dt) - moved) / dt * (R * along);
  step.A = J_by_M_ * J_.transpose();
  const Eigen::Vector3d force = penalty_force(contact_, step);
  Eigen::Map<Eigen::VectorXd>(d.qfrc_applied, m.nv).noalias() += J_.transpose() * force;
  Eigen::Map<Eigen::VectorXd>(d.qfrc_smooth, m.nv).noalias() += J_.transpose() * force;
  Eigen::Map<Eigen::VectorXd>(d.qacc_smooth, m.nv).noalias() += J_by_M_.transpose() * force;
  Vector6 wrench_world;
  wrench_world << force, (point - tip_world).cross(force);
  return wrench_world;
}

}  // namespace burnish::mujoco

#include "estimate/tool_friction.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Tuning constants, chosen by hand.
constexpr double sliding_speed = 0.02;  // speed below which the friction fades out [m/s]
constexpr double until_torques = 2e-3;  // assumed time from a measurement until torques act [s]
constexpr double since_forces = 3e-3;   // assumed delay of force sensors with their filters [s]

}  // namespace

ToolFriction::ToolFriction(const ToolFrictionSpec& spec, int nv)
    : spec_(spec),
      smoothing_(spec.plan_lead + spec.times.solver_delay + 0.5 * spec.times.update_period -
                 until_torques),
      v_ahead_(Eigen::VectorXd::Zero(nv)) {
  if (spec.coefficient) coefficient_.emplace(*spec.coefficient);
}

void ToolFriction::reset() noexcept {
  v_ahead_.setZero();
  pressed_ = ratio_ = 0.0;
  for (Eigen::Vector3d* vector : {&unmodelled_, &ahead_, &between_, &v_tool_, &slid_})
    vector->setZero();
  if (coefficient_) coefficient_->reset();
}

void ToolFriction::update(const RigidBody& body, const ToolMotion& motion, const ToolForce& tool,
                          double target, double dt) noexcept {
  const double weight = -std::expm1(-spec_.bandwidth * dt);
  pressed_ += weight * (tool.normal() - pressed_);
  const Eigen::Vector3d across = tool.force_world - tool.normal() * tool.normal_world;
  const Eigen::Vector3d explained =
      coefficient_ ? modelled(motion.velocity(body), tool, across, dt) : Eigen::Vector3d::Zero();
  unmodelled_ += weight * (across - explained - unmodelled_);
  // The part of a tangential force that exceeds the normal force does not count as friction.
  ratio_ = presses() ? std::max(target, 0.0) / std::max(pressed_, unmodelled_.norm()) : 0.0;
  ahead_ = along_plan(motion, tool.normal_world, dt);
}

/// Returns the estimated friction, rotated from the past to the future sliding direction. The
/// estimate is old by the delay of the force filters and by the time until torques act. The part
/// along the past sliding direction is therefore rotated to the direction in which the tool will
/// slide. Both directions come from planned velocities; the past one is delayed like the force.
/// Measured velocities would close a loop through friction. `n`: unit normal of the surface.
Eigen::Vector3d ToolFriction::along_plan(const ToolMotion& motion, const Eigen::Vector3d& n,
                                         double dt) noexcept {
  if (coefficient_) return unmodelled_;  // plans already contain the change of direction
  // Lower bound of |slid_|^2. A smaller |slid_| belongs to a slow motion, in which the direction of
  // friction is uncertain.
  constexpr double min_squared_slide = 0.25;
  const double weight = -std::expm1(-2.0 * dt / smoothing_);
  between_ += weight * (motion.jacobian() * v_ahead_ - between_);
  v_tool_ += weight * (between_ - v_tool_);
  const Eigen::Vector3d will_slide = sliding_direction(v_tool_ - n * n.dot(v_tool_), sliding_speed);
  const double nominal_delay = spec_.times.command_delay + spec_.times.measurement_delay;
  const double delay = until_torques + since_forces + nominal_delay + 1.0 / spec_.bandwidth;
  slid_ += -std::expm1(-dt / delay) * (will_slide - slid_);
  const double along = std::max(0.0, -unmodelled_.dot(slid_)) /
                       std::max(slid_.squaredNorm(), min_squared_slide);  // friction [N]
  return unmodelled_ - along * (will_slide - slid_);
}

/// Returns the part of the force along the surface that the friction model of the contacts explains
/// [N]. Plans already contain this part. When the coefficient changes, unmodelled_ is corrected so
/// that its sum with the explained part stays the same. `v_tool`: velocity of the tool relative to
/// the surface, in world axes [m/s]. `across`: force along the surface [N].
Eigen::Vector3d ToolFriction::modelled(const Eigen::Vector3d& v_tool, const ToolForce& tool,
                                       const Eigen::Vector3d& across, double dt) noexcept {
  const double force = tool.normal();
  const Eigen::Vector3d v_across = v_tool - tool.normal_world * tool.normal_world.dot(v_tool);
  const Eigen::Vector3d s = sliding_direction(v_across, spec_.planned_speed);
  const double before = coefficient_->coefficient();
  if (presses()) coefficient_->update(force, across, v_across, dt);
  unmodelled_ += (coefficient_->coefficient() - before) * pressed_ * s;
  return -coefficient_->coefficient() * force * s;
}

}  // namespace burnish

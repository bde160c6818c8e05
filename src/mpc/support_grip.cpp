#include "mpc/support_grip.hpp"

#include <algorithm>
#include <cmath>

#include "mpc/closed_dynamics.hpp"
#include "mpc/ground_terms.hpp"

namespace burnish {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the response of a first-order low-pass filter to a unit step after `dt` [s]. It is 1 for
/// a time constant of 0 (no filter).
double low_pass_weight(double dt, double over) {
  return over > 0.0 ? -std::expm1(-dt / over) : 1.0;
}

}  // namespace

SupportGrip::SupportGrip(const MpcSpec& spec)
    : options_(spec.slip),
      allowed_(spec.limits.support_slip),
      up_(-spec.problem.model.gravity.normalized()) {
  const RigidBody body(spec.problem.model);
  for (const ContactSpec& contact : supports_of(spec)) {
    Support support{};
    support.name = contact.name;
    support.frame = body.frame(contact.tool);
    const auto at = std::find(spec.supports.begin(), spec.supports.end(), contact.name);
    support.sensor = spec.support_sensors ? static_cast<int>(at - spec.supports.begin()) : -1;
    const GroundFigures figures = ground_figures(spec.problem, contact.name);
    support.cone = figures.friction;
    support.half_x = figures.half_x;
    support.half_y = figures.half_y;
    supports_.push_back(support);
  }
  friction_.resize(static_cast<Eigen::Index>(supports_.size()));
  reset();
}

void SupportGrip::reset() noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    supports_[i].speed = supports_[i].distance = 0.0;
    supports_[i].slid.setZero();
    friction_[static_cast<Eigen::Index>(i)] = supports_[i].cone;
  }
}

std::size_t SupportGrip::longest_name() const {
  std::size_t max_length = 0;
  for (const Support& support : supports_) max_length = std::max(max_length, support.name.size());
  return max_length;
}

/// Updates displacement and speed of a support along the ground. For a spherical foot, uses the
/// lowest point of the sphere.
void SupportGrip::follow(Support& support, const MeasurementGate& gate) const noexcept {
  constexpr double memory = 1.0, brief = 5e-3;  // time constants of displacement and speed [s]
  const Vector6 v = gate.body().velocity(support.frame, Reference::centered());
  Eigen::Vector3d slides = v.head<3>() - options_.radius * v.tail<3>().cross(up_);
  slides -= up_ * up_.dot(slides);
  support.slid += gate.dt() * slides - low_pass_weight(gate.dt(), memory) * support.slid;
  support.distance = support.slid.norm();
  support.speed += low_pass_weight(gate.dt(), brief) * (slides.norm() - support.speed);
}

/// Returns the coefficient of friction that the measured wrench requires, due to forces along the
/// ground and, for soles, the yaw moment. The conditions for soles are those in
/// residual::CenterOfPressure.
double SupportGrip::required_friction(const Support& support,
                                      const Eigen::Matrix<double, 6, 1>& wrench,
                                      const Eigen::Matrix3d& R, double load) const noexcept {
  const Eigen::Vector3d force_world = R * wrench.head<3>();
  double required = (force_world - up_ * up_.dot(force_world)).norm() / load;
  if (support.half_x == 0.0) return required;
  for (const double side : {1.0, -1.0})
    for (const double by_x : {1.0, -1.0})
      for (const double by_y : {1.0, -1.0}) {
        const double normal = (support.half_x + support.half_y) * wrench[2] +
                              side * (by_x * wrench[3] + by_y * wrench[4]);
        const double tangential = by_x * support.half_y * wrench[0] +
                                  by_y * support.half_x * wrench[1] - side * wrench[5];
        // A corner with hardly any load is skipped, because its ratio is meaningless.
        if (normal > 0.1 * support.half_y * load)
          required = std::max(required, tangential / normal);
      }
  return required;
}

void SupportGrip::update_friction(const Support& support, const MeasurementGate& gate,
                                  double& friction) const noexcept {
  const double dt = gate.dt();
  const Eigen::Matrix3d R = gate.body().placement(support.frame).linear();
  double load = infinite, slip_friction = 0.0, easing = 2.0 * options_.easing;
  if (support.sensor >= 0) {
    const auto wrench = gate.last().support_wrenches.col(support.sensor);
    load = up_.dot(R * wrench.head<3>());
    if (load > options_.load)
      slip_friction = options_.friction_fraction * required_friction(support, wrench, R, load);
    easing = options_.easing;
  }
  const bool slips = load > options_.load && support.distance > options_.distance &&
                     support.speed > options_.speed;
  if (slips)
    friction += low_pass_weight(dt, easing) * (std::min(friction, slip_friction) - friction);
  else
    friction = std::min(support.cone, friction + options_.recovery * dt);
  friction = std::max(friction, std::min(support.cone, options_.min_friction));
}

void SupportGrip::update(const MeasurementGate& gate) noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    follow(supports_[i], gate);
    if (options_.enabled && std::isfinite(supports_[i].cone))
      update_friction(supports_[i], gate, friction_[static_cast<Eigen::Index>(i)]);
  }
}

void SupportGrip::watch(double now, FaultLatch& latch) const noexcept {
  for (const Support& support : supports_)
    if (support.distance > allowed_ &&
        latch.raise(now, FaultKind::SupportSlipped, support.distance, allowed_))
      latch.report.quantity = support.name;  // does not allocate: memory is reserved
}

}  // namespace burnish

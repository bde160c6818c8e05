#include "estimate/support_grip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the response of a first-order low-pass filter to a unit step after `dt` [s]. `over`:
/// time constant [s]; 0: no filter, response 1.
double low_pass_weight(double dt, double over) {
  return over > 0.0 ? -std::expm1(-dt / over) : 1.0;
}

}  // namespace

SupportGrip::SupportGrip(const Model& model, const std::vector<GripSpec>& supports,
                         const SlipOptions& options)
    : options_(options), up_(-model.gravity.normalized()) {
  const RigidBody body(model);
  for (const GripSpec& support : supports)
    supports_.push_back({support, body.frame(support.frame), Eigen::Vector3d::Zero(), 0.0, 0.0});
  friction_.resize(static_cast<Eigen::Index>(supports_.size()));
  reset();
}

void SupportGrip::reset() noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    supports_[i].speed = supports_[i].distance = 0.0;
    supports_[i].slid.setZero();
    friction_[static_cast<Eigen::Index>(i)] = supports_[i].friction;
  }
}

/// Updates displacement and speed of a support along the ground. For a spherical foot, uses the
/// lowest point of the sphere.
void SupportGrip::follow(Support& support, const RigidBody& body, double dt) const noexcept {
  constexpr double memory = 1.0, brief = 5e-3;  // time constants of displacement and speed [s]
  const Vector6 v = body.velocity(support.index, centered_);
  Eigen::Vector3d slides = v.head<3>() - options_.radius * v.tail<3>().cross(up_);
  slides -= up_ * up_.dot(slides);
  support.slid += dt * slides - low_pass_weight(dt, memory) * support.slid;
  support.distance = support.slid.norm();
  support.speed += low_pass_weight(dt, brief) * (slides.norm() - support.speed);
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
        // Skips a corner with hardly any load, because its ratio of forces is meaningless.
        if (normal > 0.1 * support.half_y * load)
          required = std::max(required, tangential / normal);
      }
  return required;
}

double SupportGrip::updated_friction(const Support& support, const RigidBody& body,
                                     const Wrenches& wrenches, double dt,
                                     double friction) const noexcept {
  const Eigen::Matrix3d R = body.placement(support.index).linear();
  double load = infinite, slip_friction = 0.0, easing = 2.0 * options_.easing;
  if (support.sensor >= 0) {
    const auto wrench = wrenches.col(support.sensor);
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
    friction = std::min(support.friction, friction + options_.recovery * dt);
  return std::max(friction, std::min(support.friction, options_.min_friction));
}

void SupportGrip::update(const RigidBody& body, const Wrenches& wrenches, double dt) noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    follow(supports_[i], body, dt);
    double& friction = friction_[static_cast<Eigen::Index>(i)];
    if (options_.enabled && std::isfinite(supports_[i].friction))
      friction = updated_friction(supports_[i], body, wrenches, dt, friction);
  }
}

}  // namespace burnish

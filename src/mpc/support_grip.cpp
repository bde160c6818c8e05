#include "mpc/support_grip.hpp"

#include <algorithm>
#include <cmath>

#include "mpc/closed_dynamics.hpp"
#include "mpc/ground_terms.hpp"

namespace burnish {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Part of the way that a first-order low-pass goes in a time.
double part(double dt, double over) { return over > 0.0 ? -std::expm1(-dt / over) : 1.0; }

}  // namespace

SupportGrip::SupportGrip(const MpcSpec& spec)
    : options_(spec.slip),
      allowed_(spec.limits.support_way),
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
    supports_[i].speed = supports_[i].way = 0.0;
    supports_[i].slid.setZero();
    friction_[static_cast<Eigen::Index>(i)] = supports_[i].cone;
  }
}

std::size_t SupportGrip::longest_name() const {
  std::size_t longest = 0;
  for (const Support& support : supports_) longest = std::max(longest, support.name.size());
  return longest;
}

/// How far it has slid, and how fast it goes on, both along the ground: at the lowest point of a
/// ball.
void SupportGrip::follow(Support& support, const MeasurementGate& gate) const noexcept {
  constexpr double memory = 1.0, brief = 5e-3;  // s
  const Vector6 v = gate.body().velocity(support.frame, Reference::centered());
  Eigen::Vector3d slides = v.head<3>() - options_.radius * v.tail<3>().cross(up_);
  slides -= up_ * up_.dot(slides);
  support.slid += gate.dt() * slides - part(gate.dt(), memory) * support.slid;
  support.way = support.slid.norm();
  support.speed += part(gate.dt(), brief) * (slides.norm() - support.speed);
}

/// The coefficient of friction that what it bears takes: along the ground, and of a sole about its
/// normal too, as the rows of residual::CenterOfPressure have it.
double SupportGrip::felt(const Support& support, const Eigen::Matrix<double, 6, 1>& wrench,
                         const Eigen::Matrix3d& R, double load) const noexcept {
  const Eigen::Vector3d force_world = R * wrench.head<3>();
  double most = (force_world - up_ * up_.dot(force_world)).norm() / load;
  if (support.half_x == 0.0) return most;
  for (const double side : {1.0, -1.0})
    for (const double by_x : {1.0, -1.0})
      for (const double by_y : {1.0, -1.0}) {
        const double bears = (support.half_x + support.half_y) * wrench[2] +
                             side * (by_x * wrench[3] + by_y * wrench[4]);
        const double takes = by_x * support.half_y * wrench[0] + by_y * support.half_x * wrench[1] -
                             side * wrench[5];
        // At a corner nothing is borne, and what there is says nothing.
        if (bears > 0.1 * support.half_y * load) most = std::max(most, takes / bears);
      }
  return most;
}

void SupportGrip::judge(const Support& support, const MeasurementGate& gate,
                        double& friction) const noexcept {
  const double dt = gate.dt();
  const Eigen::Matrix3d R = gate.body().placement(support.frame).linear();
  double load = infinite, most = 0.0, easing = 2.0 * options_.easing;
  if (support.sensor >= 0) {
    const auto wrench = gate.last().support_wrenches.col(support.sensor);
    load = up_.dot(R * wrench.head<3>());
    if (load > options_.load) most = options_.share * felt(support, wrench, R, load);
    easing = options_.easing;
  }
  const bool slips =
      load > options_.load && support.way > options_.way && support.speed > options_.speed;
  if (slips)
    friction += part(dt, easing) * (std::min(friction, most) - friction);
  else
    friction = std::min(support.cone, friction + options_.recovery * dt);
  friction = std::max(friction, std::min(support.cone, options_.least));
}

void SupportGrip::update(const MeasurementGate& gate) noexcept {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    follow(supports_[i], gate);
    if (options_.enabled && std::isfinite(supports_[i].cone))
      judge(supports_[i], gate, friction_[static_cast<Eigen::Index>(i)]);
  }
}

void SupportGrip::watch(double now, FaultLatch& latch) const noexcept {
  for (const Support& support : supports_)
    if (support.way > allowed_ &&
        latch.raise(now, FaultKind::SupportSlipped, support.way, allowed_))
      latch.report.quantity = support.name;  // there is room
}

}  // namespace burnish

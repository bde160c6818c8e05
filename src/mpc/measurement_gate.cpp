#include "mpc/measurement_gate.hpp"

#include <cmath>

namespace burnish {

MeasurementGate::MeasurementGate(const MpcSpec& spec)
    : limits_(spec.limits),
      tick_period_(spec.tick_period),
      has_force_(spec.force_sensor),
      supports_(spec.support_sensors ? static_cast<Eigen::Index>(spec.supports.size()) : 0),
      q_start_(spec.problem.initial_state.head(spec.problem.model.nq)),
      body_(spec.problem.model) {
  last_.q = q_start_;
  last_.v = last_.tau = Eigen::VectorXd::Zero(spec.problem.model.nv);
  last_.support_wrenches.setZero(6, supports_);
}

void MeasurementGate::reset() noexcept {
  last_.time = now_ = dt_ = 0.0;
  last_.q = q_start_;
  last_.v.setZero();
  last_.tau.setZero();
  last_.tool_force_world.setZero();
  last_.support_wrenches.setZero();
  last_.base_lost_for = 0.0;
  started_ = fresh_ = first_ = false;
}

void MeasurementGate::take(const Measurement& m, FaultLatch& latch, Status& status) noexcept {
  const double before = last_.time;
  fresh_ = accept(m, latch, status);
  first_ = fresh_ && !started_;
  // Over ticks without a good measurement, if there were any.
  dt_ = first_ ? 0.0 : last_.time - before;
  if (fresh_ && !latch.is_set()) started_ = true;
}

bool MeasurementGate::take_state(const Measurement& m) noexcept {
  if (m.q.size() != last_.q.size() || m.v.size() != last_.v.size()) return false;
  if (body_.update(m.q, m.v) > Status::NotConverged) return false;
  last_.q = m.q;
  last_.v = m.v;
  return true;
}

bool MeasurementGate::accept(const Measurement& m, FaultLatch& latch, Status& status) noexcept {
  const bool stands_still = started_ && m.time <= last_.time;
  if (latch.is_set()) {
    // The fallback makes do with a position and a velocity.
    now_ += tick_period_;
    if (stands_still || !take_state(m)) return false;
    if (std::isfinite(m.time)) last_.time = m.time;
    if (m.tau.size() == last_.tau.size() && m.tau.allFinite()) last_.tau = m.tau;
    if (supports_ > 0 && m.support_wrenches.cols() == supports_ && m.support_wrenches.allFinite())
      last_.support_wrenches = m.support_wrenches;
    return true;
  }
  if (stands_still) {
    status = Status::NotEvaluated;
    bridge(latch, FaultKind::StaleMeasurement, limits_.stale);
    return false;
  }
  const double gap = started_ ? m.time - last_.time : 0.0;
  const bool forces = m.tau.size() == last_.tau.size() && m.tau.allFinite() &&
                      (!has_force_ || m.tool_force_world.allFinite()) &&
                      (supports_ == 0 ||
                       (m.support_wrenches.cols() == supports_ && m.support_wrenches.allFinite()));
  if (!std::isfinite(m.time) || !forces || !take_state(m)) {
    status = Status::NotFinite;
    bridge(latch, FaultKind::BadMeasurement, limits_.bad);
    return false;
  }
  last_.tau = m.tau;
  if (has_force_) last_.tool_force_world = m.tool_force_world;
  if (supports_ > 0) last_.support_wrenches = m.support_wrenches;
  last_.base_lost_for = m.base_lost_for;
  now_ = last_.time = m.time;
  if (gap > limits_.stale) latch.raise(now_, FaultKind::StaleMeasurement, gap, limits_.stale);
  return true;
}

/// Time goes on as it should have, so that the policy does too.
void MeasurementGate::bridge(FaultLatch& latch, FaultKind kind, double limit) noexcept {
  now_ += tick_period_;
  const double missing = now_ - last_.time;
  if (missing > limit + 0.01 * tick_period_) latch.raise(now_, kind, missing, limit);
}

}  // namespace burnish

#include "mpc/measurement_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/to_size.hpp"

namespace burnish {

MeasurementGate::MeasurementGate(const GateSpec& spec)
    : limits_(spec.limits),
      tick_period_(spec.tick_period),
      touches_(static_cast<Eigen::Index>(spec.touches.size())),
      q_start_(spec.q_start),
      state_(spec.model, spec.contacts, spec.tools),
      tool_forces_world_(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(spec.tools.size()))) {
  const Model& model = spec.model;
  for (int i = 0; i < model.nq; ++i) q_names_.push_back(model.q_name(i));
  for (int k = 0; k < model.nv; ++k) v_names_.push_back(model.v_name(k));
  last_.q = q_start_;
  last_.v = last_.tau = Eigen::VectorXd::Zero(model.nv);
  last_.wrenches.setZero(6, touches_);
  for (Eigen::Index i = 0; i < touches_; ++i) {
    const TouchSensor& touch = spec.touches[to_size(i)];
    if (touch.sensor == WrenchSensor::None) continue;
    const auto tool = std::find_if(spec.tools.begin(), spec.tools.end(),
                                   [&](const ToolFrames& t) { return t.tool == touch.frame; });
    if (tool == spec.tools.end())
      sensors_.push_back({touch.frame, i, touch.sensor == WrenchSensor::Wrench ? 6 : 3});
    else  // the moment on a tool is not read
      tool_sensors_.push_back(
          {{touch.frame, i, 3}, state_.body().frame(touch.frame), tool - spec.tools.begin()});
  }
  wrenches_.setZero(6, static_cast<Eigen::Index>(sensors_.size()));
}

void MeasurementGate::reset() noexcept {
  last_.time = now_ = dt_ = 0.0;
  last_.q = q_start_;
  last_.v.setZero();
  last_.tau.setZero();
  tool_forces_world_.setZero();
  last_.wrenches.setZero();
  wrenches_.setZero();
  last_.base_lost_for = 0.0;
  started_ = fresh_ = first_ = false;
}

void MeasurementGate::take(const Measurement& m, FaultLatch& latch, Status& status) noexcept {
  const double before = last_.time;
  fresh_ = accept(m, latch, status);
  first_ = fresh_ && !started_;
  // The interval includes the ticks whose measurements were missing or invalid.
  dt_ = first_ ? 0.0 : last_.time - before;
  if (fresh_ && !latch.is_set()) started_ = true;
}

bool MeasurementGate::take_state(const Measurement& m) noexcept {
  if (m.q.size() != last_.q.size() || m.v.size() != last_.v.size()) return false;
  if (!is_usable(state_.update(m.q, m.v))) return false;
  last_.q = m.q;
  last_.v = m.v;
  return true;
}

/// Returns whether all components of wrenches with a sensor are finite. Without sensors, a
/// measurement may have no columns.
bool MeasurementGate::has_wrenches(const Measurement& m) const noexcept {
  if (tool_sensors_.empty() && sensors_.empty()) return true;
  return m.wrenches.cols() == touches_ &&
         std::all_of(tool_sensors_.begin(), tool_sensors_.end(),
                     [&](const ToolSensor& tool) { return tool.sensor.is_finite(m); }) &&
         std::all_of(sensors_.begin(), sensors_.end(),
                     [&](const Sensor& sensor) { return sensor.is_finite(m); });
}

/// Keeps the wrenches that are finite. After a fault, wrenches may be missing.
void MeasurementGate::take_wrenches(const Measurement& m) noexcept {
  if (m.wrenches.cols() != touches_) return;
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const Sensor& sensor = sensors_[i];
    if (!sensor.is_finite(m)) continue;
    wrenches_.col(static_cast<Eigen::Index>(i)).head(sensor.rows) =
        m.wrenches.col(sensor.column).head(sensor.rows);
  }
}

bool MeasurementGate::accept(const Measurement& m, FaultLatch& latch, Status& status) noexcept {
  const bool stands_still = started_ && m.time <= last_.time;
  if (latch.is_set()) {
    // The fallback needs only position and velocity.
    now_ += tick_period_;
    if (stands_still || !take_state(m)) return false;
    if (std::isfinite(m.time)) last_.time = m.time;
    if (m.tau.size() == last_.tau.size() && m.tau.allFinite()) last_.tau = m.tau;
    take_wrenches(m);
    return true;
  }
  if (stands_still) {
    status = Status::NotEvaluated;
    std::snprintf(bad_, sizeof bad_, "the measurement's time stays at %.4f s", last_.time);
    bridge(latch, FaultKind::StaleMeasurement, limits_.stale);
    return false;
  }
  const double gap = started_ ? m.time - last_.time : 0.0;
  const bool forces = m.tau.size() == last_.tau.size() && m.tau.allFinite() && has_wrenches(m);
  if (!std::isfinite(m.time) || !forces || !take_state(m)) {
    status = Status::NotFinite;
    describe_defect(m);
    bridge(latch, FaultKind::BadMeasurement, limits_.bad);
    return false;
  }
  last_.tau = m.tau;
  if (m.wrenches.cols() == touches_) last_.wrenches = m.wrenches;
  for (const ToolSensor& tool : tool_sensors_)
    tool_forces_world_.col(tool.tool) =
        state_.body().placement(tool.frame).linear() * m.force_at(tool.sensor.column);
  take_wrenches(m);
  last_.base_lost_for = m.base_lost_for;
  now_ = last_.time = m.time;
  if (gap > limits_.stale) latch.raise(now_, FaultKind::StaleMeasurement, gap, limits_.stale);
  return true;
}

/// Advances the time by one tick while a measurement is missing, so that the policy continues.
/// Raises a fault if measurements have been missing for longer than `limit` [s].
void MeasurementGate::bridge(FaultLatch& latch, FaultKind kind, double limit) noexcept {
  now_ += tick_period_;
  const double missing = now_ - last_.time;
  if (missing > limit + 0.01 * tick_period_ && latch.raise(now_, kind, missing, limit))
    latch.explain(bad_);
}

/// Returns true if `entries` has a wrong number of columns or a column that is not finite.
/// Describes the first such defect in bad_. `names`: names of the columns.
template <class Entries>
bool MeasurementGate::is_bad(const char* what, const Entries& entries,
                             const std::vector<std::string>& names) noexcept {
  const auto count = static_cast<Eigen::Index>(names.size());
  if (entries.cols() != count) {
    std::snprintf(bad_, sizeof bad_, "%s has %d entries; wanted %d", what,
                  static_cast<int>(entries.cols()), static_cast<int>(count));
    return true;
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    if (entries.col(i).allFinite()) continue;
    std::snprintf(bad_, sizeof bad_, "%s of '%s' is not finite", what, names[to_size(i)].c_str());
    return true;
  }
  return false;
}

/// Writes a description of wrenches that are missing or not finite into bad_.
void MeasurementGate::describe_wrenches(const Measurement& m) noexcept {
  if (m.wrenches.cols() != touches_) {
    std::snprintf(bad_, sizeof bad_,
                  "wrenches has %d columns; wanted %d, one per entry of the controller's touches",
                  static_cast<int>(m.wrenches.cols()), static_cast<int>(touches_));
    return;
  }
  for (const ToolSensor& tool : tool_sensors_) {
    if (tool.sensor.is_finite(m)) continue;
    std::snprintf(bad_, sizeof bad_,
                  "the force on the tool '%s' is not finite; wanted a force sensor, or sensor none "
                  "in MpcSpec.touches",
                  tool.sensor.frame.c_str());
    return;
  }
  for (const Sensor& sensor : sensors_) {
    if (sensor.is_finite(m)) continue;
    std::snprintf(
        bad_, sizeof bad_, "the %s at '%s' is not finite; wanted a sensor of %s in MpcSpec.touches",
        sensor.rows == 3 ? "force" : "wrench", sensor.frame.c_str(),
        sensor.rows == 3 ? "force, or sensor none" : "force and moment, or sensor force or none");
    return;
  }
}

/// Writes a description of a measurement's first defect into bad_.
void MeasurementGate::describe_defect(const Measurement& m) noexcept {
  if (!std::isfinite(m.time)) {
    std::snprintf(bad_, sizeof bad_, "the measurement's time is not finite");
    return;
  }
  if (is_bad("q", m.q.transpose(), q_names_) || is_bad("v", m.v.transpose(), v_names_) ||
      is_bad("tau", m.tau.transpose(), v_names_))
    return;
  if (!has_wrenches(m)) {
    describe_wrenches(m);
    return;
  }
  const Status status = state_.update(m.q, m.v);
  std::snprintf(bad_, sizeof bad_, "q and v are not a valid state (%.*s)",
                static_cast<int>(describe(status).size()), describe(status).data());
}

}  // namespace burnish

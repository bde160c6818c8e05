#include "mpc/watch.hpp"

#include <cmath>
#include <cstdio>

namespace burnish {
namespace {

std::vector<int> entries_with_motors(const Model& model) {
  std::vector<int> entries;
  for (const Joint& joint : model.joints)
    if (joint.kind != JointKind::FreeFlyer && !joint.follows)
      for (int k = 0; k < joint.nv; ++k) entries.push_back(joint.v_index + k);
  return entries;
}

}  // namespace

void watch_joints(const Model& model, const SafetyLimits& limits, const MeasurementGate& gate,
                  FaultLatch& latch) noexcept {
  const double now = gate.now();
  for (const Joint& joint : model.joints) {
    for (int k = joint.v_index; k < joint.v_index + joint.nv; ++k) {
      const double max_speed = limits.joint_speed_ratio * model.velocity_limit[k];
      const double speed = std::abs(gate.last().v[k]);
      if (speed > max_speed) latch.raise(now, FaultKind::SpeedLimit, speed, max_speed, k);
    }
    if (joint.nq != 1) continue;
    const double q = gate.last().q[joint.q_index];
    const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
    if (q < lower - limits.joint_margin)
      latch.raise(now, FaultKind::OutOfRange, q, lower, joint.v_index);
    if (q > upper + limits.joint_margin)
      latch.raise(now, FaultKind::OutOfRange, q, upper, joint.v_index);
  }
}

void watch_base(const SafetyLimits& limits, const MeasurementGate& gate,
                FaultLatch& latch) noexcept {
  const double lost = gate.last().base_lost_for;
  if (lost > limits.base_lost) latch.raise(gate.now(), FaultKind::BaseLost, lost, limits.base_lost);
}

void watch_supports(const SupportGrip& grip, const SafetyLimits& limits, double now,
                    FaultLatch& latch) noexcept {
  for (const SupportGrip::Support& support : grip.supports())
    if (support.distance > limits.support_slip &&
        latch.raise(now, FaultKind::SupportSlipped, support.distance, limits.support_slip))
      latch.report.quantity = support.name;  // does not allocate: memory is reserved
}

MotorWatch::MotorWatch(const Model& model, const SafetyLimits& limits, double tick_period)
    : actuated_(entries_with_motors(model)),
      gap_fraction_(limits.torque_gap),
      effort_(model.effort_limit),
      commanded_(Eigen::VectorXd::Zero(model.nv)),
      dead_for_(Eigen::VectorXd::Zero(model.nv)),
      lag_(model, tick_period, actuated_) {}

void MotorWatch::look(const MeasurementGate& gate, const ConstVectorRef& tau_before) noexcept {
  if (lost_ >= 0) return;
  lag_.look(tau_before, gate.last().tau, gate.dt());
  if (std::isinf(gap_fraction_)) return;
  constexpr double window = 0.03;  // averaging time, equal to that of TorqueLag [s]
  const double weight = -std::expm1(-gate.dt() / window);
  for (const int k : actuated_) {
    commanded_[k] += weight * (tau_before[k] - commanded_[k]);
    if (effort_[k] <= 0.0) continue;
    const double gap = std::abs(lag_.gap(k));
    dead_for_[k] = is_dead(k) && gap > long_dead_factor * gap_fraction_ * effort_[k]
                       ? dead_for_[k] + gate.dt()
                       : 0.0;
    if (gap > max_gap(k)) lost_ = k;
  }
}

/// Returns true if the motor delivers almost nothing of its command.
bool MotorWatch::is_dead(int entry) const noexcept {
  constexpr double dead = 0.2;  // fraction of the commanded torque (see SafetyLimits::torque_gap)
  const double commanded = commanded_[entry];
  return std::abs(commanded - lag_.gap(entry)) <= dead * std::abs(commanded);
}

/// Returns the largest allowed difference between commanded and measured torque of a motor [Nm or
/// N]. The limit is lower for a motor that delivers almost nothing, so that a dead motor is found
/// earlier than a weak one.
double MotorWatch::max_gap(int entry) const noexcept {
  const double factor = dead_for_[entry] > long_dead ? long_dead_factor
                        : is_dead(entry)             ? dead_factor
                                                     : 1.0;
  return factor * gap_fraction_ * effort_[entry];
}

void MotorWatch::watch(double now, FaultLatch& latch) const noexcept {
  if (lost_ < 0) return;
  const double gap = lag_.gap(lost_);
  if (!latch.raise(now, FaultKind::MotorLost, std::abs(gap), max_gap(lost_), lost_)) return;
  char clause[96];
  std::snprintf(clause, sizeof clause, "commanded %.4g, measured %.4g, as means over 30 ms",
                commanded_[lost_], commanded_[lost_] - gap);
  latch.explain(clause);
}

bool PlanWatch::judge(double now, bool usable, bool first, double seconds,
                      FaultLatch& latch) noexcept {
  failed_ = usable ? 0 : failed_ + 1;
  const int allowed = first ? 1 : limits_.failed_solves;
  if (failed_ >= allowed) latch.raise(now, FaultKind::SolverFailed, failed_, allowed);
  const bool late = !first && seconds > limits_.deadline;
  late_ = late ? late_ + 1 : 0;
  if (late_ >= limits_.late_solves)
    latch.raise(now, FaultKind::SolverLate, late_, limits_.late_solves);
  return late;
}

}  // namespace burnish

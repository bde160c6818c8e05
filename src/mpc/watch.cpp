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
      const double fastest = limits.joint_speed_ratio * model.velocity_limit[k];
      const double speed = std::abs(gate.last().v[k]);
      if (speed > fastest) latch.raise(now, FaultKind::SpeedLimit, speed, fastest, k);
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

MotorWatch::MotorWatch(const MpcSpec& spec)
    : actuated_(entries_with_motors(spec.problem.model)),
      share_(spec.limits.torque_gap),
      effort_(spec.problem.model.effort_limit),
      told_(Eigen::VectorXd::Zero(spec.problem.model.nv)),
      lag_(spec, actuated_) {}

void MotorWatch::look(const MeasurementGate& gate, const ConstVectorRef& tau_before) noexcept {
  if (lost_ >= 0) return;
  lag_.look(tau_before, gate.last().tau, gate.dt());
  if (std::isinf(share_)) return;
  constexpr double window = 0.03;  // s, as the lag's
  const double part = -std::expm1(-gate.dt() / window);
  for (const int k : actuated_) {
    told_[k] += part * (tau_before[k] - told_[k]);
    if (effort_[k] > 0.0 && std::abs(lag_.gap(k)) > allowed(k)) lost_ = k;
  }
}

/// Nm (N) that a motor may be off. One that gives next to nothing is found before one that is weak.
double MotorWatch::allowed(int entry) const noexcept {
  constexpr double nothing = 0.2, sooner = 0.6;
  const double came = std::abs(told_[entry] - lag_.gap(entry));
  const bool gives = came > nothing * std::abs(told_[entry]);
  return (gives ? 1.0 : sooner) * share_ * effort_[entry];
}

void MotorWatch::watch(double now, FaultLatch& latch) const noexcept {
  if (lost_ < 0) return;
  const double gap = lag_.gap(lost_);
  if (!latch.raise(now, FaultKind::MotorLost, std::abs(gap), allowed(lost_), lost_)) return;
  char clause[96];
  std::snprintf(clause, sizeof clause, "%.4g were sent and %.4g came, means over 30 ms",
                told_[lost_], told_[lost_] - gap);
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

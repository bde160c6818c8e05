// Monitors that an MpcController evaluates in a tick, and causes of faults.
#include <array>
#include <cstdio>

#include "mpc/mpc_impl.hpp"

namespace burnish {
namespace {

/// Returns a text for the reason why a solve gave no usable plan; empty if the reason needs none.
const char* reason_of(StopReason reason) {
  switch (reason) {
    case StopReason::NotEvaluated:
      return "a knot of the plan cannot be evaluated";
    case StopReason::NotPositiveDefinite:
      return "the costs of a plan are not convex, even with the largest regularisation";
    case StopReason::NoStep:
      return "no step of the solver improves the plan";
    case StopReason::TimeBudget:
      return "the solver's time budget was spent before its first iteration";
    default:
      return "";
  }
}

}  // namespace

void MpcController::Impl::watch(const TaskView& view) noexcept {
  watch_joints(problem.model(), spec.limits, gate, fault);
  watch_base(spec.limits, gate, fault);
  watch_supports(grip, spec.limits, gate.now(), fault);
  motors_.watch(gate.now(), fault);
  task->watch(view, readings_);
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const auto [value, limit] = readings_[i];
    const FaultKind kind = watched_[i].fault;
    if (!(value > limit) || !fault.raise(gate.now(), kind, value, limit)) continue;
    const WatchedQuantity& quantity = watched_[i];
    fault.report.quantity =
        // Does not allocate: memory is reserved.
        kind == FaultKind::Watched ? quantity.name : quantity.part;
    std::array<char, 160> clause{};
    task->explain(i, clause);
    fault.explain(clause.data());
  }
  if (!fault.is_set()) return;
  life_.raise_fault();
  explain_lag();
}

/// Adds a clause about an unexpected delay of torques to the cause of a fault. Such a delay makes
/// the controller oscillate, which can appear as any kind of fault.
void MpcController::Impl::explain_lag() noexcept {
  constexpr double min_lag = 1.5e-3;  // smallest lag that the clause mentions [s]; chosen by hand
  if (motors_.lag() < min_lag) return;
  char clause[128];
  std::snprintf(clause, sizeof clause,
                "measured torques follow commands %.0f ms late, and the controller does not "
                "compensate this delay",
                1e3 * motors_.lag());
  fault.explain(clause);
}

void MpcController::Impl::explain_failure() noexcept {
  if (fault.report.kind == FaultKind::SolverLate) {
    char clause[96];
    std::snprintf(clause, sizeof clause, "the last update took %.4g s; allowed are %.4g s",
                  command_.solve_time, spec.limits.deadline);
    fault.explain(clause);
  } else if (fault.report.kind == FaultKind::SolverFailed) {
    fault.explain(result_.thrown ? "a function of the specification threw an exception"
                                 : reason_of(solver.summary().reason));
  }
}

}  // namespace burnish

// What an MpcController watches at a tick, and what led to a fault.
#include <array>
#include <cstdio>

#include "mpc/mpc_impl.hpp"

namespace burnish {
namespace {

/// Why a solve is of no use.
const char* reason_of(StopReason reason) {
  switch (reason) {
    case StopReason::NotEvaluated:
      return "a knot of the plan cannot be evaluated";
    case StopReason::NotPositiveDefinite:
      return "the costs of a plan are not convex, whatever the regularisation";
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
  grip.watch(gate.now(), fault);
  motors_.watch(gate.now(), fault);
  task->watch(view, readings_);
  for (std::size_t i = 0; i < readings_.size(); ++i) {
    const auto [value, limit] = readings_[i];
    const FaultKind kind = watched_[i].fault;
    if (!(value > limit) || !fault.raise(gate.now(), kind, value, limit)) continue;
    const WatchedQuantity& quantity = watched_[i];
    fault.report.quantity =
        kind == FaultKind::Watched ? quantity.name : quantity.part;  // there is room
    std::array<char, 160> clause{};
    task->explain(i, clause);
    fault.explain(clause.data());
  }
  if (fault.is_set()) explain_lag();
}

/// A delay that nobody told the controller of makes it swing, whatever the fault is then called.
void MpcController::Impl::explain_lag() noexcept {
  constexpr double shows = 1.5e-3;  // s
  if (motors_.lag() < shows) return;
  char clause[128];
  std::snprintf(clause, sizeof clause,
                "measured torques follow what was sent %.0f ms late, which the controller does not "
                "know",
                1e3 * motors_.lag());
  fault.explain(clause);
}

void MpcController::Impl::explain_failure() noexcept {
  if (fault.report.kind == FaultKind::SolverLate) {
    char clause[96];
    std::snprintf(clause, sizeof clause, "the last one took %.4g s, and %.4g s are allowed",
                  command_.solve_time, spec.limits.deadline);
    fault.explain(clause);
  } else if (fault.report.kind == FaultKind::SolverFailed) {
    fault.explain(making_.thrown ? "a function of the specification threw an exception"
                                 : reason_of(solver.summary().reason));
  }
}

}  // namespace burnish

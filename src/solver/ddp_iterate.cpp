// The iterations of a solve.
#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/ddp_impl.hpp"

namespace burnish {

/// Number of iterations without expected improvement but with violations, after which elastic mode
/// begins. Until then, Newton steps can reduce violations in their last digits. Chosen by hand.
static constexpr int patience_violated = 4;
/// Largest violation at which a rejected step is corrected, relative to the scale of the row. At
/// larger violations, the measured errors do not predict where the limits lie. Chosen by hand.
static constexpr double near_limits = 0.1;

bool DdpSolver::Impl::increase_regularization() {
  const Regularization& rule = options.regularization;
  if (regularization >= rule.largest) return false;
  regularization = std::min(rule.largest, std::max(rule.smallest, regularization * rule.factor));
  return true;
}

void DdpSolver::Impl::decrease_regularization() {
  const Regularization& rule = options.regularization;
  regularization /= rule.factor;
  if (regularization < rule.smallest) regularization = 0.0;
  regularization = std::max(regularization, regularization_floor);
}

/// Computes the expansions of the current iterate, the recursion with as much regularization as
/// needed, and the expected improvement.
bool DdpSolver::Impl::make_direction() {
  if (!expanded) {
    if (!expand(current)) {
      fail_at(trial_failure_knot, trial_failure);
      return stop(StopReason::NotEvaluated);
    }
    expanded = true;
    if (out_of_time()) return stop(StopReason::TimeBudget);
    if (summary.iterations >= options.max_iterations) return stop(StopReason::MaxIterations);
  }
  while (!backward()) {
    if (find_not_finite()) return stop(StopReason::NotEvaluated);
    if (!increase_regularization()) return stop(StopReason::NotPositiveDefinite);
    regularization_floor = regularization;
    if (out_of_time()) return stop(StopReason::TimeBudget);
  }
  summary.knot = summary.control = -1;
  if (limited) model_of_limited();
  if (!std::isfinite(direction.slope) || !std::isfinite(direction.model_change) ||
      !std::isfinite(value(0).hessian[0])) {
    if (!find_not_finite()) fail_at(0, {0.0, Status::NotFinite, -1});
    return stop(StopReason::NotEvaluated);
  }
  summary.regularization = regularization;
  summary.expected_improvement =
      limited ? std::abs(merit_change) : std::abs(direction.slope + 0.5 * direction.curvature);
  return true;
}

/// Stops if no improvement is expected. Strong regularization makes every expected improvement
/// small, so only a direction with the smallest accepted regularization counts; `again` requests
/// that direction.
bool DdpSolver::Impl::judge_direction(bool& again) {
  again = false;
  if (limited) {
    note_stillness();
    if (elastic.on ? ends_elastic(again) : ends_still(again)) {
      close_gaps();
      return stop(StopReason::Infeasible);
    }
    if (again || elastic.on) return !out_of_time() || stop(StopReason::TimeBudget);
  }
  const bool feasible = current.feasible && (!limited || keeps_limits(current));
  // An expected improvement below stop_tolerance + limit_resolution may be an effect of the
  // constraint tolerance. One more Newton step shows whether it is.
  const bool gains = summary.expected_improvement >= options.stop_tolerance;
  const bool unresolved = gains && !std::exchange(at_resolution, true);
  if (!feasible || summary.expected_improvement >= options.stop_tolerance + limit_resolution)
    at_resolution = false;
  else if (!unresolved) {
    if (regularization <= std::max(regularization_floor, options.regularization.smallest))
      return stop(limited && starts_violated() ? StopReason::Infeasible : StopReason::Converged);
    if (searched_at_floor) return stop(StopReason::NoStep);
    searched_at_floor = true;
    regularization = regularization_floor;
    again = true;
    return true;
  }
  const bool no_progress = limited && !keeps_limits(current) &&
                           summary.expected_improvement < options.stop_tolerance +
                                                              limit_resolution +
                                                              1e-9 * current.violation_cost;
  if (no_progress && ++elastic.stood >= patience_violated) again = become_elastic();
  return !out_of_time() || stop(StopReason::TimeBudget);
}

/// Tries step lengths until one is accepted; `length` is 0 if none is accepted.
bool DdpSolver::Impl::line_search(double& length) {
  const bool rollout = options.update == StepUpdate::Rollout;
  trial_failure_knot = -1;
  if (!rollout && !limited) {
    linear_rollout();
    penalty = penalty_for_direction();
  }
  length = 1.0;
  for (int halving = 0; halving <= options.line_search.halvings; ++halving, length *= 0.5) {
    bool taken = false;
    if (rollout) {
      const Clock::time_point from = Clock::now();
      double gap_improvement = 0.0;
      taken = roll_trial(length, gap_improvement) &&
              (limited ? accept_limited(length) : accept_rollout(length, gap_improvement));
      summary.seconds.trial += since(from);
      if (taken) expanded = false;
    } else {
      // The whole step is usually accepted; expanding it in the trial saves a second evaluation.
      const bool ahead =
          halving == 0 && summary.iterations + 1 < options.max_iterations && !refused;
      const bool evaluated = shooting_trial(length, ahead);
      taken = evaluated && (limited ? accept_limited(length) : accept_shooting(length));
      if (limited && halving == 0) {
        refused = !taken;
        if (evaluated && !taken && !ahead && !elastic.on && current.violation <= near_limits)
          taken = corrected_trial();
      }
      expanded = ahead && taken;
    }
    if (taken) {
      take_trial(length);
      return true;
    }
    if (out_of_time()) return stop(StopReason::TimeBudget);
  }
  length = 0.0;
  return true;
}

bool DdpSolver::Impl::after_search(double length) {
  ++summary.iterations;
  DdpProgress progress;
  progress.iteration = summary.iterations;
  progress.cost = current.cost;
  progress.expected_improvement = summary.expected_improvement;
  progress.largest_gap = current.largest_gap;
  progress.step_length = length;
  progress.regularization = regularization;
  progress.penalty = penalty;
  progress.feasible = current.feasible;
  progress.violation = current.violation;
  progress.factorizations = limited ? limited_result.factorizations : 1;
  progress.seconds = since(began);
  summary.log.push_back(progress);
  if (length > 0.0) searched_at_floor = false;
  if (options.callback && !options.callback(progress)) return stop(StopReason::Callback);
  const Regularization& rule = options.regularization;
  if (length > rule.decrease_above) decrease_regularization();
  if (length <= rule.increase_at_or_below && !increase_regularization()) {
    if (!limited || keeps_limits(current) || !become_elastic()) return stop(StopReason::NoStep);
    regularization = regularization_floor;
  }
  if (summary.iterations >= options.max_iterations) return stop(StopReason::MaxIterations);
  return !out_of_time() || stop(StopReason::TimeBudget);
}

void DdpSolver::Impl::iterate() {
  for (;;) {
    bool again = false;
    do {
      if (!make_direction() || !judge_direction(again)) return;
    } while (again);
    double length = 0.0;
    if (!line_search(length) || !after_search(length)) return;
  }
}

/// Returns the best iterate if the solve was cut short, else the last iterate.
void DdpSolver::Impl::finish() {
  const bool complete = summary.reason == StopReason::Converged ||
                        summary.reason == StopReason::Infeasible ||
                        summary.reason == StopReason::MaxIterations;
  if (!best_is_current && !complete) {
    std::swap(current, best);
    expanded = false;
  }
  if (summary.reason == StopReason::NoStep && trial_failure_knot >= 0)
    fail_at(trial_failure_knot, trial_failure);
  summary.cost = current.cost;
  summary.largest_gap = current.largest_gap;
  summary.gap_knot = current.gap_knot;
  summary.gap_entry = current.gap_entry;
  if (limited) note_violation();
  summary.feasible = current.feasible && summary.violation_knot < 0;
  summary.seconds.total = since(began);
}

}  // namespace burnish

// Trial steps of the line search, for both kinds of update, and their acceptance.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"
#include "solver/dense.hpp"

namespace burnish {

/// Rolls the policy out through the dynamics. Each state keeps `1 - length` of its gap. Returns
/// false if a knot cannot be evaluated. `gap_improvement` receives the contribution of the gaps to
/// the expected improvement: the sum over the knots of gap^T Vxx dx for the change dx of the state.
bool DdpSolver::Impl::roll_trial(double length, double& gap_improvement) {
  trial.cost = 0.0;
  gap_improvement = 0.0;
  const bool closing = !current.feasible && length < 1.0;
  const double* reached = problem.initial_state();
  for (int k = 0; k <= N; ++k) {
    const double* x_before = current.xs.data() + k * nx;
    double* x = trial.xs.data() + k * nx;
    if (closing) {
      const double* g = gap(current, k);
      for (int i = 0; i < ndx; ++i) scratch.data()[i] = (length - 1.0) * g[i];
      problem.integrate(reached, scratch.data(), x);
    } else {
      std::copy_n(reached, nx, x);
    }
    problem.difference(x_before, x, dx(k));
    if (!current.feasible) gap_improvement += dense::dot(hessian_gap(k), dx(k), ndx);
    double* u = nullptr;
    if (k < N) {
      u = trial.us.data() + k * nu_max;
      const double* u_before = current.us.data() + k * nu_max;
      const PolicyStorage p = policy(k);
      std::copy_n(u_before, nu_max, u);
      for (int c = 0; c < controls[to_size(k)]; ++c)
        u[c] += length * p.feedforward[c] + dense::dot(p.gain + c * gain_stride, dx(k), ndx);
      clamp(k, u);
    }
    double* after = k < N ? next.data() + k * nx : nullptr;
    double* rows = limited ? trial.rows.data() + k * rows_max : nullptr;
    const KnotValue v = problem.roll(0, k, x, u, after, rows);
    if (!is_usable(v.status) || !std::isfinite(v.cost)) {
      trial_failure = v;
      trial_failure_knot = k;
      return false;
    }
    trial.cost += v.cost;
    reached = after;
  }
  trial.gap_sum = closing ? (1.0 - length) * current.gap_sum : 0.0;
  if (limited) take_rows(trial);
  return true;
}

/// Accepts a rollout if the cost falls by a fraction of the expected decrease. An iterate with gaps
/// may rise in cost. If a rise is expected, the cost may rise by a multiple of the expected rise.
bool DdpSolver::Impl::accept_rollout(double length, double gap_improvement) const {
  // Converts the gap contribution from a step of `length` to a step of length one.
  const double whole = gap_improvement / length;
  const double d1 = direction.slope + whole;
  const double d2 = direction.curvature - 2.0 * whole;
  const double expected = length * (d1 + 0.5 * length * d2);
  const LineSearch& rule = options.line_search;
  const double saved =
      current.cost - trial.cost + rule.rounding * std::max(std::abs(current.cost), 1e-300);
  if (expected >= 0.0) return !current.feasible || saved > rule.sufficient_decrease * expected;
  return saved > rule.allowed_increase * expected;
}

/// Moves along the direction and evaluates every knot, in ranges that threads share.
bool DdpSolver::Impl::shooting_trial(double length, bool with_expansion) {
  for (int k = 0; k <= N; ++k) {
    for (int i = 0; i < ndx; ++i) scratch.data()[i] = length * dx(k)[i];
    problem.integrate(current.xs.data() + k * nx, scratch.data(), trial.xs.data() + k * nx);
    if (k == N) break;
    double* u = trial.us.data() + k * nu_max;
    std::copy_n(current.us.data() + k * nu_max, nu_max, u);
    for (int c = 0; c < controls[to_size(k)]; ++c) u[c] += length * du(k)[c];
    clamp(k, u);
  }
  trial.feasible = false;
  if (with_expansion) return expand(trial);
  const Clock::time_point from = Clock::now();
  const TrajectoryView view{trial.xs.data(), trial.us.data()};
  pool->for_each(static_cast<int>(ranges.size()), [&](int worker, int piece) {
    problem.evaluate(worker, ranges[to_size(piece)], view, next.data(), values.data(),
                     limited ? trial.rows.data() : nullptr);
  });
  const bool good = take_values(trial) && take_gaps(trial);
  if (good && limited) take_rows(trial);
  trial.feasible = good && trial.largest_gap <= options.gap_tolerance;
  summary.seconds.trial += since(from);
  return good;
}

bool DdpSolver::Impl::accept_shooting(double length) const {
  const LineSearch& rule = options.line_search;
  const double slope = direction.cost_slope - penalty * current.gap_sum;
  const double before = merit(current);
  return merit(trial) <=
         before + rule.merit_decrease * length * slope + rule.rounding * std::abs(before);
}

/// Makes the trial the current iterate. Keeps the replaced iterate if it is better.
void DdpSolver::Impl::take_trial(double length) {
  if (options.update == StepUpdate::Rollout) {
    trial.feasible = current.feasible || length == 1.0;
    const double left = trial.feasible ? 0.0 : 1.0 - length;
    trial.largest_gap = left * current.largest_gap;
    trial.gap_sum = left * current.gap_sum;
    trial.gap_knot = current.gap_knot;
    trial.gap_entry = current.gap_entry;
  }
  std::swap(current, trial);
  // Compares merits and not costs, because a gap below the tolerance can lower the cost without
  // progress.
  const Iterate& rival = best_is_current ? trial : best;
  const bool better =
      current.feasible ? !rival.feasible || merit(current) <= merit(rival) : !rival.feasible;
  if (!better && best_is_current) std::swap(best, trial);
  best_is_current = better;
}

}  // namespace burnish

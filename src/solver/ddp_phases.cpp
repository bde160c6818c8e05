// Expansion of the horizon and backward recursion.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"
#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

namespace {

/// Minimum number of multiplications per knot for which threads share a knot. Below about 130,000
/// multiplications, two workers are slower than one (measured with burnish_riccati_bench), because
/// each cache line that passes between cores costs tens of nanoseconds.
constexpr double min_shared_work = 2e5;

bool usable(const KnotValue& value) { return is_usable(value.status) && std::isfinite(value.cost); }

bool all_finite(const double* x, int n) {
  // The sum is finite only if all terms are finite. An overflow counts as a failure too.
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += std::abs(x[i]);
  return std::isfinite(sum);
}

}  // namespace

bool DdpSolver::Impl::stop(StopReason reason) {
  summary.reason = reason;
  return false;
}

bool DdpSolver::Impl::fail_at(int knot, const KnotValue& value) {
  summary.status = is_usable(value.status) ? Status::NotFinite : value.status;
  summary.knot = knot;
  summary.term = value.term;
  summary.row = value.row;
  return false;
}

/// Sums the cost of an iterate from `values`, in the order of the knots.
bool DdpSolver::Impl::take_values(Iterate& at) {
  at.cost = 0.0;
  for (int k = 0; k <= N; ++k) {
    const KnotValue& v = values[to_size(k)];
    if (!usable(v)) {
      trial_failure = v;
      trial_failure_knot = k;
      return false;
    }
    at.cost += v.cost;
  }
  return true;
}

/// Computes the gaps of an iterate from `next`.
bool DdpSolver::Impl::take_gaps(Iterate& at) {
  at.gap_sum = at.largest_gap = 0.0;
  at.gap_knot = at.gap_entry = 0;
  for (int k = 0; k <= N; ++k) {
    const double* reached = k == 0 ? problem.initial_state() : next.data() + (k - 1) * nx;
    double* g = gap(at, k);
    problem.difference(at.xs.data() + k * nx, reached, g);
    if (!all_finite(g, ndx)) {
      trial_failure = {0.0, Status::NotFinite, -1};
      trial_failure_knot = std::max(0, k - 1);
      return false;
    }
    for (int i = 0; i < ndx; ++i) {
      const double size = std::abs(g[i]);
      at.gap_sum += size;
      if (size > at.largest_gap) {
        at.largest_gap = size;
        at.gap_knot = k;
        at.gap_entry = i;
      }
    }
  }
  return true;
}

/// Evaluates and linearizes an iterate: costs, rows, gaps and expansions.
bool DdpSolver::Impl::expand(Iterate& at) {
  const Clock::time_point from = Clock::now();
  expanded = has_curvature = false;
  const TrajectoryView view{at.xs.data(), at.us.data()};
  if (limited)
    for (int k = 0; k <= N; ++k) expansions[to_size(k)].row_values = at.rows.data() + k * rows_max;
  pool->for_each(static_cast<int>(ranges.size()), [&](int worker, int piece) {
    problem.expand(worker, ranges[to_size(piece)], view, next.data(), values.data(),
                   expansions.data());
  });
  bool good = take_values(at);
  if (good && limited) take_rows(at);
  // A trajectory from a rollout does not have gaps, only rounding errors.
  const bool rolled_out = at.feasible && options.update == StepUpdate::Rollout;
  if (good && !rolled_out) {
    good = take_gaps(at);
    at.feasible = good && at.largest_gap <= options.gap_tolerance;
  }
  if (good && at.feasible && options.update == StepUpdate::Rollout) {
    for (int k = 0; k <= N; ++k) std::fill_n(gap(at, k), ndx, 0.0);
    at.gap_sum = 0.0;
  }
  summary.seconds.expand += since(from);
  return good;
}

/// Returns whether the threads share each knot of the recursion. This affects only the computing
/// time.
bool DdpSolver::Impl::shares_knots() const {
  if (pool->workers() == 1 || !pool->has_a_core_each() || !options.share_knots) return false;
  double work = 0.0;
  for (std::size_t k = 0; k < to_size(N); ++k)
    work += recursion.multiplications(controls[k], expansions[k].form);
  return work >= min_shared_work * N;
}

/// Runs the recursion over the horizon. Returns false if Quu is not positive definite or not
/// finite.
bool DdpSolver::Impl::backward() {
  const Clock::time_point from = Clock::now();
  direction = {};
  if (limited) {
    const bool done = limited_backward();
    summary.seconds.backward += since(from);
    return done;
  }
  recursion.terminal(expansions[to_size(N)], value(N));
  bool decided = false;
  bool good = false;
  if (can_be_cut()) good = sweep_segments(decided);
  if (!decided) good = sweep_knots();
  if (good) add_first_gap();
  summary.seconds.backward += since(from);
  return good;
}

/// Sweeps knot after knot, with one thread or with the thread team.
bool DdpSolver::Impl::sweep_knots() {
  if (!shares_knots()) return sweep({});
  bool good = false;
  pool->together([&](const ThreadTeam& team) noexcept {
    const bool mine = sweep(team);
    if (team.leads()) good = mine;
  });
  return good;
}

/// Sweeps knot after knot; the leader of the team records the results.
bool DdpSolver::Impl::sweep(const ThreadTeam& team) {
  for (int k = N - 1; k >= 0; --k) {
    const auto i = to_size(k);
    const RiccatiStep step = recursion.step({expansions[i], controls[i], gap(current, k + 1),
                                             value(k + 1), policy(k), value(k), hessian_gap(k + 1)},
                                            {regularization, box(k)}, team);
    if (team.leads()) take_step(k, step);
    if (step.failed_control >= 0) return false;
  }
  return true;
}

void DdpSolver::Impl::take_step(int knot, const RiccatiStep& step) {
  if (step.failed_control >= 0) {
    summary.knot = knot;
    summary.control = step.failed_control;
    return;
  }
  direction.slope -= step.slope + step.gap_slope + step.gap_curvature;
  direction.curvature += step.gap_curvature - step.curvature;
  direction.model_change +=
      step.slope + 0.5 * step.curvature + step.gap_slope + 0.5 * step.gap_curvature;
}

/// Adds the contribution of the first state's gap to the direction.
void DdpSolver::Impl::add_first_gap() {
  const ValueStorage v = value(0);
  const double* g = gap(current, 0);
  for (int i = 0; i < ndx; ++i)
    hessian_gap(0)[i] = dense::dot(v.hessian + i * value_stride, g, ndx);
  const double slope = dense::dot(v.gradient, g, ndx);
  const double curvature = dense::dot(hessian_gap(0), g, ndx);
  direction.slope -= slope + curvature;
  direction.curvature += curvature;
  direction.model_change += slope + 0.5 * curvature;
}

/// Returns whether an expansion holds a number that is not finite, and records its knot in the
/// summary.
bool DdpSolver::Impl::find_not_finite() {
  for (int k = N; k >= 0; --k) {
    const auto i = to_size(k);
    const KnotExpansion& e = expansions[i];
    const int nz = controls[i] + ndx;
    bool good = all_finite(e.gradient, nz);
    for (int r = 0; good && r < nz; ++r) good = all_finite(e.hessian + r * e.stride, r + 1);
    const int rows = k == N ? 0 : e.form == DynamicsForm::Dense ? ndx : state.nv;
    for (int r = 0; good && r < rows; ++r) good = all_finite(e.dynamics + r * e.stride, nz);
    if (!good) {
      summary.control = -1;
      fail_at(k, {0.0, Status::NotFinite, -1});
      summary.in_derivatives = true;
      return true;
    }
  }
  return false;
}

/// Computes dx and du of the linear-quadratic problem, with du clamped to the bounds, and the slope
/// of the cost.
void DdpSolver::Impl::linear_rollout() {
  std::copy_n(gap(current, 0), ndx, dx(0));
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    const int nu = controls[i];
    double* zk = z.data();
    if (k < N) {
      const PolicyStorage p = policy(k);
      for (int c = 0; c < nu; ++c)
        zk[c] = p.feedforward[c] + dense::dot(p.gain + c * gain_stride, dx(k), ndx);
      if (lower[i] != nullptr && upper[i] != nullptr) {
        const double* u = current.us.data() + k * nu_max;
        for (int c = 0; c < nu; ++c)
          zk[c] = std::min(std::max(zk[c], lower[i][c] - u[c]), upper[i][c] - u[c]);
      }
      std::copy_n(zk, nu, du(k));
    }
    std::copy_n(dx(k), ndx, zk + nu);
    direction.cost_slope += dense::dot(expansions[i].gradient, zk, nu + ndx);
    if (k == N) break;
    multiply(state, expansions[i], nu, zk, scratch.data(), dx(k + 1));
    const double* g = gap(current, k + 1);
    for (int c = 0; c < ndx; ++c) dx(k + 1)[c] += g[c];
  }
}

/// Returns the largest entry of the multipliers vx + Vxx dx of the linear-quadratic problem.
double DdpSolver::Impl::largest_multiplier() {
  double largest = 0.0;
  for (int k = 0; k <= N; ++k) {
    const ValueStorage v = value(k);
    for (int i = 0; i < ndx; ++i) {
      const double m = v.gradient[i] + dense::dot(v.hessian + i * value_stride, dx(k), ndx);
      largest = std::max(largest, std::abs(m));
    }
  }
  return largest;
}

/// Returns a penalty for which the direction is a descent direction of the merit. The penalty
/// follows the rule of Nocedal and Wright, Numerical Optimization (2006), eq. (18.36), but rises at
/// most to a bound that is proportional to the largest multiplier.
double DdpSolver::Impl::penalty_for_direction() {
  if (current.gap_sum <= 0.0) return penalty;
  const double curvature = std::max(0.0, 2.0 * (direction.model_change - direction.cost_slope));
  const double fraction = 1.0 - options.line_search.merit_fraction;
  const double needed = (direction.cost_slope + 0.5 * curvature) / (fraction * current.gap_sum);
  if (needed <= penalty) return penalty;
  return std::max(penalty, std::min(needed, largest_multiplier() / fraction));
}

}  // namespace burnish

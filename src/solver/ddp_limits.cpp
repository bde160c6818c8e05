// Constraint rows: the data that an iteration passes to its linear-quadratic problem, the step that
// follows from the solution, and the merit function of the line search,
//   cost + penalty sum |gap|_1 + sum (p |v| + 1/2 S v^2)  over violations v of rows,
// with quadratic weight S and L1 weight p. The merit function is exact: if each p is at least the
// row's multiplier, the minimum is the solution. The weights p follow the multipliers.
//
// Hard rows also have a finite, large L1 weight, so that a direction exists even if an iteration
// cannot satisfy all rows. ddp_elastic.cpp treats rows that stay violated at this weight.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"
#include "solver/dense.hpp"

namespace burnish {

namespace {
/// Elastic mode begins after `lost_patience` consecutive iterations with a constraint residual
/// above `large_residual`, relative to the scale. Chosen by hand.
constexpr double large_residual = 1e-3;
constexpr int lost_patience = 20;
}  // namespace

void DdpSolver::Impl::allocate_rows() {
  rows_max = problem.max_rows();
  if (rows_max == 0) return;
  for (int k = 0; k <= N; ++k)
    if (problem.rows(k) > 0 &&
        (problem.row_lower(k) == nullptr || problem.row_upper(k) == nullptr ||
         problem.row_scale(k) == nullptr || problem.row_l1_weight(k) == nullptr ||
         problem.row_quadratic_weight(k) == nullptr))
      throw Error(problem.knot_name(k) +
                  " has constraint rows without limits, scales or weights; wanted all three");
  limited = std::make_unique<LimitedLq>(state, N, nu_max, rows_max);
  row_counts.assign(to_size(N) + 1, 0);
  coefficient_counts = row_counts;
  row_lowers.assign(row_counts.size(), nullptr);
  row_uppers = row_lowers;
  for (int k = 0; k <= N; ++k) row_views.push_back(limited->rows(k));
  const auto all = to_size(N + 1) * to_size(rows_max);
  merit_weights.assign(all, 0.0);
  row_slots.assign(all, 0);
  for (auto* of_rows : {&row_scales, &row_inverses, &row_l1_weights, &row_quadratic_weights})
    of_rows->assign(all, 0.0);
  row_multipliers.assign(all, 0.0);
  summary.conflict.reserve(all);
  summary.stopping.reserve(all);
  summary.start_violations.reserve(to_size(rows_max));
  start_is_fixed.assign(to_size(rows_max), 0);
  allocate_correction();
  allocate_curvatures();
  for (Iterate* it : {&current, &trial, &best}) it->rows.assign(all, 0.0);
  const int stride = recursion.layout().expansion_stride;
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    row_memory.emplace_back(to_size(rows_max + dense::lanes) * to_size(stride));
    expansions[i].rows = row_memory.back().data();
    value_list.push_back(value(k));
    policy_list.push_back(policy(k));
  }
}

void DdpSolver::Impl::start_rows() {
  if (!limited) return;
  place_rows();
  std::fill(merit_weights.begin(), merit_weights.end(), 0.0);
  merit_change = limit_resolution = row_unit = 0.0;
  elastic = {.weight = options.limits.l1_weight};
  hard_l1_weight = options.limits.l1_weight;
  refused = at_resolution = false;
  std::fill(start_is_fixed.begin(), start_is_fixed.end(), 0);
}

/// Assigns each row its index: first the rows that are entries of z = (du, dx), then the others.
void DdpSolver::Impl::place_rows() {
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    const int* entry = problem.row_entry(k);
    int* slot = row_slots.data() + k * rows_max;
    int behind = 0;
    row_counts[i] = problem.rows(k);
    for (int r = 0; r < row_counts[i]; ++r)
      slot[r] = entry != nullptr && entry[r] >= 0 ? entry[r] : limited->first_row() + behind++;
    coefficient_counts[i] = behind;
    if (row_counts[i] == 0) continue;
    row_lowers[i] = problem.row_lower(k);
    row_uppers[i] = problem.row_upper(k);
    const auto first = static_cast<std::ptrdiff_t>(k) * rows_max;
    std::copy_n(problem.row_scale(k), row_counts[i], row_scales.begin() + first);
    for (std::ptrdiff_t r = first; r < first + row_counts[i]; ++r)
      row_inverses[to_size(r)] = 1.0 / row_scales[to_size(r)];
    std::copy_n(problem.row_l1_weight(k), row_counts[i], row_l1_weights.begin() + first);
    std::copy_n(problem.row_quadratic_weight(k), row_counts[i],
                row_quadratic_weights.begin() + first);
  }
}

bool DdpSolver::Impl::is_bounded(int knot, int control) const {
  const auto i = to_size(knot);
  return knot < N && lower[i] != nullptr && upper[i] != nullptr &&
         (lower[i][control] > -beyond_all || upper[i][control] < beyond_all);
}

/// Discards the policies and multipliers of previous directions.
void DdpSolver::Impl::forget_limits() noexcept {
  limited_before = false;
  limited->forget();
  std::fill(row_multipliers.begin(), row_multipliers.end(), 0.0);
}

/// Returns the quadratic weight of a row; `row` counts over all knots.
double DdpSolver::Impl::quadratic_weight_of(std::size_t row) const {
  if (!is_hard(row_l1_weights[row])) return row_quadratic_weights[row];
  return (elastic.on ? elastic.weight : options.limits.weight) * row_unit /
         (row_scales[row] * row_scales[row]);
}

/// Updates the violations of an iterate from its row values.
void DdpSolver::Impl::take_rows(Iterate& at) {
  at.violation = at.violation_cost = 0.0;
  at.breaks = false;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    const double v = violation_of(at.rows[i], low, high);
    if (v == 0.0 || is_fixed(k, r)) return;
    at.breaks = true;
    if (is_hard(row_l1_weights[i])) at.violation = std::max(at.violation, v / row_scales[i]);
    at.violation_cost += merit_weights[i] * v + 0.5 * quadratic_weight_of(i) * v * v;
  });
}

/// Sets the limits of controls and rows relative to the current iterate.
void DdpSolver::Impl::set_row_limits() {
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    const int nu = controls[i];
    std::fill_n(rows.weight, limited->places(), 0.0);
    const double* u = k < N ? current.us.data() + k * nu_max : nullptr;
    for (int c = 0; c < nu; ++c) {
      if (!is_bounded(k, c)) continue;
      const double low = std::max(lower[i][c], -beyond_all);
      const double high = std::min(upper[i][c], beyond_all);
      rows.lower[c] = low - u[c];
      rows.upper[c] = high - u[c];
      const double half = 0.5 * (high - low);
      rows.scale[c] = half > 0.0 && half < 0.5 * beyond_all
                          ? half
                          : std::max(1.0, std::min(std::abs(low), std::abs(high)));
      rows.weight[c] = 1.0 / (rows.scale[c] * rows.scale[c]);
      rows.l1_weight[c] = beyond_all;
      rows.beyond[c] = 0.0;
    }
  }
  for_each_row([&](int k, int /*row*/, std::size_t i, double low, double high) {
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    const int at = row_slots[i];
    rows.lower[at] = std::max(low, -beyond_all) - current.rows[i];
    rows.upper[at] = std::min(high, beyond_all) - current.rows[i];
    rows.scale[at] = row_scales[i];
    rows.weight[at] = row_inverses[i] * row_inverses[i];
  });
}

/// Returns the unit of the rows' weights: the mean curvature of the cost along the controls, with
/// each control in units of its scale.
double DdpSolver::Impl::curvature_unit() const {
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < N; ++k) {
    const auto i = to_size(k);
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    const double* unbounded = problem.control_scale(k);
    for (int c = 0; c < controls[i]; ++c) {
      const double other = unbounded != nullptr ? unbounded[c] : 1.0;
      const double scale = rows.weight[c] > 0.0 ? rows.scale[c] : other;
      sum += expansions[i].hessian[c * expansions[i].stride + c] * scale * scale;
      ++count;
    }
  }
  return count > 0 && sum > 0.0 ? sum / count : 1.0;
}

/// Sets `weight`, `l1_weight` and `beyond` of all rows (LimitedLq::Rows). The L1 weight of a row
/// without a multiplier is zero.
void DdpSolver::Impl::set_row_weights() {
  const double unit = cost_unit;
  if (row_unit == 0.0) row_unit = unit;
  // Bounds on controls use at least the elastic weight, so that quadratic penalties do not overrule
  // them.
  const double weight =
      elastic.on ? std::max(options.limits.weight, elastic.weight) : options.limits.weight;
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    for (int c = 0; c < controls[i]; ++c)
      if (is_bounded(k, c)) rows.weight[c] *= weight * unit;
  }
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    const int at = row_slots[i];
    rows.weight[at] *= options.limits.weight * unit;
    const double l1_weight = row_l1_weights[i];
    if (is_fixed(k, r)) {
      rows.weight[at] = rows.multiplier[at] = 0.0;
      return;
    }
    if (is_hard(l1_weight) && !elastic.on) {
      rows.beyond[at] = row_unit / (unit + row_unit);
      rows.l1_weight[at] = hard_l1_weight * row_unit * row_inverses[i];
      rows.multiplier[at] =
          std::clamp(rows.multiplier[at], -rows.l1_weight[at], rows.l1_weight[at]);
      return;
    }
    const double quadratic_weight = quadratic_weight_of(i);
    if (l1_weight == 0.0 || is_hard(l1_weight)) {
      rows.weight[at] = quadratic_weight;
      rows.beyond[at] = 1.0;
      rows.l1_weight[at] = rows.multiplier[at] = 0.0;
    } else {
      rows.beyond[at] = quadratic_weight / (rows.weight[at] + quadratic_weight);
      rows.l1_weight[at] = std::min(l1_weight, hard_l1_weight * row_unit * row_inverses[i]);
      rows.multiplier[at] =
          std::clamp(rows.multiplier[at], -rows.l1_weight[at], rows.l1_weight[at]);
    }
  });
}

/// Finds the rows of knot 0 that no control moves; only the initial state determines them.
void DdpSolver::Impl::find_fixed_rows() {
  const KnotExpansion& e = expansions[0];
  bool found = false;
  for (int r = 0; r < row_counts[0]; ++r) {
    const int slot = row_slots[to_size(r)];
    const double* row = e.rows + (slot - limited->first_row()) * e.stride;
    start_is_fixed[to_size(r)] =
        slot < limited->first_row()
            ? slot >= controls[0]
            : std::all_of(row, row + controls[0], [](double entry) { return entry == 0.0; });
    found = found || start_is_fixed[to_size(r)] != 0;
  }
  if (!found) return;
  if (current.breaks) take_rows(current);
  if (!best_is_current && best.breaks) take_rows(best);
}

bool DdpSolver::Impl::is_fixed(int knot, int row) const {
  return knot == 0 && start_is_fixed[to_size(row)] != 0;
}

/// Computes the direction, policies and value functions, with the active rows included.
bool DdpSolver::Impl::limited_backward() {
  find_fixed_rows();
  if (!solve_limited()) return false;
  const bool residual = !limited_result.converged && limited_result.residual > large_residual;
  elastic.lost = residual ? elastic.lost + 1 : 0;
  if (elastic.lost >= lost_patience && become_elastic() && !solve_limited()) return false;
  take_limited_step();
  return true;
}

/// Copies the direction from the solution of the linear-quadratic problem.
void DdpSolver::Impl::take_limited_step() {
  for (int k = 0; k <= N; ++k) {
    const int nu = controls[to_size(k)];
    const double* step = limited->z(k);
    std::copy_n(step + nu, ndx, dx(k));
    if (k < N) std::copy_n(step, nu, du(k));
  }
  point_policies();
}

/// Sets the feedforward of each policy so that the policy yields du at dx. This also holds after
/// the step (dx, du) has been scaled down.
void DdpSolver::Impl::point_policies() {
  for (int k = 0; k < N; ++k) {
    const PolicyStorage p = policy(k);
    for (int c = 0; c < controls[to_size(k)]; ++c)
      p.feedforward[c] = du(k)[c] - dense::dot(p.gain + c * gain_stride, dx(k), ndx);
  }
}

bool DdpSolver::Impl::solve_limited() {
  set_row_limits();
  add_curvatures();
  set_row_weights();
  return solve_limited_with(current.gaps.data(), options.limits.max_factorizations);
}

/// Solves the linear-quadratic problem with the current limits and weights.
bool DdpSolver::Impl::solve_limited_with(const double* gaps, int max_factorizations) {
  for (int k = 0; limited_before && k < N; ++k)
    std::fill_n(policy(k).feedforward, controls[to_size(k)], 0.0);
  const LqHorizon horizon{expansions,          controls,     coefficient_counts, gaps,
                          hessian_gaps.data(), value_stride, value_list,         policy_list,
                          regularization};
  limited_result = limited->solve(horizon, recursion,
                                  {.factorizations = max_factorizations,
                                   .sweeps = options.limits.max_sweeps,
                                   .interior_after = options.limits.interior_after,
                                   .tolerance = 0.1 * options.limits.tolerance},
                                  limited_before);
  if (limited_result.failed_knot >= 0) {
    summary.knot = limited_result.failed_knot;
    summary.control = limited_result.failed_control;
    forget_limits();
    return false;
  }
  limited_before = true;
  return true;
}

/// Raises the merit's L1 weights to 1.5 times the multipliers, but not above the rows' L1 weights.
/// Larger weights would treat violations within the tolerance as significant.
void DdpSolver::Impl::raise_merit_weights() {
  limit_resolution = 0.0;
  for_each_row([&](int k, int /*row*/, std::size_t i, double, double) {
    const double multiplier = std::abs(row_views[to_size(k)].multiplier[row_slots[i]]);
    if (multiplier == 0.0 && merit_weights[i] == 0.0) return;
    limit_resolution += multiplier * row_scales[i] * options.limits.tolerance;
    const double l1_weight = row_l1_weights[i];
    const double max_weight =
        is_hard(l1_weight) ? hard_l1_weight * row_unit * row_inverses[i] : l1_weight;
    merit_weights[i] = elastic.on && is_hard(l1_weight)
                           ? 0.0
                           : std::min(std::max(merit_weights[i], 1.5 * multiplier), max_weight);
  });
  if (current.breaks) take_rows(current);
  if (!best_is_current && best.breaks) take_rows(best);
}

/// Predicts the change of cost and merit for the whole step.
void DdpSolver::Impl::model_of_limited() {
  raise_merit_weights();
  direction.cost_slope = 0.0;
  double curvature = 0.0;
  for (int k = 0; k <= N; ++k) {
    const auto i = to_size(k);
    const KnotExpansion& e = expansions[i];
    const int nz = controls[i] + ndx;
    const double* zk = limited->z(k);
    direction.cost_slope += dense::dot(e.gradient, zk, nz);
    for (int r = 0; r < nz; ++r) {
      const double* row = e.hessian + r * e.stride;
      curvature += zk[r] * (2.0 * dense::dot(row, zk, r) + row[r] * zk[r]);
    }
  }
  double change = 0.0;
  for_each_row([&](int k, int /*row*/, std::size_t i, double low, double high) {
    const double before = violation_of(current.rows[i], low, high);
    const double after =
        violation_of(current.rows[i] + limited->values(k)[row_slots[i]], low, high);
    if (before == 0.0 && after == 0.0) return;
    change += merit_weights[i] * (after - before) +
              0.5 * quadratic_weight_of(i) * (after * after - before * before);
  });
  direction.model_change = direction.cost_slope + 0.5 * curvature;
  direction.curvature = curvature;
  direction.slope = direction.cost_slope + change;
  if (current.gap_sum > 0.0) {
    const double fraction = 1.0 - options.line_search.merit_fraction;
    const double needed =
        (direction.slope + 0.5 * std::max(0.0, curvature)) / (fraction * current.gap_sum);
    // Bounds the penalty by the multipliers, because `needed` is huge for gaps at rounding level.
    if (needed > penalty)
      penalty = std::max(penalty, std::min(needed, largest_multiplier() / fraction));
  }
  direction.slope -= penalty * current.gap_sum;
  merit_change = direction.slope + 0.5 * curvature;
}

/// Records the largest violation of a hard row in the returned trajectory. Counts the active rows,
/// and the hard rows whose multiplier has reached the L1 weight.
void DdpSolver::Impl::note_violation() {
  summary.violation = 0.0;
  summary.violation_knot = summary.violation_row = -1;
  summary.active_constraints = summary.unsatisfiable_rows = 0;
  summary.conflict.clear();
  summary.stopping.clear();
  note_start();
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    if (!is_hard(row_l1_weights[i])) return;
    const double v = violation_of(current.rows[i], low, high) / row_scales[i];
    if (v <= std::max(summary.violation, options.limits.tolerance)) return;
    summary.violation = v;
    summary.violation_knot = k;
    summary.violation_row = r;
  });
  // An active row without a multiplier has a quadratic penalty only.
  for_each_row([&](int k, int /*row*/, std::size_t i, double low, double high) {
    const int at = row_slots[i];
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    if (rows.l1_weight[at] == 0.0 && rows.weight[at] != 0.0)
      rows.multiplier[at] =
          quadratic_weight_of(i) * signed_violation_of(current.rows[i], low, high);
    const double multiplier_size = std::abs(row_multipliers[i] = rows.multiplier[at]);
    if (multiplier_size == 0.0) return;
    ++summary.active_constraints;
    summary.unsatisfiable_rows += is_hard(row_l1_weights[i]) && rows.l1_weight[at] != 0.0 &&
                                  multiplier_size >= (1.0 - 1e-9) * rows.l1_weight[at];
  });
  summary.constraint_residual = limited_result.residual;
  if (summary.reason == StopReason::Infeasible) note_conflict();
}

bool DdpSolver::Impl::accept_limited(double length) const {
  const LineSearch& rule = options.line_search;
  const double before = merit(current);
  return merit(trial) <= before + rule.merit_decrease * length * std::min(0.0, direction.slope) +
                             rule.rounding * std::abs(before);
}

}  // namespace burnish

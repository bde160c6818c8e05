// Rows with limits: what the linear-quadratic problem of an iteration is given, what its solution
// means for a step, and the merit that steps are judged by,
//   cost + penalty sum |gap|_1 + sum (price |v| + 1/2 square v^2)  over violations v of rows,
// with a price of at least the row's multiplier so far. It is exact: where prices are above the
// multipliers, its minimum is the solution.
//
// Hard rows have a price too, a high one, so that an iteration whose rows cannot all be kept has a
// direction; ddp_elastic.cpp has what follows where that price leaves some broken for good.
#include <algorithm>
#include <cmath>

#include "solver/ddp_impl.hpp"
#include "solver/dense.hpp"

namespace burnish {

namespace {
/// Limits stay open by so much, in their scale, for so many iterations, where they cannot be kept.
constexpr double wide_open = 1e-3;
constexpr int lost_patience = 20;
}  // namespace

void DdpSolver::Impl::allocate_rows() {
  rows_max = problem.max_rows();
  if (rows_max == 0) return;
  for (int k = 0; k <= N; ++k)
    if (problem.rows(k) > 0 &&
        (problem.row_lower(k) == nullptr || problem.row_upper(k) == nullptr ||
         problem.row_scale(k) == nullptr || problem.row_price(k) == nullptr ||
         problem.row_square(k) == nullptr))
      throw Error(problem.knot_name(k) +
                  " has rows without limits, scales, prices or squares; wanted all of them");
  limited = std::make_unique<LimitedLq>(state, N, nu_max, rows_max);
  row_counts.assign(static_cast<std::size_t>(N) + 1, 0);
  coefficient_counts = row_counts;
  row_lowers.assign(row_counts.size(), nullptr);
  row_uppers = row_lowers;
  for (int k = 0; k <= N; ++k) row_views.push_back(limited->rows(k));
  const auto all = static_cast<std::size_t>(N + 1) * static_cast<std::size_t>(rows_max);
  merit_prices.assign(all, 0.0);
  row_slots.assign(all, 0);
  for (auto* of_rows : {&row_scales, &row_inverses, &row_prices, &row_squares})
    of_rows->assign(all, 0.0);
  row_multipliers.assign(all, 0.0);
  summary.conflict.reserve(all);
  summary.stopping.reserve(all);
  summary.start_outside.reserve(static_cast<std::size_t>(rows_max));
  start_is_fixed.assign(static_cast<std::size_t>(rows_max), 0);
  allocate_correction();
  allocate_bends();
  for (Iterate* it : {&current, &trial, &best}) it->rows.assign(all, 0.0);
  const int stride = recursion.layout().expansion_stride;
  for (int k = 0; k <= N; ++k) {
    const auto i = static_cast<std::size_t>(k);
    row_memory.emplace_back(static_cast<std::size_t>(rows_max + dense::lanes) *
                            static_cast<std::size_t>(stride));
    expansions[i].rows = row_memory.back().data();
    value_list.push_back(value(k));
    policy_list.push_back(policy(k));
  }
}

void DdpSolver::Impl::start_rows() {
  if (!limited) return;
  place_rows();
  std::fill(merit_prices.begin(), merit_prices.end(), 0.0);
  merit_change = limit_resolution = row_unit = 0.0;
  elastic = {.weight = options.limits.price};
  hard_price = options.limits.price;
  refused = at_resolution = false;
  std::fill(start_is_fixed.begin(), start_is_fixed.end(), 0);
}

/// Rows that are entries of z have their places among those, the others behind them.
void DdpSolver::Impl::place_rows() {
  for (int k = 0; k <= N; ++k) {
    const auto i = static_cast<std::size_t>(k);
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
      row_inverses[static_cast<std::size_t>(r)] = 1.0 / row_scales[static_cast<std::size_t>(r)];
    std::copy_n(problem.row_price(k), row_counts[i], row_prices.begin() + first);
    std::copy_n(problem.row_square(k), row_counts[i], row_squares.begin() + first);
  }
}

bool DdpSolver::Impl::is_bounded(int knot, int control) const {
  const auto i = static_cast<std::size_t>(knot);
  return knot < N && lower[i] != nullptr && upper[i] != nullptr &&
         (lower[i][control] > -beyond_all || upper[i][control] < beyond_all);
}

/// Policies and multipliers of directions before.
void DdpSolver::Impl::forget_limits() noexcept {
  limited_before = false;
  limited->forget();
  std::fill(row_multipliers.begin(), row_multipliers.end(), 0.0);
}

/// Of a row of all.
double DdpSolver::Impl::square_of(std::size_t row) const {
  if (!is_hard(row_prices[row])) return row_squares[row];
  return (elastic.on ? elastic.weight : options.limits.weight) * row_unit /
         (row_scales[row] * row_scales[row]);
}

/// Violations of an iterate whose rows are known.
void DdpSolver::Impl::take_rows(Iterate& at) {
  at.outside = at.outside_cost = 0.0;
  at.breaks = false;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    const double v = outside_of(at.rows[i], low, high);
    if (v == 0.0 || is_fixed(k, r)) return;
    at.breaks = true;
    if (is_hard(row_prices[i])) at.outside = std::max(at.outside, v / row_scales[i]);
    at.outside_cost += merit_prices[i] * v + 0.5 * square_of(i) * v * v;
  });
}

/// Limits of the steps of controls and rows, about the current iterate.
void DdpSolver::Impl::set_row_limits() {
  for (int k = 0; k <= N; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
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
      rows.price[c] = beyond_all;
      rows.beyond[c] = 0.0;
    }
  }
  for_each_row([&](int k, int /*row*/, std::size_t i, double low, double high) {
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
    const int at = row_slots[i];
    rows.lower[at] = std::max(low, -beyond_all) - current.rows[i];
    rows.upper[at] = std::min(high, beyond_all) - current.rows[i];
    rows.scale[at] = row_scales[i];
    rows.weight[at] = row_inverses[i] * row_inverses[i];
  });
}

/// Weights are in units of the cost's curvature, which is that of the controls: the mean of
/// Huu scale^2.
double DdpSolver::Impl::curvature_unit() const {
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < N; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
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

/// Weights, prices and squares; where a row has no multiplier its price is zero.
void DdpSolver::Impl::set_row_weights() {
  const double unit = cost_unit;
  if (row_unit == 0.0) row_unit = unit;
  // Bounds on controls hold against squares: they push as hard.
  const double weight =
      elastic.on ? std::max(options.limits.weight, elastic.weight) : options.limits.weight;
  for (int k = 0; k <= N; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
    for (int c = 0; c < controls[i]; ++c)
      if (is_bounded(k, c)) rows.weight[c] *= weight * unit;
  }
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
    const int at = row_slots[i];
    rows.weight[at] *= options.limits.weight * unit;
    const double price = row_prices[i];
    if (is_fixed(k, r)) {
      rows.weight[at] = rows.multiplier[at] = 0.0;
      return;
    }
    if (is_hard(price) && !elastic.on) {
      rows.beyond[at] = row_unit / (unit + row_unit);
      rows.price[at] = hard_price * row_unit * row_inverses[i];
      rows.multiplier[at] = std::clamp(rows.multiplier[at], -rows.price[at], rows.price[at]);
      return;
    }
    const double square = square_of(i);
    if (price == 0.0 || is_hard(price)) {
      rows.weight[at] = square;
      rows.beyond[at] = 1.0;
      rows.price[at] = rows.multiplier[at] = 0.0;
    } else {
      rows.beyond[at] = square / (rows.weight[at] + square);
      rows.price[at] = std::min(price, hard_price * row_unit * row_inverses[i]);
      rows.multiplier[at] = std::clamp(rows.multiplier[at], -rows.price[at], rows.price[at]);
    }
  });
}

/// Rows of the first knot that no control moves, which the initial state decides.
void DdpSolver::Impl::find_fixed_rows() {
  const KnotExpansion& e = expansions[0];
  bool found = false;
  for (int r = 0; r < row_counts[0]; ++r) {
    const int slot = row_slots[static_cast<std::size_t>(r)];
    const double* row = e.rows + (slot - limited->first_row()) * e.stride;
    start_is_fixed[static_cast<std::size_t>(r)] =
        slot < limited->first_row()
            ? slot >= controls[0]
            : std::all_of(row, row + controls[0], [](double entry) { return entry == 0.0; });
    found = found || start_is_fixed[static_cast<std::size_t>(r)] != 0;
  }
  if (!found) return;
  if (current.breaks) take_rows(current);
  if (!best_is_current && best.breaks) take_rows(best);
}

bool DdpSolver::Impl::is_fixed(int knot, int row) const {
  return knot == 0 && start_is_fixed[static_cast<std::size_t>(row)] != 0;
}

/// The direction, with policies and value functions of the rows that push.
bool DdpSolver::Impl::limited_backward() {
  find_fixed_rows();
  if (!solve_limited()) return false;
  const bool open = !limited_result.converged && limited_result.open > wide_open;
  elastic.lost = open ? elastic.lost + 1 : 0;
  if (elastic.lost >= lost_patience && become_elastic() && !solve_limited()) return false;
  take_limited_step();
  return true;
}

/// The direction, from the solution of the linear-quadratic problem.
void DdpSolver::Impl::take_limited_step() {
  for (int k = 0; k <= N; ++k) {
    const int nu = controls[static_cast<std::size_t>(k)];
    const double* step = limited->z(k);
    std::copy_n(step + nu, ndx, dx(k));
    if (k < N) std::copy_n(step, nu, du(k));
  }
  point_policies();
}

/// Policies go through the direction, which may be shorter than their own.
void DdpSolver::Impl::point_policies() {
  for (int k = 0; k < N; ++k) {
    const PolicyStorage p = policy(k);
    for (int c = 0; c < controls[static_cast<std::size_t>(k)]; ++c)
      p.feedforward[c] = du(k)[c] - dense::dot(p.gain + c * gain_stride, dx(k), ndx);
  }
}

bool DdpSolver::Impl::solve_limited() {
  set_row_limits();
  add_bends();
  set_row_weights();
  return solve_limited_with(current.gaps.data(), options.limits.max_factors);
}

/// With limits and weights as they are set.
bool DdpSolver::Impl::solve_limited_with(const double* gaps, int max_factors) {
  for (int k = 0; limited_before && k < N; ++k)
    std::fill_n(policy(k).feedforward, controls[static_cast<std::size_t>(k)], 0.0);
  const LqHorizon horizon{expansions,          controls,     coefficient_counts, gaps,
                          hessian_gaps.data(), value_stride, value_list,         policy_list,
                          regularization};
  limited_result = limited->solve(horizon, recursion,
                                  {.factors = max_factors,
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

/// Prices of the merit follow the multipliers up, to those of the rows: what lies far above a
/// multiplier would weigh what is left of a violation, to the tolerance, as if it were one.
void DdpSolver::Impl::raise_prices() {
  limit_resolution = 0.0;
  for_each_row([&](int k, int /*row*/, std::size_t i, double, double) {
    const double multiplier =
        std::abs(row_views[static_cast<std::size_t>(k)].multiplier[row_slots[i]]);
    if (multiplier == 0.0 && merit_prices[i] == 0.0) return;
    limit_resolution += multiplier * row_scales[i] * options.limits.tolerance;
    const double price = row_prices[i];
    const double most = is_hard(price) ? hard_price * row_unit * row_inverses[i] : price;
    merit_prices[i] = elastic.on && is_hard(price)
                          ? 0.0
                          : std::min(std::max(merit_prices[i], 1.5 * multiplier), most);
  });
  if (current.breaks) take_rows(current);
  if (!best_is_current && best.breaks) take_rows(best);
}

/// What the model says of the whole step.
void DdpSolver::Impl::model_of_limited() {
  raise_prices();
  direction.cost_slope = 0.0;
  double curvature = 0.0;
  for (int k = 0; k <= N; ++k) {
    const auto i = static_cast<std::size_t>(k);
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
    const double before = outside_of(current.rows[i], low, high);
    const double after = outside_of(current.rows[i] + limited->values(k)[row_slots[i]], low, high);
    if (before == 0.0 && after == 0.0) return;
    change +=
        merit_prices[i] * (after - before) + 0.5 * square_of(i) * (after * after - before * before);
  });
  direction.model_change = direction.cost_slope + 0.5 * curvature;
  direction.curvature = curvature;
  direction.slope = direction.cost_slope + change;
  if (current.gap_sum > 0.0) {
    const double share = 1.0 - options.line_search.merit_share;
    const double needed =
        (direction.slope + 0.5 * std::max(0.0, curvature)) / (share * current.gap_sum);
    // Gaps of rounding alone ask for anything; more than the multipliers none does.
    if (needed > penalty)
      penalty = std::max(penalty, std::min(needed, largest_multiplier() / share));
  }
  direction.slope -= penalty * current.gap_sum;
  merit_change = direction.slope + 0.5 * curvature;
}

/// Where the trajectory that is returned breaks a hard limit most, and which rows push as hard as
/// those that are broken.
void DdpSolver::Impl::note_outside() {
  summary.outside = 0.0;
  summary.outside_knot = summary.outside_row = -1;
  summary.pushing = summary.given_way = 0;
  summary.conflict.clear();
  summary.stopping.clear();
  note_start();
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    if (!is_hard(row_prices[i])) return;
    const double v = outside_of(current.rows[i], low, high) / row_scales[i];
    if (v <= std::max(summary.outside, options.limits.tolerance)) return;
    summary.outside = v;
    summary.outside_knot = k;
    summary.outside_row = r;
  });
  // What pushes without a multiplier is a square.
  for_each_row([&](int k, int /*row*/, std::size_t i, double low, double high) {
    const int at = row_slots[i];
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
    if (rows.price[at] == 0.0 && rows.weight[at] != 0.0)
      rows.multiplier[at] = square_of(i) * signed_outside_of(current.rows[i], low, high);
    const double push = std::abs(row_multipliers[i] = rows.multiplier[at]);
    if (push == 0.0) return;
    ++summary.pushing;
    summary.given_way +=
        is_hard(row_prices[i]) && rows.price[at] != 0.0 && push >= (1.0 - 1e-9) * rows.price[at];
  });
  summary.limits_open = limited_result.open;
  if (summary.reason == StopReason::Infeasible) note_conflict();
}

bool DdpSolver::Impl::accept_limited(double length) const {
  const LineSearch& rule = options.line_search;
  const double before = merit(current);
  return merit(trial) <= before + rule.merit_decrease * length * std::min(0.0, direction.slope) +
                             rule.rounding * std::abs(before);
}

}  // namespace burnish

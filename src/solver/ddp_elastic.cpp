// Hard rows that stay broken. Where their price leaves some broken for good, hard rows become
// elastic: violations cost 1/2 S v^2 alone, without multipliers. Where that has a minimum S is
// raised. Violations that fall with S are those of a problem that can be solved: its multipliers
// are S v, and limits are hard again, at a higher price. Violations that stay are the least that
// there are.
//
// Where steps find no such minimum it is the linear model that decides: violations that stand still
// for some iterations, and that it does not lower with the largest price either, are stationary
// (Byrd, Curtis and Nocedal, Infeasibility detection and SQP methods for nonlinear optimization,
// SIAM J. Optim. 20 (2010), has the test).
#include <algorithm>
#include <cmath>

#include "solver/ddp_impl.hpp"

namespace burnish {

namespace {
/// By so much do violations fall that another, a hundred times larger weight is to thank for.
constexpr double fall = 0.1, raise = 100.0;
/// Violations stand still where the linear model leaves this share of their sum, and steps lower it
/// to no less than that one, in so many iterations in a row.
constexpr double share_left = 0.5, share_gained = 0.9;
constexpr int still_patience = 8;

}  // namespace

/// Hard rows lose their multipliers. False where they have, or where there are none.
bool DdpSolver::Impl::become_elastic() {
  if (elastic.on || elastic.weight > options.limits.largest_price) return false;
  bool any = false;
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    any = any || (is_hard(row_prices[i]) && !is_fixed(k, r));
  });
  if (!any) return false;
  elastic.on = true;
  limited_before = false;
  // Bounds' multipliers held against those that are gone.
  for (int k = 0; k < N; ++k)
    std::fill_n(row_views[static_cast<std::size_t>(k)].multiplier,
                controls[static_cast<std::size_t>(k)], 0.0);
  return true;
}

/// Near a minimum of the squares: limits are hard again, or the weight is larger. False where
/// neither helps or it is not near.
bool DdpSolver::Impl::after_elastic() {
  const double near = std::max(options.stop_tolerance, 1e-3 * current.outside_cost);
  if (elastic.stays || (summary.expected_improvement >= near && !is_still())) return false;
  elastic.still = 0;
  const double before = elastic.violation, now = current.outside;
  const bool kept = keeps_limits(current), falls = before > 0.0 && now < fall * before;
  elastic.violation = now;
  elastic.stays = !kept && !falls && elastic.weight * raise > options.limits.largest_price;
  if (elastic.stays) return false;
  if (kept || falls) {
    for_each_row([&](int k, int r, std::size_t i, double low, double high) {
      if (!is_hard(row_prices[i]) || is_fixed(k, r)) return;
      row_views[static_cast<std::size_t>(k)].multiplier[row_slots[i]] =
          square_of(i) * signed_outside_of(current.rows[i], low, high);
    });
    elastic.on = false;
    elastic.lost = elastic.stood = 0;
    hard_price *= raise;
  }
  elastic.weight *= raise;
  return true;
}

/// Whether squares of violations have their minimum, and no larger weight would make them less.
bool DdpSolver::Impl::is_least_violation() const {
  return elastic.stays && (is_still() || summary.expected_improvement <
                                             options.stop_tolerance + 1e-9 * current.outside_cost);
}

DdpSolver::Impl::Violations DdpSolver::Impl::violations() const {
  Violations sums;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    if (!is_hard(row_prices[i]) || is_fixed(k, r)) return;
    const double value = current.rows[i], change = limited->values(k)[row_slots[i]];
    sums.now += outside_of(value, low, high) * row_inverses[i];
    sums.after += outside_of(value + change, low, high) * row_inverses[i];
  });
  return sums;
}

void DdpSolver::Impl::note_stillness() {
  if (keeps_limits(current)) {
    elastic.still = 0;
    return;
  }
  const Violations sums = violations();
  if (sums.after < share_left * sums.now) {
    elastic.still = 0;
  } else if (elastic.still == 0 || sums.now < share_gained * elastic.still_from) {
    elastic.still = 1;
    elastic.still_from = sums.now;
  } else {
    ++elastic.still;
  }
}

bool DdpSolver::Impl::is_still() const { return elastic.still >= still_patience; }

/// Whether the linear model lowers violations where nothing else counts, with the largest price. A
/// trajectory where it does not is a stationary point of the violations.
bool DdpSolver::Impl::violations_can_fall() {
  elastic.still = 0;
  if (hard_price >= options.limits.largest_price) return false;
  hard_price = options.limits.largest_price;
  limited_before = false;
  if (!solve_limited()) return true;
  const Violations sums = violations();
  return sums.after < share_left * sums.now;
}

/// Violations cost squares: whether this is the least that there is. `again` asks for a direction
/// with other weights.
bool DdpSolver::Impl::ends_elastic(bool& again) {
  if (!current.feasible && !is_still()) return false;
  again = after_elastic();
  return !again && is_least_violation();
}

/// Whether violations stand still that nothing lowers. `again` asks for a direction with the
/// largest price, which does.
bool DdpSolver::Impl::ends_still(bool& again) {
  if (!is_still() || options.limits.largest_price < options.limits.price) return false;
  again = violations_can_fall();
  return !again;
}

/// Rolls the iterate out with its gains, where states do not yet follow from the controls and
/// nothing better is to come.
void DdpSolver::Impl::close_gaps() {
  if (current.feasible) return;
  for (int k = 0; k < N; ++k)
    std::fill_n(policy(k).feedforward, controls[static_cast<std::size_t>(k)], 0.0);
  double gap_improvement = 0.0;
  if (!roll_trial(1.0, gap_improvement)) return;
  std::swap(current, trial);
  current.feasible = true;
  current.largest_gap = 0.0;
  current.gap_knot = current.gap_entry = 0;
  expanded = false;
  best_is_current = true;
}

/// The rows that are broken, and those that push against them: by their scales at least a hundredth
/// of what the largest one does.
void DdpSolver::Impl::note_conflict() {
  constexpr double least_share = 0.01;
  const auto violation = [&](const RowPlace& place) {
    const auto k = static_cast<std::size_t>(place.knot);
    const auto i = static_cast<std::size_t>(place.knot * rows_max + place.row);
    return outside_of(current.rows[i], row_lowers[k][place.row], row_uppers[k][place.row]) /
           row_scales[i];
  };
  const auto push = [&](const RowPlace& place) {
    const auto i = static_cast<std::size_t>(place.knot * rows_max + place.row);
    return std::abs(row_multipliers[i]) * row_scales[i];
  };
  double most = 0.0;
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    if (is_hard(row_prices[i])) most = std::max(most, push({k, r}));
  });
  const double least = std::max(least_share * current.outside, options.limits.tolerance);
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    if (!is_hard(row_prices[i])) return;
    const RowPlace place{k, r};
    if (violation(place) > least)
      summary.conflict.push_back(place);
    else if (push(place) > least_share * most)
      summary.stopping.push_back(place);
  });
  std::sort(summary.conflict.begin(), summary.conflict.end(),
            [&](const RowPlace& a, const RowPlace& b) { return violation(a) > violation(b); });
  std::sort(summary.stopping.begin(), summary.stopping.end(),
            [&](const RowPlace& a, const RowPlace& b) { return push(a) > push(b); });
}

/// The hard rows that the initial state alone breaks.
void DdpSolver::Impl::note_start() {
  summary.start_outside.clear();
  for (int r = 0; r < row_counts[0]; ++r) {
    const auto i = static_cast<std::size_t>(r);
    const double low = row_lowers[0][r], high = row_uppers[0][r];
    if (is_fixed(0, r) && is_hard(row_prices[i]) &&
        outside_of(current.rows[i], low, high) > options.limits.tolerance * row_scales[i])
      summary.start_outside.push_back({r, current.rows[i], low, high});
  }
}

/// Whether the initial state alone breaks a hard limit.
bool DdpSolver::Impl::starts_outside() const {
  bool found = false;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    found = found ||
            (is_fixed(k, r) && is_hard(row_prices[i]) &&
             outside_of(current.rows[i], low, high) > options.limits.tolerance * row_scales[i]);
  });
  return found;
}

}  // namespace burnish

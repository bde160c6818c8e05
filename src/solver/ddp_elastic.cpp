// Elastic mode: hard rows that the solver cannot satisfy.
//
// If some hard rows stay violated at their L1 weight, all hard rows become elastic: a violation v
// costs only 1/2 S v^2, without multipliers. At a minimum of this cost, the solver raises S. If the
// violations decrease with S, the problem can be solved: the multipliers are S v, and the rows
// become hard again with a larger L1 weight. If the violations do not decrease, they are the
// smallest possible ones.
//
// If the steps find no such minimum, a test on the linear model decides whether the violations are
// the smallest possible ones. They are, if they do not decrease for some iterations, and the linear
// model does not reduce them with the largest L1 weight either (test of Byrd, Curtis and Nocedal,
// Infeasibility detection and SQP methods for nonlinear optimization, SIAM J. Optim. 20 (2010)).
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"

namespace burnish {

namespace {
/// An increase of the penalty weight by the factor `raise` counts as effective if less than the
/// fraction `fall` of the violations remains. Chosen by hand.
constexpr double fall = 0.1, raise = 100.0;
/// Violations stand still if two conditions hold in `still_patience` consecutive iterations. The
/// linear model predicts that at least the fraction `still_fraction` of the sum of violations
/// remains. The sum is at least the fraction `still_decrease` of its first value. Chosen by hand.
constexpr double still_fraction = 0.5, still_decrease = 0.9;
constexpr int still_patience = 8;

}  // namespace

/// Begins elastic mode. Returns false if it is on, its weight is too large, or no row is hard.
bool DdpSolver::Impl::become_elastic() {
  if (elastic.on || elastic.weight > options.limits.max_l1_weight) return false;
  bool has_hard_row = false;
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    has_hard_row = has_hard_row || (is_hard(row_l1_weights[i]) && !is_fixed(k, r));
  });
  if (!has_hard_row) return false;
  elastic.on = true;
  limited_before = false;
  // Elastic mode drops the multipliers of rows. It also drops the multipliers of control bounds,
  // which balanced the multipliers of rows.
  for (int k = 0; k < N; ++k)
    std::fill_n(row_views[to_size(k)].multiplier, controls[to_size(k)], 0.0);
  return true;
}

/// Acts at a minimum of the quadratic penalty: makes rows hard again or raises the weight. Returns
/// false if neither helps or the iterate is not near a minimum.
bool DdpSolver::Impl::after_elastic() {
  const double near = std::max(options.stop_tolerance, 1e-3 * current.violation_cost);
  if (elastic.stays || (summary.expected_improvement >= near && !is_still())) return false;
  elastic.still = 0;
  const double before = elastic.violation, now = current.violation;
  const bool kept = keeps_limits(current), falls = before > 0.0 && now < fall * before;
  elastic.violation = now;
  elastic.stays = !kept && !falls && elastic.weight * raise > options.limits.max_l1_weight;
  if (elastic.stays) return false;
  if (kept || falls) {
    for_each_row([&](int k, int r, std::size_t i, double low, double high) {
      if (!is_hard(row_l1_weights[i]) || is_fixed(k, r)) return;
      row_views[to_size(k)].multiplier[row_slots[i]] =
          quadratic_weight_of(i) * signed_violation_of(current.rows[i], low, high);
    });
    elastic.on = false;
    elastic.lost = elastic.stood = 0;
    hard_l1_weight *= raise;
  }
  elastic.weight *= raise;
  return true;
}

/// Returns whether the quadratic penalty has its minimum and a larger weight would not reduce the
/// violations.
bool DdpSolver::Impl::is_least_violation() const {
  return elastic.stays &&
         (is_still() ||
          summary.expected_improvement < options.stop_tolerance + 1e-9 * current.violation_cost);
}

DdpSolver::Impl::Violations DdpSolver::Impl::violations() const {
  Violations sums;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    if (!is_hard(row_l1_weights[i]) || is_fixed(k, r)) return;
    const double value = current.rows[i], change = limited->values(k)[row_slots[i]];
    sums.now += violation_of(value, low, high) * row_inverses[i];
    sums.after += violation_of(value + change, low, high) * row_inverses[i];
  });
  return sums;
}

void DdpSolver::Impl::note_stillness() {
  if (keeps_limits(current)) {
    elastic.still = 0;
    return;
  }
  const Violations sums = violations();
  if (sums.after < still_fraction * sums.now) {
    elastic.still = 0;
  } else if (elastic.still == 0 || sums.now < still_decrease * elastic.still_from) {
    elastic.still = 1;
    elastic.still_from = sums.now;
  } else {
    ++elastic.still;
  }
}

bool DdpSolver::Impl::is_still() const { return elastic.still >= still_patience; }

/// Returns whether the linear model with the largest L1 weight reduces the violations. If not, the
/// trajectory is a stationary point of the violations.
bool DdpSolver::Impl::violations_can_fall() {
  elastic.still = 0;
  if (hard_l1_weight >= options.limits.max_l1_weight) return false;
  hard_l1_weight = options.limits.max_l1_weight;
  limited_before = false;
  if (!solve_limited()) return true;
  const Violations sums = violations();
  return sums.after < still_fraction * sums.now;
}

/// Elastic mode: returns whether the violations are the smallest possible ones. `again` requests a
/// direction with other weights.
bool DdpSolver::Impl::ends_elastic(bool& again) {
  if (!current.feasible && !is_still()) return false;
  again = after_elastic();
  return !again && is_least_violation();
}

/// Returns whether the violations stand still and cannot be reduced. If the largest L1 weight
/// reduces them, sets `again` to request a direction with this weight.
bool DdpSolver::Impl::ends_still(bool& again) {
  if (!is_still() || options.limits.max_l1_weight < options.limits.l1_weight) return false;
  again = violations_can_fall();
  return !again;
}

/// Rolls the iterate out with its gains if it has gaps. Called when no better trajectory will
/// follow.
void DdpSolver::Impl::close_gaps() {
  if (current.feasible) return;
  for (int k = 0; k < N; ++k) std::fill_n(policy(k).feedforward, controls[to_size(k)], 0.0);
  double gap_improvement = 0.0;
  if (!roll_trial(1.0, gap_improvement)) return;
  std::swap(current, trial);
  current.feasible = true;
  current.largest_gap = 0.0;
  current.gap_knot = current.gap_entry = 0;
  expanded = false;
  best_is_current = true;
}

/// Lists the violated rows, and the active rows that keep the violations from decreasing. An active
/// row does so if its scaled multiplier is at least one hundredth of the largest one.
void DdpSolver::Impl::note_conflict() {
  constexpr double min_fraction = 0.01;
  const auto violation = [&](const RowPlace& place) {
    const auto k = to_size(place.knot);
    const auto i = to_size(place.knot * rows_max + place.row);
    return violation_of(current.rows[i], row_lowers[k][place.row], row_uppers[k][place.row]) /
           row_scales[i];
  };
  const auto multiplier_size = [&](const RowPlace& place) {
    const auto i = to_size(place.knot * rows_max + place.row);
    return std::abs(row_multipliers[i]) * row_scales[i];
  };
  double max_multiplier = 0.0;
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    if (is_hard(row_l1_weights[i]))
      max_multiplier = std::max(max_multiplier, multiplier_size({k, r}));
  });
  const double min_violation = std::max(min_fraction * current.violation, options.limits.tolerance);
  for_each_row([&](int k, int r, std::size_t i, double, double) {
    if (!is_hard(row_l1_weights[i])) return;
    const RowPlace place{k, r};
    if (violation(place) > min_violation)
      summary.conflict.push_back(place);
    else if (multiplier_size(place) > min_fraction * max_multiplier)
      summary.stopping.push_back(place);
  });
  std::sort(summary.conflict.begin(), summary.conflict.end(),
            [&](const RowPlace& a, const RowPlace& b) { return violation(a) > violation(b); });
  std::sort(summary.stopping.begin(), summary.stopping.end(),
            [&](const RowPlace& a, const RowPlace& b) {
              return multiplier_size(a) > multiplier_size(b);
            });
}

/// Lists the hard rows that the initial state violates whatever the control.
void DdpSolver::Impl::note_start() {
  summary.start_violations.clear();
  for (int r = 0; r < row_counts[0]; ++r) {
    const auto i = to_size(r);
    const double low = row_lowers[0][r], high = row_uppers[0][r];
    if (is_fixed(0, r) && is_hard(row_l1_weights[i]) &&
        violation_of(current.rows[i], low, high) > options.limits.tolerance * row_scales[i])
      summary.start_violations.push_back({r, current.rows[i], low, high});
  }
}

/// Returns whether the initial state violates a hard row whatever the control.
bool DdpSolver::Impl::starts_violated() const {
  bool found = false;
  for_each_row([&](int k, int r, std::size_t i, double low, double high) {
    found = found ||
            (is_fixed(k, r) && is_hard(row_l1_weights[i]) &&
             violation_of(current.rows[i], low, high) > options.limits.tolerance * row_scales[i]);
  });
  return found;
}

}  // namespace burnish

// The linear-quadratic problem with limits from nothing: predictor and corrector steps of an
// interior-point method (Mehrotra; Nocedal and Wright, Numerical Optimization (2006), algorithm
// 16.4) with the recursion's factors, as many of them whether few rows push or most. What it ends
// with tells the semismooth steps which rows push, and nearly how hard.
#include <algorithm>

#include "solver/dense.hpp"
#include "solver/limited_lq.hpp"

namespace burnish {

using dense::Lane;
using dense::lanes;
using dense::load;
using dense::store;

namespace {

/// Products of the first step, in units of a row's weight times the square of its scale.
constexpr double start_share = 1.0;
/// Done when products have fallen by so much, and rows are as near their slacks in their scale.
constexpr double enough = 1e-8;
/// Of their weights, that equalities have at the start, and at most: their multipliers are right
/// the sooner the more that is.
constexpr double heavier = 100.0, heaviest = 1e6;
constexpr int most_steps = 40;
constexpr double shortest = 1e-8, kept_back = 0.995;

}  // namespace

template <class Function>
void LimitedLq::for_each_vector(const LqHorizon& h, const Function& function) const {
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    for (int r = 0; r < vectors_end(h, k); r += lanes)
      function(mine, mine.arrays(), r, k * row_count_ + r);
  }
}

/// Where to: from the trajectory that nothing limits.
bool LimitedLq::begin_interior(const LqHorizon& h, RiccatiRecursion& recursion, double& mu,
                               LimitedLqResult& result) {
  Lane sum(0.0), count(0.0);
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int /*at*/) {
    const Lane scale = load(mine.scale + r), weight = load(rows.weight + r);
    const auto has_one = mask_and(less(Lane(0.0), weight), less(Lane(0.0), load(rows.price + r)));
    sum += select(has_one, weight * scale * scale, Lane(0.0));
    count += select(has_one, Lane(1.0), Lane(0.0));
  });
  double total = 0.0, rows_with_one = 0.0;
  for (int l = 0; l < lanes; ++l) {
    total += sum.lane(l);
    rows_with_one += count.lane(l);
  }
  mu = start_share * total / std::max(1.0, rows_with_one);
  if (!(mu > 0.0)) return false;
  for (const Knot& k : knots_) {
    std::fill_n(k.z, stride_, 0.0);
    std::fill_n(k.y, row_count_, 0.0);
  }
  keep();
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), mu);
  });
  if (!interior_step(h, recursion, {.equality = heavier}, result)) return false;
  mu = mean_product(h, 1.0);
  keep();
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), mu);
  });
  return true;
}

/// A trajectory and the rows' steps to it.
bool LimitedLq::interior_step(const LqHorizon& h, RiccatiRecursion& recursion,
                              const InteriorRows::Target& target, LimitedLqResult& result) {
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    const RowLines lines = interior_.lines(at, rows, r, load(mine.y_before + r), target);
    store(mine.slope + r, lines.slope);
    store(mine.offset + r, lines.offset);
  });
  if (target.corrected)
    sweep(h, recursion);
  else if (!factor(h, recursion, N_, result))
    return false;
  follow_policy(h);
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.take_direction(at, rows, r, load(mine.y_before + r), load(mine.y + r), target);
  });
  return true;
}

/// The length that keeps all of them above zero.
double LimitedLq::interior_length(const LqHorizon& h) const {
  double steepest = 0.0;
  for_each_vector(h, [&](const Knot&, const RowArrays&, int, int at) {
    const Lane here = interior_.steepest(at);
    for (int l = 0; l < lanes; ++l) steepest = std::max(steepest, here.lane(l));
  });
  return steepest > 1.0 ? 1.0 / steepest : 1.0;
}

double LimitedLq::mean_product(const LqHorizon& h, double length) const {
  InteriorRows::Products all{Lane(0.0), Lane(0.0)};
  for_each_vector(h, [&](const Knot&, const RowArrays&, int, int at) {
    const InteriorRows::Products here = interior_.products(at, length);
    all.sum += here.sum;
    all.count += here.count;
  });
  double sum = 0.0, count = 0.0;
  for (int l = 0; l < lanes; ++l) {
    sum += all.sum.lane(l);
    count += all.count.lane(l);
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// Multipliers and pieces of the interior-point method. False where the recursion fails.
bool LimitedLq::approach(const LqHorizon& h, RiccatiRecursion& recursion,
                         const LimitedLqBudget& budget, LimitedLqResult& result) {
  double begun = 0.0, left = 1.0;
  if (!begin_interior(h, recursion, begun, result)) return result.failed_knot < 0;
  double mu = mean_product(h, 0.0);
  for (int step = 0; step < most_steps && result.factors < budget.factors; ++step) {
    if (mu <= enough * begun && left <= enough) break;
    const double equality = std::min(heaviest, heavier * begun / mu);
    if (!interior_step(h, recursion, {.equality = equality}, result)) return false;
    const double share = mean_product(h, interior_length(h)) / mu;
    if (!interior_step(h, recursion, {share * share * share * mu, true, equality}, result))
      return false;
    const double length = std::min(1.0, kept_back * interior_length(h));
    if (!(length > shortest)) break;
    blend(length);
    for_each_vector(
        h, [&](const Knot&, const RowArrays&, int, int at) { interior_.advance(at, length); });
    keep();
    left *= 1.0 - length;
    mu = mean_product(h, 0.0);
  }
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    const Lane price = load(rows.price + r);
    const auto has_one = mask_and(less(Lane(0.0), load(rows.weight + r)), less(Lane(0.0), price));
    store(mine.multiplier + r, select(has_one, clip(interior_.multiplier(at), -price, price),
                                      load(mine.multiplier + r)));
  });
  return true;
}

}  // namespace burnish

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
/// Steps below this length, so many in a row, get nowhere.
constexpr double short_length = 0.1;
constexpr int short_patience = 3;
/// Steps at most from then on that products are small.
constexpr int most_after = 10;

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
bool LimitedLq::begin_interior(const LqHorizon& h, RiccatiRecursion& recursion, bool outside,
                               double& mu, LimitedLqResult& result) {
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
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), mu, false);
  });
  if (!interior_step(h, recursion, {.equality = heavier}, result)) return false;
  mu = mean_product(h, 1.0);
  keep();
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), mu, outside);
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

/// Trajectory, multipliers and pieces of the interior-point method, which are kept. False, with the
/// first two as they were, where it does not end.
bool LimitedLq::approach(const LqHorizon& h, RiccatiRecursion& recursion, LimitedLqResult& result) {
  keep_solution();
  const int factors_before = result.factors;
  Steps steps = interior_steps(h, recursion, false, result);
  if (steps == Steps::Short) steps = interior_steps(h, recursion, true, result);
  const bool done = steps == Steps::Done;
  result.interior += result.factors - factors_before;
  result.failed_knot = result.failed_control = -1;
  result.approached = result.approached || done;
  if (done)
    keep_solution();
  else
    take_kept(h);
  result.interior_open = left_open(h);
  return done;
}

void LimitedLq::keep_solution() {
  for (const Knot& k : knots_) {
    dense::copy(k.z, stride_, k.z_kept);
    dense::copy(k.multiplier, row_count_, k.multiplier_kept);
    dense::copy(k.piece, row_count_, k.piece_kept);
  }
}

void LimitedLq::take_kept(const LqHorizon& h) {
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    dense::copy(mine.z_kept, stride_, mine.z);
    dense::copy(mine.multiplier_kept, row_count_, mine.multiplier);
    dense::copy(mine.piece_kept, row_count_, mine.piece);
    row_values(h, k);
  }
}

/// Multipliers, and the pieces that rows go to; the last step's length is `length`. Returns by how
/// much pieces have changed, summed.
double LimitedLq::take_interior_rows(const LqHorizon& h, double length) {
  Lane changed(0.0);
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    const Lane price = load(rows.price + r), zero(0.0);
    const auto has_one = mask_and(less(zero, load(rows.weight + r)), less(zero, price));
    const Lane piece = interior_.piece(at, rows, r, length), multiplier = interior_.multiplier(at);
    const auto broken = less(Lane(1.0), absolute(piece));
    // Beyond the price is the square of the violation.
    const Lane beyond = larger(price, absolute(multiplier));
    const Lane at_price = select(less(zero, piece), beyond, -beyond);
    const Lane pushing = select(broken, at_price, clip(multiplier, -price, price));
    const auto pushes = less(zero, absolute(piece));
    store(mine.multiplier + r,
          select(has_one, select(pushes, pushing, zero), load(mine.multiplier + r)));
    changed += absolute(piece - load(mine.piece + r));
    store(mine.piece + r, piece);
  });
  double sum = 0.0;
  for (int l = 0; l < lanes; ++l) sum += changed.lane(l);
  return sum;
}

/// A step of predictor and corrector, and its length; 0 where there is none.
double LimitedLq::advance_interior(const LqHorizon& h, RiccatiRecursion& recursion, double mu,
                                   double equality, LimitedLqResult& result) {
  if (!interior_step(h, recursion, {.equality = equality}, result)) return 0.0;
  const double share = mean_product(h, interior_length(h)) / mu;
  if (!interior_step(h, recursion, {share * share * share * mu, true, equality}, result))
    return 0.0;
  const double length = std::min(1.0, kept_back * interior_length(h));
  if (!(length > shortest)) return 0.0;
  blend(length);
  for_each_vector(
      h, [&](const Knot&, const RowArrays&, int, int at) { interior_.advance(at, length); });
  keep();
  return length;
}

/// Steps until products and distances from slacks are small, and on until the pieces that rows go
/// to are those of the step before; where they do not become so, those of the step that changed
/// fewest are taken. Short: some in a row are, since violations begin far below what they have to
/// be; nothing is lost with a start that has them.
LimitedLq::Steps LimitedLq::interior_steps(const LqHorizon& h, RiccatiRecursion& recursion,
                                           bool outside, LimitedLqResult& result) {
  double begun = 0.0, left = 1.0;
  if (!begin_interior(h, recursion, outside, begun, result)) return Steps::Failed;
  double mu = mean_product(h, 0.0);
  int in_a_row = 0, after = 0;
  double fewest = 0.0;  // changes of pieces
  for (int step = 0; step < most_steps && after <= most_after; ++step) {
    const double equality = std::min(heaviest, heavier * begun / mu);
    const double length = advance_interior(h, recursion, mu, equality, result);
    if (length == 0.0) break;
    left *= 1.0 - length;
    mu = mean_product(h, 0.0);
    if (mu <= enough * begun && left <= enough) {
      const double changes = take_interior_rows(h, length);
      if (changes == 0.0) return Steps::Done;
      if (after++ == 0 || changes <= fewest) {
        fewest = changes;
        keep_solution();
      }
    }
    in_a_row = length < short_length ? in_a_row + 1 : 0;
    if (in_a_row == short_patience && !outside && after == 0) return Steps::Short;
  }
  if (after == 0) return Steps::Failed;
  take_kept(h);
  return Steps::Done;
}

}  // namespace burnish

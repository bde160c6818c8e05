// Interior-point method for a cold start of the linear-quadratic problem with limits: predictor and
// corrector steps (Mehrotra; Nocedal and Wright, Numerical Optimization (2006), algorithm 16.4),
// computed by the Riccati recursion. The number of factorizations hardly depends on the number of
// active rows. The semismooth steps start from the resulting active rows and approximate
// multipliers.
#include <algorithm>

#include "solver/dense.hpp"
#include "solver/limited_lq.hpp"

namespace burnish {

using dense::Lane;
using dense::lanes;
using dense::load;
using dense::store;

namespace {

/// Initial products s m and v n (interior_rows.hpp), divided by the mean of weight * scale^2 over
/// the rows. The constants below are chosen by hand.
constexpr double start_product = 1.0;
/// Largest ratio of products and residuals to their initial values that counts as convergence.
constexpr double convergence = 1e-8;
/// Initial and largest factor on the weights of equality rows. Larger weights give accurate
/// multipliers sooner.
constexpr double equality_start = 100.0, equality_max = 1e6;
constexpr int max_steps = 40;
constexpr double min_length = 1e-8, boundary_fraction = 0.995;
/// The method makes no progress if `short_patience` consecutive steps are shorter than this.
constexpr double short_length = 0.1;
constexpr int short_patience = 3;
/// Maximum number of steps after the products have become small.
constexpr int max_steps_after = 10;

}  // namespace

template <class Function>
void LimitedLq::for_each_vector(const LqHorizon& h, const Function& function) const {
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    for (int r = 0; r < vectors_end(h, k); r += lanes)
      function(mine, mine.arrays(), r, k * row_count_ + r);
  }
}

/// Computes the initial point, from the trajectory without limits.
bool LimitedLq::begin_interior(const LqHorizon& h, RiccatiRecursion& recursion, bool infeasible,
                               double& mu, LimitedLqResult& result) {
  Lane sum(0.0), count(0.0);
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int /*at*/) {
    const Lane scale = load(mine.scale + r), weight = load(rows.weight + r);
    const auto has_one =
        mask_and(less(Lane(0.0), weight), less(Lane(0.0), load(rows.l1_weight + r)));
    sum += select(has_one, weight * scale * scale, Lane(0.0));
    count += select(has_one, Lane(1.0), Lane(0.0));
  });
  double total = 0.0, rows_with_one = 0.0;
  for (int l = 0; l < lanes; ++l) {
    total += sum.lane(l);
    rows_with_one += count.lane(l);
  }
  mu = start_product * total / std::max(1.0, rows_with_one);
  if (!(mu > 0.0)) return false;
  for (const Knot& k : knots_) {
    std::fill_n(k.z, stride_, 0.0);
    std::fill_n(k.y, row_count_, 0.0);
  }
  keep();
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), {.mu = mu});
  });
  if (!interior_step(h, recursion, {.equality = equality_start}, result)) return false;
  mu = mean_product(h, 1.0);
  keep();
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    interior_.start(at, rows, r, load(mine.scale + r), load(mine.y_before + r), {mu, infeasible});
  });
  return true;
}

/// Computes the trajectory of a Newton step and the rows' steps.
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

/// Returns the step length that keeps all row variables positive.
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

/// Runs the interior-point method and keeps its trajectory, multipliers and pieces. If the method
/// fails, returns false and restores trajectory and multipliers.
bool LimitedLq::approach(const LqHorizon& h, RiccatiRecursion& recursion, LimitedLqResult& result) {
  keep_solution();
  const int factorizations_before = result.factorizations;
  Steps steps = interior_steps(h, recursion, false, result);
  if (steps == Steps::Short) steps = interior_steps(h, recursion, true, result);
  const bool done = steps == Steps::Done;
  result.interior += result.factorizations - factorizations_before;
  result.failed_knot = result.failed_control = -1;
  result.approached = result.approached || done;
  if (done)
    keep_solution();
  else
    take_kept(h);
  result.interior_residual = residual_left(h);
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

/// Takes multipliers and pieces from the row variables after a step of length `length`. Returns the
/// sum of the absolute changes of the pieces.
double LimitedLq::take_interior_rows(const LqHorizon& h, double length) {
  Lane changed(0.0);
  for_each_vector(h, [&](const Knot& mine, const RowArrays& rows, int r, int at) {
    const Lane l1_weight = load(rows.l1_weight + r), zero(0.0);
    const auto has_one = mask_and(less(zero, load(rows.weight + r)), less(zero, l1_weight));
    const Lane piece = interior_.piece(at, rows, r, length), multiplier = interior_.multiplier(at);
    const auto broken = less(Lane(1.0), absolute(piece));
    // Beyond the L1 weight, the multiplier includes the quadratic penalty.
    const Lane beyond = larger(l1_weight, absolute(multiplier));
    const Lane at_l1_weight = select(less(zero, piece), beyond, -beyond);
    const Lane active_constraints =
        select(broken, at_l1_weight, clip(multiplier, -l1_weight, l1_weight));
    const auto active = less(zero, absolute(piece));
    store(mine.multiplier + r,
          select(has_one, select(active, active_constraints, zero), load(mine.multiplier + r)));
    changed += absolute(piece - load(mine.piece + r));
    store(mine.piece + r, piece);
  });
  double sum = 0.0;
  for (int l = 0; l < lanes; ++l) sum += changed.lane(l);
  return sum;
}

/// Makes a predictor and corrector step. Returns its length; 0 if the step fails.
double LimitedLq::advance_interior(const LqHorizon& h, RiccatiRecursion& recursion, double mu,
                                   double equality, LimitedLqResult& result) {
  if (!interior_step(h, recursion, {.equality = equality}, result)) return 0.0;
  const double ratio = mean_product(h, interior_length(h)) / mu;
  if (!interior_step(h, recursion, {ratio * ratio * ratio * mu, true, equality}, result))
    return 0.0;
  const double length = std::min(1.0, boundary_fraction * interior_length(h));
  if (!(length > min_length)) return 0.0;
  blend(length);
  for_each_vector(
      h, [&](const Knot&, const RowArrays&, int, int at) { interior_.advance(at, length); });
  keep();
  return length;
}

/// Makes steps until products and residuals are small, then until the pieces no longer change. If
/// the pieces keep changing, takes the step with the fewest changes.
/// Returns Short after several consecutive short steps. Steps are short if violations started far
/// below their final values; then a second start with the actual violations can help.
LimitedLq::Steps LimitedLq::interior_steps(const LqHorizon& h, RiccatiRecursion& recursion,
                                           bool infeasible, LimitedLqResult& result) {
  double begun = 0.0, left = 1.0;
  if (!begin_interior(h, recursion, infeasible, begun, result)) return Steps::Failed;
  double mu = mean_product(h, 0.0);
  int in_a_row = 0, after = 0;
  double fewest = 0.0;  // changes of pieces
  for (int step = 0; step < max_steps && after <= max_steps_after; ++step) {
    const double equality = std::min(equality_max, equality_start * begun / mu);
    const double length = advance_interior(h, recursion, mu, equality, result);
    if (length == 0.0) break;
    left *= 1.0 - length;
    mu = mean_product(h, 0.0);
    if (mu <= convergence * begun && left <= convergence) {
      const double changes = take_interior_rows(h, length);
      if (changes == 0.0) return Steps::Done;
      if (after++ == 0 || changes <= fewest) {
        fewest = changes;
        keep_solution();
      }
    }
    in_a_row = length < short_length ? in_a_row + 1 : 0;
    if (in_a_row == short_patience && !infeasible && after == 0) return Steps::Short;
  }
  if (after == 0) return Steps::Failed;
  take_kept(h);
  return Steps::Done;
}

}  // namespace burnish

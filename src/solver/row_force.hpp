// Contribution e of a constraint row y to the gradient of the cost. A violation v of the limits
//   lower <= y <= upper
// costs p |v| + 1/2 S v^2, with L1 weight p and quadratic weight S. The augmented Lagrangian with
// multiplier m and weight w uses the shifted row c and its excess d beyond the weighted limits:
//   c = m + w y,   d = c - clip(c, w lower, w upper)
// Up to |d| = p, e is equal to d. For larger |d|, e continues with slope S / (w + S).
// e is the next multiplier, continuous and monotone in y, and linear on five pieces. The L1 weight
// of a hard row exceeds every multiplier of a solvable problem.
#pragma once

#include <algorithm>

#include "solver/dense.hpp"

namespace burnish {

/// Data of rows side by side, in whole vectors. A row without limits has weight 0.
struct RowArrays {
  const double* lower;
  const double* upper;
  const double* weight;
  const double* l1_weight;
  const double* beyond;  ///< Quadratic weight / (weight + quadratic weight)
  const double* multiplier;
};

/// L1 weights of at least this size are infinite: no violation is accepted. Used for the bounds on
/// controls, which can always be satisfied.
inline constexpr double infinite_l1_weight = 1e100;

inline dense::Lane larger(const dense::Lane& a, const dense::Lane& b) {
  return select(less(a, b), b, a);
}
inline dense::Lane clip(const dense::Lane& x, const dense::Lane& lower, const dense::Lane& upper) {
  const dense::Lane at_most = select(less(x, upper), x, upper);
  return select(less(at_most, lower), lower, at_most);
}

/// Returns the gradient e (see the file's comment) for values y of the SIMD vector of rows at i.
inline dense::Lane row_force(const RowArrays& rows, int i, const dense::Lane& y) {
  using dense::load;
  const dense::Lane weight = load(rows.weight + i);
  const dense::Lane l1_weight = load(rows.l1_weight + i);
  const dense::Lane c = load(rows.multiplier + i) + weight * y;
  const dense::Lane d = c - clip(c, weight * load(rows.lower + i), weight * load(rows.upper + i));
  const dense::Lane within = clip(d, -l1_weight, l1_weight);
  return within + load(rows.beyond + i) * (d - within);
}

/// Returns the linear piece of each value: -2 to 2 from low to high, 0 within the limits.
inline dense::Lane row_piece(const RowArrays& rows, int i, const dense::Lane& y) {
  using dense::Lane;
  using dense::load;
  const Lane zero(0.0), weight = load(rows.weight + i), l1_weight = load(rows.l1_weight + i);
  const Lane c = load(rows.multiplier + i) + weight * y;
  const Lane above = c - weight * load(rows.upper + i);
  const Lane below = c - weight * load(rows.lower + i);
  const Lane high =
      select(less(zero, above), select(less(l1_weight, above), Lane(2.0), Lane(1.0)), zero);
  const Lane low =
      select(less(below, zero), select(less(below, -l1_weight), Lane(-2.0), Lane(-1.0)), high);
  return select(less(zero, weight), select(less(zero, high), high, low), zero);
}

/// Linear function of a piece: e = slope y + offset.
struct RowLines {
  dense::Lane slope, offset;
};
inline RowLines row_lines(const RowArrays& rows, int i, const dense::Lane& piece) {
  using dense::Lane;
  using dense::load;
  const Lane zero(0.0), weight = load(rows.weight + i);
  const auto above = less(zero, piece), below = less(piece, zero);
  const Lane limit = select(above, load(rows.upper + i), load(rows.lower + i));
  const Lane offset = load(rows.multiplier + i) - weight * limit;
  const Lane full_weight = load(rows.l1_weight + i), beyond = load(rows.beyond + i);
  const Lane l1_weight = select(above, full_weight, -full_weight);
  const auto at_l1_weight = less(Lane(1.0), absolute(piece));
  const Lane slope = select(at_l1_weight, beyond * weight, weight);
  const Lane start = select(at_l1_weight, l1_weight + beyond * (offset - l1_weight), offset);
  const Lane one = select(above, Lane(1.0), select(below, Lane(1.0), zero));
  return {select(less(zero, one), slope, zero), select(less(zero, one), start, zero)};
}

}  // namespace burnish

// What a row with limits adds to the gradient of a cost: the augmented Lagrangian of
//   lower <= y <= upper,  outside of it price |v| + 1/2 square v^2 for a violation v,
// with multiplier m and weight w:
//   d = c - clip(c, w lower, w upper), c = m + w y
//   e = d where |d| <= price, else what lies beyond it with slope square / (w + square)
// e is the multiplier that comes next, continuous and monotone in y: linear on five pieces. A hard
// row is one whose price is more than any multiplier of a problem that has a solution.
#pragma once

#include <algorithm>

#include "solver/dense.hpp"

namespace burnish {

/// Rows side by side, whole vectors of them; a row without limits has weight 0.
struct RowArrays {
  const double* lower;
  const double* upper;
  const double* weight;
  const double* price;
  const double* beyond;  ///< square / (weight + square)
  const double* multiplier;
};

/// A price from here on is none: violations are not accepted. Of what can always be kept, bounds on
/// controls.
inline constexpr double no_price = 1e100;

inline dense::Lane larger(const dense::Lane& a, const dense::Lane& b) {
  return select(less(a, b), b, a);
}
inline dense::Lane clip(const dense::Lane& x, const dense::Lane& lower, const dense::Lane& upper) {
  const dense::Lane at_most = select(less(x, upper), x, upper);
  return select(less(at_most, lower), lower, at_most);
}

/// e of the vector of rows that begins at i, for values y.
inline dense::Lane row_force(const RowArrays& rows, int i, const dense::Lane& y) {
  using dense::load;
  const dense::Lane weight = load(rows.weight + i);
  const dense::Lane price = load(rows.price + i);
  const dense::Lane c = load(rows.multiplier + i) + weight * y;
  const dense::Lane d = c - clip(c, weight * load(rows.lower + i), weight * load(rows.upper + i));
  const dense::Lane within = clip(d, -price, price);
  return within + load(rows.beyond + i) * (d - within);
}

/// The pieces that values lie on, from the lower end to the upper one: -2 to 2, 0 within the
/// limits.
inline dense::Lane row_piece(const RowArrays& rows, int i, const dense::Lane& y) {
  using dense::Lane;
  using dense::load;
  const Lane zero(0.0), weight = load(rows.weight + i), price = load(rows.price + i);
  const Lane c = load(rows.multiplier + i) + weight * y;
  const Lane above = c - weight * load(rows.upper + i);
  const Lane below = c - weight * load(rows.lower + i);
  const Lane high =
      select(less(zero, above), select(less(price, above), Lane(2.0), Lane(1.0)), zero);
  const Lane low =
      select(less(below, zero), select(less(below, -price), Lane(-2.0), Lane(-1.0)), high);
  return select(less(zero, weight), select(less(zero, high), high, low), zero);
}

/// The lines of pieces: e = slope y + offset.
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
  const Lane most = load(rows.price + i), beyond = load(rows.beyond + i);
  const Lane price = select(above, most, -most);
  const auto at_price = less(Lane(1.0), absolute(piece));
  const Lane slope = select(at_price, beyond * weight, weight);
  const Lane start = select(at_price, price + beyond * (offset - price), offset);
  const Lane one = select(above, Lane(1.0), select(below, Lane(1.0), zero));
  return {select(less(zero, one), slope, zero), select(less(zero, one), start, zero)};
}

}  // namespace burnish

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

/// Pieces of e, from the lower end to the upper one.
enum class RowPiece : signed char {
  BelowPrice = -2,
  Below = -1,
  Inside = 0,
  Above = 1,
  AbovePrice = 2
};

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

/// The piece that a value of one row lies on.
inline RowPiece row_piece(const RowArrays& rows, int i, double y) {
  const double weight = rows.weight[i];
  const double c = rows.multiplier[i] + weight * y;
  const double above = c - weight * rows.upper[i];
  const double below = c - weight * rows.lower[i];
  if (above > 0.0) return above > rows.price[i] ? RowPiece::AbovePrice : RowPiece::Above;
  if (below < 0.0) return below < -rows.price[i] ? RowPiece::BelowPrice : RowPiece::Below;
  return RowPiece::Inside;
}

/// A piece: e = slope y + offset.
struct RowLine {
  double slope, offset;
};
inline RowLine row_line(const RowArrays& rows, int i, RowPiece piece) {
  if (piece == RowPiece::Inside) return {0.0, 0.0};
  const bool above = piece > RowPiece::Inside;
  const double limit = above ? rows.upper[i] : rows.lower[i];
  const RowLine line{rows.weight[i], rows.multiplier[i] - rows.weight[i] * limit};
  if (piece == RowPiece::Above || piece == RowPiece::Below) return line;
  const double price = above ? rows.price[i] : -rows.price[i];
  const double beyond = rows.beyond[i];
  return {beyond * line.slope, price + beyond * (line.offset - price)};
}

}  // namespace burnish

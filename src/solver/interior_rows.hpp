// Rows with limits in a primal-dual interior-point method. Per side of a row y, with d(y) the
// distance to its limit (upper - y, y - lower):
//   slack s = d(y) + v,   multiplier m,   violation v at a price with n = price + square v - m,
//   s m = mu,  v n = mu,  all four above zero
// (Nocedal and Wright, Numerical Optimization (2006), section 16.6, with an elastic variable per
// side). Where a violation has no price there is no v. A Newton step eliminates all four: what a
// row then adds to the gradient of a cost is a line in its next value, as in row_force.hpp, so that
// one Riccati recursion makes the step. A row whose limits meet is an equality, with a multiplier
// and a weight as there.
#pragma once

#include <array>

#include "solver/buffer.hpp"
#include "solver/row_force.hpp"

namespace burnish {

class InteriorRows {
 public:
  explicit InteriorRows(int rows);

  /// What a Newton step aims at: products of `mu`, less those of the step before where that was
  /// the predictor's (Mehrotra).
  struct Target {
    double mu = 0.0;
    bool corrected = false;
    double equality = 1.0;  ///< of their weights, that equalities have
  };

  /// Every function is of the vector of rows from `at` on; `rows` are theirs. `outside`: rows that
  /// are outside their limits begin with the violation that they have, and not with next to none.
  void start(int at, const RowArrays& rows, int r, const dense::Lane& scale, const dense::Lane& y,
             double mu, bool outside);
  /// What the rows add to the gradient, by the next value.
  RowLines lines(int at, const RowArrays& rows, int r, const dense::Lane& y,
                 const Target& target) const;
  /// The step that goes with a next value.
  void take_direction(int at, const RowArrays& rows, int r, const dense::Lane& y,
                      const dense::Lane& next, const Target& target);
  /// 1 / the length at which the first of them reaches zero.
  dense::Lane steepest(int at) const;
  /// Sum of the products at a length of the step, and how many there are.
  struct Products {
    dense::Lane sum, count;
  };
  Products products(int at, double length) const;
  void advance(int at, double length);
  dense::Lane multiplier(int at) const;
  /// The piece that a row goes to, as row_piece() says it: of two factors of a product the one that
  /// falls less in the last step, of this length, is the one that stays (Tapia's indicators).
  dense::Lane piece(int at, const RowArrays& rows, int r, double length) const;

 private:
  /// Values and steps of a side, all rows; zeros where there is none.
  struct Side {
    double *s, *m, *v, *n, *ds, *dm, *dv, *dn;
    double sign;  ///< of dy in the distance, reversed
  };
  struct Step;
  static Step step_of(const Side& side, int at, const RowArrays& rows, int r, const dense::Lane& y,
                      const Target& target);

  Buffer memory_;
  std::array<Side, 2> sides_;
  double *equality_, *equality_step_;
};

}  // namespace burnish

// Constraint rows in a primal-dual interior-point method. Each side of a row y has a distance d(y)
// to its limit (upper - y or y - lower) and four positive variables: slack s, multiplier m,
// violation v, and the multiplier n of v >= 0. With the barrier parameter mu, they satisfy
//   s = d(y) + v,   n = L1 weight + quadratic weight v - m,   s m = mu,   v n = mu
// (Nocedal and Wright, Numerical Optimization (2006), section 16.6, with one elastic variable per
// side). A row that must not be violated has no v and no n.
// A Newton step eliminates all four variables. The row then contributes to the cost gradient a
// linear function of the row's next value (RowLines in row_force.hpp), so one Riccati recursion
// computes the step. A row with equal limits is an equality, with a multiplier and a weight as in
// row_force.hpp.
#pragma once

#include <array>

#include "solver/buffer.hpp"
#include "solver/row_force.hpp"

namespace burnish {

class InteriorRows {
 public:
  explicit InteriorRows(int rows);

  /// Target of a Newton step: products s m and v n equal to `mu`. If `corrected`, the second-order
  /// terms of the preceding predictor step are subtracted (Mehrotra).
  struct Target {
    double mu = 0.0;
    bool corrected = false;
    double equality = 1.0;  ///< Factor on the weights of equality rows
  };

  /// Initial point, with products s m and v n near `mu`. The variable v of a row outside its limits
  /// starts at the actual violation if `infeasible`, and at a small value otherwise.
  struct Start {
    double mu = 0.0;
    bool infeasible = false;
  };
  /// Initialises the rows. All functions process one SIMD vector of rows, which starts at entry
  /// `at` of the row variables and entry `r` of `rows`.
  void start(int at, const RowArrays& rows, int r, const dense::Lane& scale, const dense::Lane& y,
             const Start& from);
  /// Returns the contribution of rows to the cost gradient, a linear function of their next values.
  RowLines lines(int at, const RowArrays& rows, int r, const dense::Lane& y,
                 const Target& target) const;
  /// Computes the step of the row variables for the next values `next` of the rows.
  void take_direction(int at, const RowArrays& rows, int r, const dense::Lane& y,
                      const dense::Lane& next, const Target& target);
  /// Returns the inverse of the step length at which the first variable reaches zero.
  dense::Lane steepest(int at) const;
  /// Sum and number of the products s m and v n at a step length.
  struct Products {
    dense::Lane sum, count;
  };
  Products products(int at, double length) const;
  void advance(int at, double length);
  dense::Lane multiplier(int at) const;
  /// Returns the piece that each row tends to, as row_piece() defines it. In each product s m or
  /// v n, the factor with the smaller relative decrease in the last step is taken to stay positive
  /// (Tapia's indicators). `length`: length of the last step.
  dense::Lane piece(int at, const RowArrays& rows, int r, double length) const;

 private:
  /// Values and steps of one side, for all rows; zero if a row does not have this side.
  struct Side {
    double *s, *m, *v, *n, *ds, *dm, *dv, *dn;
    double sign;  ///< 1: upper limit; -1: lower limit
  };
  struct Step;
  static Step step_of(const Side& side, int at, const RowArrays& rows, int r, const dense::Lane& y,
                      const Target& target);

  Buffer memory_;
  std::array<Side, 2> sides_;
  double *equality_, *equality_step_;
};

}  // namespace burnish

// A linear-quadratic problem over a horizon whose rows have limits:
//   minimise sum 1/2 z^T H z + g^T z,  dx' = F z + gap,  lower <= C z <= upper,  z = (du, dx),
// by semismooth Newton steps on an augmented Lagrangian (row_force.hpp). A step is one Riccati
// recursion with the rows that push added to the cost; its length is the minimum along it, which
// is exact since what is minimised is convex and piecewise quadratic. Where a step of length one
// leaves every row on its piece, the multipliers follow, and the next step needs no new factors but
// a sweep with those there are.
//
// A knot's first rows are the entries of its z themselves; those with coefficients follow from
// first_row().
#pragma once

#include <span>
#include <vector>

#include "solver/buffer.hpp"
#include "solver/interior_rows.hpp"
#include "solver/riccati.hpp"
#include "solver/row_force.hpp"

namespace burnish {

/// What is solved, and where policy and value function go; knots 0 to N.
struct LqHorizon {
  std::span<const KnotExpansion> expansions;
  std::span<const int> controls;  ///< 0 at N
  std::span<const int> rows;      ///< of each knot, with coefficients
  const double* gaps = nullptr;   ///< that of knot k + 1 leads to dx of k + 1; gap_stride apart
  double* hessian_gaps = nullptr;
  int gap_stride = 0;
  std::span<const ValueStorage> values;
  std::span<const PolicyStorage> policies;
  double regularization = 0.0;
};

struct LimitedLqBudget {
  /// Recursions with new factors, of the whole horizon or its first part; those of an
  /// interior-point method are not counted.
  int factors = 100;
  int sweeps = 200;  ///< with kept factors
  /// Recursions after which an interior-point method finds out which rows push, where 20 are left;
  /// 0: at once, where the start is from nothing.
  int interior_after = 8;
  /// Of what limits are exceeded by, and multipliers change by over their weight, in a row's scale.
  double tolerance = 1e-9;
};

struct LimitedLqResult {
  int factors = 0, sweeps = 0;
  int interior = 0;            ///< factors of an interior-point method
  bool approached = false;     ///< by one that came to its end
  double interior_open = 0.0;  ///< of its solution
  int semismooth() const { return factors - interior; }
  bool converged = false;
  double open = 0.0;  ///< what the tolerance is held against, at the last minimum
  /// Where Quu is not positive definite; -1: nowhere.
  int failed_knot = -1, failed_control = -1;
};

class LimitedLq {
 public:
  LimitedLq(const StateShape& state, int knots, int max_controls, int max_rows);
  /// Recursions that have to be left in a budget for an interior-point method to be asked.
  static constexpr int enough_for_interior = 20;

  /// A knot's rows, first_row() + max_rows of them. A solve reads all and writes multipliers.
  struct Rows {
    double* lower;  ///< of C z: the limit less the row's present value
    double* upper;
    double* scale;   ///< in the row's unit: a tolerance of 1 would be that much
    double* weight;  ///< 0: no limits
    double* price;   ///< 0: there is no multiplier
    double* beyond;
    double* multiplier;
  };
  Rows rows(int knot);
  /// Multipliers, and the pieces that rows lay on.
  void forget() noexcept;
  /// One knot on, for a horizon that begins a knot later: knots take what the next one has for a
  /// warm start (multipliers, pieces, gains), and the last before the end, and those before another
  /// number of controls, keep their own. Feedforwards are the caller's.
  void shift(std::span<const int> controls) noexcept;
  /// The same where knots are of different lengths: knot k takes what from[k] has, which is not
  /// before it and does not fall with k.
  void shift(std::span<const int> controls, std::span<const int> from) noexcept;
  int first_row() const { return first_row_; }
  int places() const { return row_count_; }  ///< of a knot's rows, with those that are none

  /// `warm`: begins with the policies in the horizon and the pieces that rows lay on. Allocates
  /// nothing.
  LimitedLqResult solve(const LqHorizon& horizon, RiccatiRecursion& recursion,
                        const LimitedLqBudget& budget, bool warm);

  const double* z(int knot) const { return knot_at(knot).z; }
  /// Of all rows, C z.
  const double* values(int knot) const { return knot_at(knot).y; }

 private:
  void take_over(std::span<const int> controls, int knot, int source) noexcept;
  /// Places of a knot's vectors in memory_.
  struct Knot {
    double *z, *z_before, *z_kept, *y, *y_before, *multiplier, *multiplier_kept, *piece_kept,
        *lower, *upper, *scale, *weight, *price, *beyond, *slope, *offset, *piece, *found, *factor,
        *inverse_diagonal, *transposed_rows, *transposed_dynamics, *transposed_gain;
    RowArrays arrays() const { return {lower, upper, weight, price, beyond, multiplier}; }
  };

  const Knot& knot_at(int knot) const { return knots_[static_cast<std::size_t>(knot)]; }
  int vectors_end(const LqHorizon& h, int knot) const;
  void transpose(const LqHorizon& h);
  void keep();
  void follow_policy(const LqHorizon& h);
  void row_values(const LqHorizon& h, int knot);
  int find_pieces(const LqHorizon& h);
  void keep_pieces();
  void take_pieces(const LqHorizon& h);
  static dense::Lane change_of(const Knot& mine, int r, const dense::Lane& next);
  void gradient(const LqHorizon& h, int knot, double* out) const;
  WeightedRows weigh(const LqHorizon& h, int knot);
  bool factor(const LqHorizon& h, RiccatiRecursion& recursion, int from, LimitedLqResult& result);
  void sweep(const LqHorizon& h, RiccatiRecursion& recursion);
  struct Line;
  Line line(const LqHorizon& h);
  double force_along(const LqHorizon& h, double length) const;
  void shorten(const LqHorizon& h);
  void blend(double length);
  template <class Function>
  void for_each_vector(const LqHorizon& h, const Function& function) const;
  bool begin_interior(const LqHorizon& h, RiccatiRecursion& recursion, bool outside, double& mu,
                      LimitedLqResult& result);
  bool interior_step(const LqHorizon& h, RiccatiRecursion& recursion,
                     const InteriorRows::Target& target, LimitedLqResult& result);
  void keep_solution();
  void take_kept(const LqHorizon& h);
  void cut_short(const LqHorizon& h, RiccatiRecursion& recursion, LimitedLqResult& result);
  double take_interior_rows(const LqHorizon& h, double length);
  double advance_interior(const LqHorizon& h, RiccatiRecursion& recursion, double mu,
                          double equality, LimitedLqResult& result);
  enum class Steps { Done, Short, Failed };
  Steps interior_steps(const LqHorizon& h, RiccatiRecursion& recursion, bool outside,
                       LimitedLqResult& result);
  double interior_length(const LqHorizon& h) const;
  double mean_product(const LqHorizon& h, double length) const;
  static bool pays(const LimitedLqBudget& budget, const LimitedLqResult& result);
  bool restart(const LqHorizon& h, RiccatiRecursion& recursion, bool& whole,
               LimitedLqResult& result);
  bool factor_pieces(const LqHorizon& h, RiccatiRecursion& recursion, LimitedLqResult& result);
  bool approach(const LqHorizon& h, RiccatiRecursion& recursion, LimitedLqResult& result);
  class GrowthWatch;
  bool begin(const LqHorizon& h, RiccatiRecursion& recursion, bool warm, LimitedLqResult& result);
  bool update(const LqHorizon& h, RiccatiRecursion& recursion, const LimitedLqBudget& budget,
              GrowthWatch& growth, bool& whole, LimitedLqResult& result);
  double left_open(const LqHorizon& h) const;
  void raise_weights(const LqHorizon& h);
  double update_multipliers(const LqHorizon& h, double to_price);

  StateShape state_;
  int N_, max_controls_, max_rows_, first_row_, row_count_, stride_, row_stride_, control_stride_,
      velocity_stride_;
  Buffer memory_, chosen_, weighted_, gradient_, scratch_;
  std::vector<Knot> knots_;
  InteriorRows interior_;
};

}  // namespace burnish

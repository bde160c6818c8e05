// Linear-quadratic problem over a horizon with constraint rows,
//   minimise sum 1/2 z^T H z + g^T z,  dx' = F z + gap,  lower <= C z <= upper,  z = (du, dx),
// solved by semismooth Newton steps on an augmented Lagrangian (row_force.hpp). A step is one
// Riccati recursion with the active rows added to the cost. The step length is the exact minimum
// along the step, because the objective is convex and piecewise quadratic.
// If a step of length one leaves every row on its piece, the multipliers are updated. The next step
// then reuses the factorization and needs only a sweep.
//
// The first rows of a knot are the entries of z. Rows with coefficients start at first_row().
#pragma once

#include <span>
#include <vector>

#include "base/to_size.hpp"
#include "solver/buffer.hpp"
#include "solver/interior_rows.hpp"
#include "solver/riccati.hpp"
#include "solver/row_force.hpp"

namespace burnish {

/// Input of a solve, and memory for the policies and value functions; knots 0 to N.
struct LqHorizon {
  std::span<const KnotExpansion> expansions;
  std::span<const int> controls;  ///< Number of controls of each knot; 0 at N
  std::span<const int> rows;      ///< Number of rows with coefficients at each knot
  const double* gaps = nullptr;   ///< Gaps before each knot's dx, gap_stride entries apart
  double* hessian_gaps = nullptr;
  int gap_stride = 0;
  std::span<const ValueStorage> values;
  std::span<const PolicyStorage> policies;
  double regularization = 0.0;
};

struct LimitedLqBudget {
  /// Maximum number of factorizations, each over the whole horizon or only its first part.
  /// Factorizations of the interior-point method are not counted.
  int factorizations = 100;
  int sweeps = 200;  ///< Maximum number of sweeps that reuse a factorization
  /// Number of factorizations after which the interior-point method detects the active rows, if at
  /// least 20 remain in the budget. With 0, a cold start begins with the interior-point method.
  int interior_after = 8;
  /// Largest change of a multiplier between sweeps at which the solution is accepted. The change is
  /// divided by the weight and the scale of the row.
  double tolerance = 1e-9;
};

struct LimitedLqResult {
  int factorizations = 0, sweeps = 0;
  int interior = 0;                ///< Factorizations of the interior-point method
  bool approached = false;         ///< The interior-point method has converged
  double interior_residual = 0.0;  ///< Residual of the interior-point solution
  int semismooth() const { return factorizations - interior; }
  bool converged = false;
  double residual = 0.0;  ///< Largest multiplier change, divided by the weight, at the last minimum
  /// Knot and control at which Quu is not positive definite; -1: none.
  int failed_knot = -1, failed_control = -1;
};

class LimitedLq {
 public:
  LimitedLq(const StateShape& state, int knots, int max_controls, int max_rows);
  /// Minimum number of factorizations left in the budget for the interior-point method.
  static constexpr int min_interior_budget = 20;

  /// Data of a knot's rows, first_row() + max_rows entries. A solve reads all data and writes the
  /// multipliers.
  struct Rows {
    double* lower;  ///< Lower limit of C z: limit of the row minus its value at z = 0
    double* upper;
    double* scale;      ///< Characteristic size of the row, in the row's unit
    double* weight;     ///< Weight of the augmented Lagrangian; 0: no limits
    double* l1_weight;  ///< 0: the row has no multiplier
    double* beyond;     ///< Quadratic weight / (weight + quadratic weight)
    double* multiplier;
  };
  Rows rows(int knot);
  /// Resets multipliers and pieces.
  void forget() noexcept;
  /// Shifts the warm start by one knot, for a horizon that starts one knot later. Each knot takes
  /// the multipliers, pieces and gains of the next knot. The last knot, and a knot whose next knot
  /// has another number of controls, keep their own data. Feedforwards are not shifted.
  void shift(std::span<const int> controls) noexcept;
  /// Shifts the warm start for knots of different lengths: knot k takes the data of knot from[k].
  /// from[k] must be at least k and must not decrease with k.
  void shift(std::span<const int> controls, std::span<const int> from) noexcept;
  int first_row() const { return first_row_; }
  int places() const { return row_count_; }  ///< Allocated entries for a knot's rows

  /// Solves the problem. If `warm`, starts from the policies in `horizon` and from the pieces of
  /// the last solve. Does not allocate.
  LimitedLqResult solve(const LqHorizon& horizon, RiccatiRecursion& recursion,
                        const LimitedLqBudget& budget, bool warm);

  const double* z(int knot) const { return knot_at(knot).z; }
  /// Returns C z for all rows of a knot.
  const double* values(int knot) const { return knot_at(knot).y; }

 private:
  void take_over(std::span<const int> controls, int knot, int source) noexcept;
  /// Addresses of a knot's vectors in memory_.
  struct Knot {
    double *z, *z_before, *z_kept, *y, *y_before, *multiplier, *multiplier_kept, *piece_kept,
        *lower, *upper, *scale, *weight, *l1_weight, *beyond, *slope, *offset, *piece, *found,
        *factor, *inverse_diagonal, *transposed_rows, *transposed_dynamics, *transposed_gain;
    RowArrays arrays() const { return {lower, upper, weight, l1_weight, beyond, multiplier}; }
  };

  const Knot& knot_at(int knot) const { return knots_[to_size(knot)]; }
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
  bool begin_interior(const LqHorizon& h, RiccatiRecursion& recursion, bool infeasible, double& mu,
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
  Steps interior_steps(const LqHorizon& h, RiccatiRecursion& recursion, bool infeasible,
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
  double residual_left(const LqHorizon& h) const;
  void raise_weights(const LqHorizon& h);
  double update_multipliers(const LqHorizon& h, double jump_threshold);

  StateShape state_;
  int N_, max_controls_, max_rows_, first_row_, row_count_, stride_, row_stride_, control_stride_,
      velocity_stride_;
  Buffer memory_, chosen_, weighted_, gradient_, scratch_;
  std::vector<Knot> knots_;
  InteriorRows interior_;
};

}  // namespace burnish

// Internal state of a DdpSolver and the phases of an iteration.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/thread_pool.hpp"
#include "base/to_size.hpp"
#include "burnish/solver/ddp.hpp"
#include "solver/buffer.hpp"
#include "solver/limited_lq.hpp"
#include "solver/parametric_segment.hpp"
#include "solver/riccati.hpp"

namespace burnish {

/// L1 weights and limits of at least this size count as infinite.
inline constexpr double beyond_all = 1e300;
inline bool is_hard(double l1_weight) { return l1_weight >= beyond_all; }
/// Returns the excess over the upper limit (positive) or under the lower limit (negative), else 0.
inline double signed_violation_of(double value, double lower, double upper) {
  return value > upper ? value - upper : std::min(value - lower, 0.0);
}

inline double violation_of(double value, double lower, double upper) {
  return std::max(std::max(lower - value, value - upper), 0.0);
}

/// A trajectory with its cost, gaps and constraint values.
struct Iterate {
  std::vector<double> xs, us;
  double cost = 0.0;
  bool feasible = false;
  Buffer gaps;  ///< Row k: gap before state k, (x0 or f(x_(k-1), u_(k-1))) (-) x_k
  double gap_sum = 0.0, largest_gap = 0.0;
  int gap_knot = 0, gap_entry = 0;
  std::vector<double> rows;     ///< Values of the constraint rows, max_rows per knot
  double violation_cost = 0.0;  ///< Cost of constraint violations, with the merit's L1 weights
  double violation = 0.0;       ///< Largest violation of a hard row, relative to its scale
  bool breaks = false;          ///< Some row that a control can move violates its limits
};

/// Quadratic model of the cost along the search direction.
struct Direction {
  /// d1: derivative of the cost (with constraint rows: of the merit function) with respect to the
  /// step length, at length 0. accept_rollout() adds the contribution of the gaps.
  double slope = 0.0;
  double curvature = 0.0;  ///< d2: second derivative with respect to the step length
  /// For StepUpdate::MultipleShooting: slope of the cost, and change of cost that the model
  /// predicts for a whole step
  double cost_slope = 0.0, model_change = 0.0;
};

struct DdpSolver::Impl {
  Impl(ShootingProblem& shooting_problem, DdpOptions wanted);

  using Clock = std::chrono::steady_clock;

  // Set-up.
  void apply_options(DdpOptions wanted);
  void allocate();
  void start();

  // One iteration; a phase that returns false has ended the solve and set the reason.
  void iterate();
  bool make_direction();
  bool judge_direction(bool& again);
  bool ends_elastic(bool& again);
  bool ends_still(bool& again);
  bool line_search(double& length);
  bool after_search(double length);

  // Phases.
  bool expand(Iterate& at);
  bool take_values(Iterate& at);
  bool take_gaps(Iterate& at);
  bool backward();
  bool shares_knots() const;
  bool sweep_knots();
  bool sweep(const ThreadTeam& team);
  void take_step(int knot, const RiccatiStep& step);
  void add_first_gap();
  void check_segments(int segments) const;
  void cut_horizon(int segments);
  bool can_be_cut() const;
  int sweep_segment(int segment, const ValueStorage& after, bool parametric);
  bool sweep_segments(bool& usable);
  bool join_segments();
  bool note_failure(int knot);
  void linear_rollout();
  double penalty_for_direction();
  double largest_multiplier();
  bool roll_trial(double length, double& gap_improvement);
  bool shooting_trial(double length, bool with_expansion);
  bool accept_rollout(double length, double gap_improvement) const;
  bool accept_shooting(double length) const;
  void take_trial(double length);
  double merit(const Iterate& of) const {
    return of.cost + penalty * of.gap_sum + of.violation_cost;
  }

  // Constraint rows, in ddp_limits.cpp and ddp_elastic.cpp.
  void allocate_rows();
  void start_rows();
  void place_rows();
  bool is_bounded(int knot, int control) const;
  void forget_limits() noexcept;
  void take_rows(Iterate& at);
  void set_row_limits();
  void set_row_weights();
  bool limited_backward();
  void raise_merit_weights();
  void model_of_limited();
  double quadratic_weight_of(std::size_t row) const;
  double curvature_unit() const;
  void allocate_curvatures();
  void add_curvatures();
  double multiplier_estimate(int knot, int row) const;
  void find_fixed_rows();
  bool is_fixed(int knot, int row) const;
  bool solve_limited();
  bool solve_limited_with(const double* gaps, int max_factorizations);
  void take_limited_step();
  void point_policies();
  void allocate_correction();
  bool corrected_trial();
  void swap_step();
  bool become_elastic();
  bool after_elastic();
  bool is_least_violation() const;
  /// Sums of the hard rows' violations, each relative to the row's scale.
  struct Violations {
    double now = 0.0;
    double after = 0.0;  ///< After the whole step, in the linear model
  };
  Violations violations() const;
  void note_stillness();
  bool is_still() const;
  bool violations_can_fall();
  void close_gaps();
  bool starts_violated() const;
  bool keeps_limits(const Iterate& at) const { return at.violation <= options.limits.tolerance; }
  bool accept_limited(double length) const;
  void note_violation();
  void note_conflict();
  void note_start();
  /// Calls visit(knot, row within the knot, index over all knots, lower, upper) for each row.
  template <class Visit>
  void for_each_row(Visit&& visit) const {
    for (int k = 0; k <= N; ++k) {
      const auto at = to_size(k);
      const double* low = row_lowers[at];
      const double* high = row_uppers[at];
      for (int r = 0; r < row_counts[at]; ++r)
        visit(k, r, to_size(k * rows_max + r), low[r], high[r]);
    }
  }

  // Bookkeeping.
  bool increase_regularization();
  void decrease_regularization();
  bool fail_at(int knot, const KnotValue& value);
  bool find_not_finite();
  bool stop(StopReason reason);
  bool out_of_time() const { return since(began) >= options.time_budget; }
  static double since(Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  }
  void finish();

  double* gap(Iterate& of, int knot) const { return of.gaps.data() + knot * value_stride; }
  double* hessian_gap(int knot) { return hessian_gaps.data() + knot * value_stride; }
  double* dx(int knot) { return dxs.data() + knot * value_stride; }
  double* du(int knot) { return dus.data() + knot * control_stride; }
  ValueStorage value(int knot);
  PolicyStorage policy(int knot);
  ControlBox box(int knot) const {
    return {lower[knot], upper[knot], current.us.data() + knot * nu_max};
  }
  void clamp(int knot, double* u) const;

  ShootingProblem& problem;
  DdpOptions options;
  StateShape state;
  int N, nx, ndx, nu_max;
  RiccatiRecursion recursion;
  int value_stride, gain_stride, control_stride;
  std::unique_ptr<ThreadPool> pool;

  std::vector<int> controls;
  std::vector<const double*> lower, upper;
  std::span<const KnotRange> ranges;

  Iterate current, trial, best;
  bool best_is_current = true;
  std::vector<double> next;
  std::vector<KnotValue> values;
  std::vector<KnotExpansion> expansions;
  std::vector<Buffer> expansion_memory, value_memory, policy_memory, row_memory, curvature_memory;
  Buffer hessian_gaps, dxs, dus, z, scratch;

  // Segments of the horizon; empty if options.segments is below 3.
  std::vector<std::unique_ptr<ParametricSegment>> parts;
  std::vector<int> borders;        ///< First knot of each segment, then N
  std::vector<int> failures;       ///< Knot at which each segment failed; -1: none
  std::vector<RiccatiStep> steps;  ///< Result of the recursion at each knot

  // Solver of linear-quadratic problems with constraint rows; null if the problem has no rows.
  std::unique_ptr<LimitedLq> limited;
  int rows_max = 0;
  std::vector<int> row_counts;
  std::vector<int> coefficient_counts;  ///< Number of rows with coefficients at each knot
  std::vector<int> row_slots;           ///< Index of each row within the rows of `limited`
  std::vector<const double*> row_lowers, row_uppers;  ///< Limits of the rows at each knot
  std::vector<LimitedLq::Rows> row_views;             ///< Row data of each knot in `limited`
  /// Properties of rows, rows_max entries per knot. row_inverses holds 1 / row_scales.
  std::vector<double> row_scales, row_inverses, row_l1_weights, row_quadratic_weights;
  std::vector<double> row_multipliers;  ///< Multipliers of the last solve, rows_max per knot
  std::vector<ValueStorage> value_list;
  std::vector<PolicyStorage> policy_list;
  std::vector<double> merit_weights;  ///< L1 weights of violations in the merit, rows_max per knot
  bool limited_before = false;        ///< Policies and multipliers of a previous direction exist
  LimitedLqResult limited_result;
  /// Change of cost that the constraint tolerance can cause, estimated from the multipliers.
  double limit_resolution = 0.0;
  bool at_resolution = false;  ///< The last expected improvement was at most limit_resolution
  Buffer corrected_gaps, kept_dxs, kept_dus;  ///< Memory of the second-order correction
  /// The last whole step was rejected. The next whole step is evaluated without derivatives.
  bool refused = false;
  /// Elastic mode: hard rows have no multipliers, and violations have a quadratic penalty only.
  struct Elastic {
    bool on = false;
    double weight = 0.0;      ///< Quadratic penalty weight, in units of row_unit / scale^2
    double violation = -1.0;  ///< Violation at the last minimum; -1: no minimum yet
    bool stays = false;       ///< Violations persist even with the largest weight
    int lost = 0;             ///< Consecutive iterations that could not satisfy all rows
    int stood = 0;            ///< Iterations without expected improvement but with violations
    int still = 0;            ///< Consecutive iterations without a decrease of the violations
    double still_from = 0.0;  ///< Sum of violations at the first iteration counted by `still`
  } elastic;
  bool has_curvature = false;   ///< The Hessians of `expansions` contain the constraint curvature
  double cost_unit = 1.0;       ///< curvature_unit() without constraint curvature
  double hard_l1_weight = 0.0;  ///< L1 weight of hard rows, in units of row_unit / scale
  std::vector<char> start_is_fixed;  ///< 1 for rows of knot 0 that no control moves
  double row_unit = 0.0;             ///< curvature_unit() at the first iterate
  double merit_change = 0.0;  ///< Change of the merit that the model predicts for a whole step

  // State of a solve.
  Clock::time_point began;
  DdpSummary summary;
  bool expanded = false;  ///< The expansions belong to the current iterate
  bool searched_at_floor = false;
  Direction direction;
  double regularization = 0.0;
  /// Smallest regularization for which Quu was positive definite
  double regularization_floor = 0.0;
  double penalty = 0.0;
  KnotValue trial_failure;
  int trial_failure_knot = -1;
};

}  // namespace burnish

// What a DdpSolver holds, and the phases of an iteration.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

#include "base/thread_pool.hpp"
#include "burnish/solver/ddp.hpp"
#include "solver/buffer.hpp"
#include "solver/limited_lq.hpp"
#include "solver/parametric_segment.hpp"
#include "solver/riccati.hpp"

namespace burnish {

/// Prices and limits that count as none.
inline constexpr double beyond_all = 1e300;
inline bool is_hard(double price) { return price >= beyond_all; }
/// What a row's value is above the upper limit by, or, below zero, under the lower one.
inline double signed_outside_of(double value, double lower, double upper) {
  return value > upper ? value - upper : std::min(value - lower, 0.0);
}

inline double outside_of(double value, double lower, double upper) {
  return std::max(std::max(lower - value, value - upper), 0.0);
}

/// A trajectory, and what is known of it.
struct Iterate {
  std::vector<double> xs, us;
  double cost = 0.0;
  bool feasible = false;
  Buffer gaps;  ///< row k: what leads to state k, (x0 or f(x_(k-1), u_(k-1))) (-) x_k
  double gap_sum = 0.0, largest_gap = 0.0;
  int gap_knot = 0, gap_entry = 0;
  std::vector<double> rows;   ///< values, max_rows of each knot
  double outside_cost = 0.0;  ///< of rows outside their limits, at the merit's prices
  double outside = 0.0;       ///< the largest violation of a hard row, in its scale
  bool breaks = false;        ///< some row that a control moves is outside its limits
};

/// What the quadratic model says of the direction.
struct Direction {
  double slope = 0.0;      ///< d1: of the cost saved, without what the gaps add in a rollout
  double curvature = 0.0;  ///< d2
  /// MultipleShooting: gradient of the cost along the direction, and the change of the model.
  double cost_slope = 0.0, model_change = 0.0;
};

struct DdpSolver::Impl {
  Impl(ShootingProblem& shooting_problem, DdpOptions wanted);

  using Clock = std::chrono::steady_clock;

  // Set-up.
  void apply_options(DdpOptions wanted);
  void allocate();
  void start();

  // One iteration; each phase returns false when the solve is over (the reason is set).
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
  bool sweep(const Crew& crew);
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
  double merit(const Iterate& of) const { return of.cost + penalty * of.gap_sum + of.outside_cost; }

  // Rows with limits, in ddp_limits.cpp and ddp_elastic.cpp.
  void allocate_rows();
  void start_rows();
  void place_rows();
  bool is_bounded(int knot, int control) const;
  void forget_limits() noexcept;
  void take_rows(Iterate& at);
  void set_row_limits();
  void set_row_weights();
  bool limited_backward();
  void raise_prices();
  void model_of_limited();
  double square_of(std::size_t row) const;
  double curvature_unit() const;
  void allocate_bends();
  void add_bends();
  double push_of(int knot, int row) const;
  void find_fixed_rows();
  bool is_fixed(int knot, int row) const;
  bool solve_limited();
  bool solve_limited_with(const double* gaps, int max_factors);
  void take_limited_step();
  void point_policies();
  void allocate_correction();
  bool corrected_trial();
  void swap_step();
  bool become_elastic();
  bool after_elastic();
  bool is_least_violation() const;
  /// Sums of the hard rows' violations over their scales.
  struct Violations {
    double now = 0.0;
    double after = 0.0;  ///< the whole step, by the linear model
  };
  Violations violations() const;
  void note_stillness();
  bool is_still() const;
  bool violations_can_fall();
  void close_gaps();
  bool starts_outside() const;
  bool keeps_limits(const Iterate& at) const { return at.outside <= options.limits.tolerance; }
  bool accept_limited(double length) const;
  void note_outside();
  void note_conflict();
  void note_start();
  /// visit(knot, row of the knot, row of all, lower, upper)
  template <class Visit>
  void for_each_row(Visit&& visit) const {
    for (int k = 0; k <= N; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double* low = row_lowers[at];
      const double* high = row_uppers[at];
      for (int r = 0; r < row_counts[at]; ++r)
        visit(k, r, static_cast<std::size_t>(k * rows_max + r), low[r], high[r]);
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
  std::vector<Buffer> expansion_memory, value_memory, policy_memory, row_memory, bend_memory;
  Buffer hessian_gaps, dxs, dus, z, scratch;

  // Segments of the horizon; empty where there are not three.
  std::vector<std::unique_ptr<ParametricSegment>> parts;
  std::vector<int> borders;        ///< where each begins, and N
  std::vector<int> failures;       ///< knot of each, or -1
  std::vector<RiccatiStep> steps;  ///< of each knot

  // Rows with limits; null where the problem has none.
  std::unique_ptr<LimitedLq> limited;
  int rows_max = 0;
  std::vector<int> row_counts;
  std::vector<int> coefficient_counts;                ///< of those that are no entries of z
  std::vector<int> row_slots;                         ///< of each row its place in `limited`
  std::vector<const double*> row_lowers, row_uppers;  ///< of each knot
  std::vector<LimitedLq::Rows> row_views;             ///< of each knot
  /// rows_max of each knot; inverses of scales
  std::vector<double> row_scales, row_inverses, row_prices, row_squares;
  std::vector<double> row_multipliers;  ///< rows_max of each knot, of the last solve
  std::vector<ValueStorage> value_list;
  std::vector<PolicyStorage> policy_list;
  std::vector<double> merit_prices;  ///< of violations, rows_max of each knot
  bool limited_before = false;       ///< policies and multipliers are those of a direction
  LimitedLqResult limited_result;
  /// What the tolerance of limits is worth, by their multipliers: the merit knows no better.
  double limit_resolution = 0.0;
  bool at_resolution = false;                 ///< the last direction gained no more than that
  Buffer corrected_gaps, kept_dxs, kept_dus;  ///< of a correction
  bool refused = false;  ///< the last whole step: the next one is tried without its expansion
  /// Hard rows without multipliers, whose violations cost squares.
  struct Elastic {
    bool on = false;
    double weight = 0.0;      ///< in units of row_unit / scale^2, of the squares
    double violation = -1.0;  ///< at the last minimum; -1: there was none
    bool stays = false;       ///< it does, however large the weight
    int lost = 0;             ///< iterations in a row whose rows could not all be kept
    int stood = 0;            ///< iterations without anything to gain, with limits broken
    int still = 0;            ///< iterations in a row in which violations stand still
    double still_from = 0.0;  ///< their sum at the first of those
  } elastic;
  bool bent = false;                 ///< the expansions' Hessians have the bends of rows
  double cost_unit = 1.0;            ///< curvature_unit() without those
  double hard_price = 0.0;           ///< in units of row_unit / scale
  std::vector<char> start_is_fixed;  ///< rows of the first knot that no control moves
  double row_unit = 0.0;      ///< curvature of the cost by a control's scale, of the first iterate
  double merit_change = 0.0;  ///< what the model says that a whole step changes the merit by

  // State of a solve.
  Clock::time_point began;
  DdpSummary summary;
  bool expanded = false;  ///< the expansions are those of the current iterate
  bool searched_at_floor = false;
  Direction direction;
  double regularization = 0.0;
  double regularization_floor = 0.0;  ///< what Quu was seen to need
  double penalty = 0.0;
  KnotValue trial_failure;
  int trial_failure_knot = -1;
};

}  // namespace burnish

// Options of a DdpSolver, and the progress that the solver reports.
#pragma once

#include <functional>
#include <limits>

namespace burnish {

/// Computation of the next iterate from a search direction.
/// @described solver
enum class StepUpdate {
  /// Rollout of the control policy through the dynamics (feasibility-driven DDP). A step of length
  /// alpha multiplies the gaps between the knots by 1 - alpha. After the first step of length 1,
  /// the trajectory is feasible.
  Rollout,
  /// Step of all states and controls along the solution of the linear-quadratic problem. Knots are
  /// evaluated independently of each other, in packs and threads. Gaps vanish with convergence.
  MultipleShooting,
};

/// Levenberg regularization: a number that is added to the diagonal of the control Hessian Quu, in
/// cost per squared unit of control.
/// @described solver
struct Regularization {
  double initial = 0.0;  ///< Regularization at the start of a solve, >= 0

  /// Smallest nonzero regularization, > 0
  /// @more A decrease below this value ends at 0. An increase from 0 starts at this value
  double smallest = 1e-9;
  double largest = 1e9;  ///< Largest regularization; if this is not enough, the solver gives up
  double factor = 10.0;  ///< Ratio by which a step changes the regularization, up or down, > 1

  /// Step length above which the regularization decreases, finite or infinite
  double decrease_above = 0.5;
  /// Step length at or below which the regularization increases, finite or infinite
  double increase_at_or_below = 0.01;
};

/// Step lengths alpha = 1, 1/2, 1/4, ... of the line search, and conditions for accepting a trial.
/// @described solver
struct LineSearch {
  /// Largest number of halvings of the step length, 0 to 60
  /// @more The smallest length is 2^-halvings
  int halvings = 9;

  /// Fraction of the expected improvement that a rollout must achieve, 0 to below 1
  /// @more Used by Rollout if the expected improvement dV(alpha) at step length alpha is >= 0. A
  /// trial is accepted if cost(current) - cost(trial) > sufficient_decrease * dV(alpha). If the
  /// current iterate is not feasible, every trial is accepted, since closing gaps may raise the
  /// cost
  double sufficient_decrease = 0.1;
  /// Allowed cost increase of a rollout, as a multiple of the expected increase, >= 0
  /// @more Used by Rollout if the expected improvement dV(alpha) at step length alpha is < 0,
  /// because closing gaps raises the cost. A trial is accepted if cost(current) - cost(trial) >
  /// allowed_increase * dV(alpha)
  double allowed_increase = 2.0;
  /// Fraction of the predicted merit decrease that a trial must achieve, 0 to below 1
  /// @more Used by MultipleShooting. The merit is cost + penalty * sum |gap|_1. D is the slope of
  /// the merit along the direction, and alpha is the step length. A trial is accepted if
  /// merit(trial) <= merit(current) + merit_decrease * alpha * D
  double merit_decrease = 1e-4;
  /// Required downward slope of the merit, as a fraction of the gap penalty, 0 to below 1
  /// @more Used by MultipleShooting. The merit is cost + penalty * sum |gap|_1. D is the slope of
  /// the merit along the direction. The penalty is raised until D <= -merit_fraction * penalty *
  /// sum |gap|_1
  double merit_fraction = 0.5;
  /// Relative rounding error of a sum of costs, >= 0
  /// @more Every comparison of the line search is relaxed by rounding * |cost|
  double rounding = 1e-14;
};

/// Options for constraints. Each iteration solves a linear-quadratic problem with an augmented
/// Lagrangian (J. Nocedal, S. Wright, "Numerical Optimization", 2006, section 17.3). The inner
/// minimization uses semismooth Newton steps (L. Qi, J. Sun, "A nonsmooth version of Newton's
/// method", 1993).
/// @described solver
struct LimitOptions {
  /// Penalty weight of the augmented Lagrangian, relative to the curvature of the cost, > 0
  /// @more The weight multiplies the square of (violation / scale of the row). A larger weight
  /// needs fewer updates of the multipliers, but increases rounding errors
  double weight = 1000.0;
  /// Largest number of Riccati factorizations per iteration, >= 1
  /// @more Factorizations of the interior-point method do not count
  int max_factorizations = 50;
  /// Largest number of Riccati sweeps per iteration that reuse a factorization, >= 0
  int max_sweeps = 100;

  /// Number of factorizations in an iteration before an interior-point method starts, >= 0
  /// @more The interior-point method finds the active set. It starts only if at least 20
  /// factorizations of max_factorizations are left. It uses at most 80 factorizations, and usually
  /// only 10 to 20 of them. With 0, it starts immediately if there are no multipliers for a warm
  /// start
  int interior_after = 8;
  /// L1 penalty weight of hard rows, in units of (curvature of the cost) / (scale of the row), > 0
  /// @more If rows remain violated at this weight, their squared violations are penalized instead,
  /// at first with this weight
  double l1_weight = 1e4;
  /// Largest penalty weight of hard rows, >= 0
  /// @more The weight is raised until all limits are met, or until the solver finds that this is
  /// impossible. With a value below `l1_weight`, the weight is never raised
  double max_l1_weight = 1e8;
  /// Constraint tolerance, relative to the scale of each row, > 0
  /// @more A limit is met if violation <= tolerance * scale of its row
  double tolerance = 1e-8;
  /// Whether steps use the curvature of constraints (friction cones, distances with an upper limit)
  /// @more Without this curvature, problems with constraints more curved than the cost take many
  /// more iterations. The solution is the same
  bool curvature = true;
};

/// Progress of a solve after one iteration, passed to the callback.
/// @described solver
struct DdpProgress {
  int iteration = 0;  ///< Number of the iteration, from 1
  double cost = 0.0;

  /// Cost decrease |d1 + d2 / 2| that the quadratic model predicts for the full step
  /// @note d1 is the slope of the model along the direction, d2 its curvature.
  double expected_improvement = 0.0;
  double largest_gap = 0.0;
  double step_length = 0.0;  ///< Accepted step length; 0: no length was accepted
  double regularization = 0.0;
  double penalty = 0.0;  ///< Penalty weight of gaps in the merit (MultipleShooting only)
  bool feasible = false;
  double violation = 0.0;  ///< Largest violation of a hard row, divided by the scale of the row
  int factorizations = 0;  ///< Riccati factorizations in this iteration
  double seconds = 0.0;    ///< Time since the solve began [s]
};

/// Options of a DdpSolver. The description of each tolerance states the inequality that uses the
/// tolerance.
/// @described solver
struct DdpOptions {
  StepUpdate update = StepUpdate::Rollout;
  int max_iterations = 100;  ///< Largest number of iterations of a solve, >= 0

  /// Time limit of a solve [s], >= 0 or infinite
  /// @more The clock is read between phases and between trials. The guess is always evaluated. The
  /// result is the best iterate so far
  double time_budget = std::numeric_limits<double>::infinity();
  int threads = 1;  ///< Number of threads, the calling thread included, 1 to 1024

  /// Pin the solver's threads to cores (Linux only)
  /// @more The available cores are those of the thread that creates the solver or sets its options.
  /// Thread i runs on the i-th available core. The thread that calls solve() is not pinned
  bool pin_threads = false;
  /// Let threads share the work within one knot of the Riccati recursion
  /// @more Used only if knots are large, such as the knots of a humanoid. Sharing is faster on
  /// cores with a common cache, and slower on others. Results are identical bit for bit
  bool share_knots = true;
  /// Number of segments of the horizon that the Riccati recursion processes in parallel, 1 to 1024
  /// @more Useful for long horizons and several cores; docs/performance.md, "Threads", says when
  /// segments are faster. Segments take up to three times the operations of a single sweep. The
  /// best number is usually threads + 1. With 1 or 2 segments, or with bounds on controls, a single
  /// sweep runs from the end to the start. The number of segments must be less than the number of
  /// knots. Gains and values equal the results of a single sweep up to rounding. For a given number
  /// of segments, results are identical bit for bit for any number of threads
  int segments = 1;
  /// Convergence tolerance of the expected improvement, in units of cost, >= 0
  /// @more The condition is expected improvement < stop_tolerance, with a feasible trajectory
  double stop_tolerance = 1e-9;
  /// Largest gap between the knots of a feasible trajectory, >= 0
  /// @more The condition is |entry| <= gap_tolerance for all entries of all gaps
  double gap_tolerance = 1e-9;
  LineSearch line_search = {};
  LimitOptions limits = {};
  Regularization regularization = {};
  /// Function called after each iteration; the result False stops the solve, None and True continue
  /// @more Exceptions of the function reach the caller of solve()
  std::function<bool(const DdpProgress&)> callback = nullptr;

  /// Throws Error if an option is out of range, with a sentence that names the option.
  void check() const;
};

}  // namespace burnish

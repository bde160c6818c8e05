// How a DdpSolver works, each tolerance beside the inequality it enters.
#pragma once

#include <functional>
#include <limits>

namespace burnish {

/// How a direction becomes the next iterate.
/// @described solver
enum class StepUpdate {
  /// The controls' policy is rolled out through the dynamics; gaps shrink by 1 - alpha. After a
  /// step of length 1 the trajectory is feasible and stays so (feasibility-driven DDP).
  Rollout,
  /// States and controls move along the solution of the linear-quadratic problem; every knot is
  /// evaluated on its own, in packs and threads. Gaps vanish with convergence.
  MultipleShooting,
};

/// Levenberg term, added to the diagonal of Quu, in cost per squared unit of control.
/// @described solver
struct Regularization {
  double initial = 0.0;  ///< >= 0
  /// Below this there is none: a decrease ends at 0, an increase from 0 begins here. > 0
  double smallest = 1e-9;
  double largest = 1e9;         ///< needed more than this: the solver gives up
  double factor = 10.0;         ///< of an increase, and 1 / factor of a decrease, > 1
  double decrease_above = 0.5;  ///< decreases after a step of length > this, finite or infinite
  /// increases after a step of length <= this, finite or infinite
  double increase_at_or_below = 0.01;
};

/// The step lengths 1, 1/2, 1/4, ... and what a trial must reach to be taken.
/// @described solver
struct LineSearch {
  int halvings = 9;  ///< the smallest length is 2^-halvings, 0 to 60
  /// Rollout, expected improvement dV(alpha) >= 0: taken if the iterate is not feasible, since
  /// closing its gaps may cost, or cost - trial > sufficient_decrease * dV(alpha). 0 to below 1
  double sufficient_decrease = 0.1;
  /// Rollout, dV(alpha) < 0 (closing gaps costs): taken if cost - trial > allowed_increase *
  /// dV(alpha). >= 0
  double allowed_increase = 2.0;
  /// MultipleShooting, merit = cost + penalty * sum |gap|_1 with slope D: taken if trial <= merit +
  /// merit_decrease * alpha * D. 0 to below 1
  double merit_decrease = 1e-4;
  /// MultipleShooting: the penalty makes D <= -merit_share * penalty * sum |gap|_1. 0 to below 1
  double merit_share = 0.5;
  /// Rounding of a sum of costs: every comparison above is relaxed by rounding * |cost|. >= 0
  double rounding = 1e-14;
};

/// How rows are kept within their limits: semismooth Newton steps on an augmented Lagrangian of the
/// linear-quadratic problem of each iteration.
/// @described solver
struct LimitOptions {
  /// Weight of a violation, in units of the cost's curvature over a row's scale. More needs fewer
  /// changes of multipliers and costs digits. > 0
  double weight = 1000.0;
  int max_factors = 50;  ///< recursions per iteration, without an interior-point method's, >= 1
  int max_sweeps = 100;  ///< with kept factors, per iteration, >= 0
  /// Recursions of an iteration after which an interior-point method finds out which rows push,
  /// where max_factors leaves 20. It takes at most 80 recursions, most often 10 to 20. 0: at once,
  /// where nothing is known of multipliers. >= 0
  int interior_after = 8;
  /// Of a violation of a hard row, and weight of its square where that price leaves some broken, in
  /// units of the cost's curvature over its scale. > 0
  double price = 1e4;
  /// What it is raised to until limits are kept, or it is known that they cannot be; below price:
  /// it stays. >= 0
  double largest_price = 1e8;
  double tolerance = 1e-8;  ///< Kept if every violation <= tolerance * scale of its row. > 0
  /// Steps know how rows bend (distances with an upper limit, friction cones). Without it limits
  /// that bend more than the cost take many more iterations, to the same solution.
  bool bends = true;
};

/// What a callback sees after each iteration.
/// @described solver
struct DdpProgress {
  int iteration = 0;  ///< from 1
  double cost = 0.0;
  /// |d1 + d2 / 2|: what the quadratic model said before the step that the whole step would save.
  double expected_improvement = 0.0;
  double largest_gap = 0.0;
  double step_length = 0.0;  ///< 0: no length was acceptable
  double regularization = 0.0;
  double penalty = 0.0;  ///< of gaps in the merit; MultipleShooting only
  bool feasible = false;
  double outside = 0.0;  ///< largest violation of a hard row, in its scale
  int factors = 0;       ///< recursions of this iteration
  double seconds = 0.0;  ///< since the solve began
};

/// How a DdpSolver works, each tolerance beside the inequality it enters.
/// @described solver
struct DdpOptions {
  StepUpdate update = StepUpdate::Rollout;
  int max_iterations = 100;  ///< >= 0
  /// Seconds, looked at between phases and between trials; the best iterate so far is kept. At
  /// least the guess is evaluated. >= 0 or infinite
  double time_budget = std::numeric_limits<double>::infinity();
  int threads = 1;  ///< 1 to 1024
  /// Thread i of the solver stays on the i-th core that the thread which makes it (or gives it
  /// options) may run on. The thread that solves is left as it is. Linux alone.
  bool pin_threads = false;
  /// Threads work together on each knot of the recursion where knots are large (a humanoid's),
  /// which is faster on cores that share a cache and slower on others. Results have the same bits.
  bool share_knots = true;
  /// The recursion works on so many parts of the horizon at the same time, for long horizons and
  /// several cores: docs/performance.md, "Threads", says when that is faster. It makes up to three
  /// times the operations, and threads + 1 segments suit `threads` best; 1 and 2 mean one sweep
  /// from the end to the begin, as do bounds on controls. Fewer than the problem has knots. Gains
  /// and values are those of the whole horizon, but for rounding; their bits depend on this number
  /// and not on that of threads. 1 to 1024
  int segments = 1;
  /// Converged if feasible and expected improvement < stop_tolerance (in units of cost). >= 0
  double stop_tolerance = 1e-9;
  double gap_tolerance = 1e-9;  ///< Feasible if every |entry of a gap| <= gap_tolerance. >= 0
  LineSearch line_search = {};
  LimitOptions limits = {};
  Regularization regularization = {};
  /// called after each iteration; False stops the solve, None and True go on, and what it raises
  /// reaches the caller of solve()
  std::function<bool(const DdpProgress&)> callback = nullptr;

  /// Throws Error with a sentence naming the option that is out of range.
  void check() const;
};

}  // namespace burnish

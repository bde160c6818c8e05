// Solver for optimal control problems: differential dynamic programming (DDP) with multiple
// shooting, Gauss-Newton Hessians, infeasible starts and bounds on controls. A Riccati recursion
// computes the search direction. A rollout with feedback computes the next iterate, as in Mastalli
// et al., "Crocoddyl" (2020) and "A feasibility-driven approach to control-limited DDP" (2022).
// With StepUpdate::MultipleShooting, all states and controls move along the direction instead.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/solver/options.hpp"
#include "burnish/solver/shooting_problem.hpp"

namespace burnish {

/// Reason why a solve ended.
/// @described solver
enum class StopReason {
  /// The trajectory is feasible and meets all limits. The expected improvement is below
  /// stop_tolerance, or below the change of cost that the allowed constraint violation can cause.
  Converged,
  MaxIterations,  ///< The solver reached max_iterations.
  TimeBudget,     ///< The solver used up its time_budget.

  /// A knot of the iterate cannot be evaluated: see DdpSummary.status, knot and term.
  NotEvaluated,

  /// The control Hessian Quu of a knot is not positive definite, even with the largest
  /// regularization.
  NotPositiveDefinite,
  /// No nearby trajectory meets all hard limits: see DdpSummary.conflict. The result violates hard
  /// limits as little as possible. Another possible cause is an initial state that violates a hard
  /// limit with any control: see DdpSummary.start_violations.
  Infeasible,
  NoStep,    ///< No step length was accepted, even with the largest regularization.
  Callback,  ///< The callback stopped the solve.
};

/// Computing time of a solve, by phase [s].
/// @described solver
struct PhaseTimes {
  double expand = 0.0;    ///< Evaluation of values and derivatives [s]
  double backward = 0.0;  ///< Riccati recursion [s]
  double trial = 0.0;     ///< Rollouts and evaluations of the line search [s]
  double total = 0.0;
};

/// A constraint row at one knot.
/// @described solver @result
struct RowPlace {
  int knot = 0;
  int row = 0;  ///< Index of the row among the knot's constraint rows
};

/// A hard constraint row of the first knot that the initial state violates, whatever the control.
/// @described solver @result
struct StartRow {
  int row = 0;         ///< Index of the row among the constraint rows of the first knot
  double value = 0.0;  ///< Value of the row at the initial state, in the row's unit
  double lower = 0.0;  ///< Lower limit of the row; infinite if it has none
  double upper = 0.0;  ///< Upper limit of the row; infinite if it has none
};

/// Result of a solve: the reason why it ended, and the quality of the trajectory.
/// @described solver
struct DdpSummary {
  StopReason reason = StopReason::MaxIterations;
  int iterations = 0;  ///< Number of iterations, each with one line search
  double cost = 0.0;   ///< Cost of the returned trajectory

  /// True if no gap between two steps exceeds gap_tolerance, and all hard constraint rows are
  /// within their limits
  bool feasible = false;
  double expected_improvement = 0.0;  ///< Expected improvement along the last search direction
  double regularization = 0.0;        ///< Regularization of the last search direction

  /// Largest gap in the returned trajectory, between the end of a step and the next state
  double largest_gap = 0.0;
  /// Knot k at which x_k differs most from the end of step k - 1 (k = 0: from the initial state)
  int gap_knot = 0;
  int gap_entry = 0;  ///< Entry of dx with the largest gap

  /// Largest violation of a hard constraint row in the returned trajectory, divided by the row's
  /// scale
  double violation = 0.0;
  int violation_knot = -1;  ///< Knot with the largest violation; -1: no hard row is violated
  int violation_row = -1;   ///< Row with the largest violation; -1: no hard row is violated

  /// Constraint residual after the last iteration, relative to the scales of the rows
  double constraint_residual = 0.0;
  int active_constraints = 0;  ///< Number of active constraint rows

  /// Number of hard rows that cannot be satisfied, because their multipliers have reached the L1
  /// penalty weight
  int unsatisfiable_rows = 0;
  /// Violated rows, the worst first; empty unless the reason is Infeasible
  std::vector<RowPlace> conflict = {};
  /// Active rows that oppose the rows in `conflict`; empty unless the reason is Infeasible
  /// @more Sorted by |multiplier| * scale, the largest first
  std::vector<RowPlace> stopping = {};
  /// Hard rows that the initial state violates, whatever the control; filled for every stop reason
  std::vector<StartRow> start_violations = {};
  /// Status of the failed evaluation
  /// @more Set for NotEvaluated, and for NoStep if the last trial could not be evaluated
  Status status = Status::Ok;
  /// Knot of the failure; -1: none
  /// @more Set for NotEvaluated and NotPositiveDefinite, and for NoStep if the last trial could not
  /// be evaluated
  int knot = -1;
  /// Cost term that is not finite; -1: none
  /// @more If -1, the cause can be a constraint row or the dynamics
  int term = -1;
  int row = -1;  ///< Constraint row that is not finite; -1: none

  /// True if values are finite but derivatives are not finite; only for NotEvaluated
  bool in_derivatives = false;
  /// First control whose pivot in the control Hessian Quu is not positive; only for
  /// NotPositiveDefinite
  int control = -1;
  DdpOptions options;  ///< Options of the solve, without the callback
  PhaseTimes seconds;
  std::vector<DdpProgress> log;  ///< Progress after each iteration

  /// Returns one sentence that says why the solver stopped. Names of knots and rows come from
  /// `problem`.
  std::string text(const ShootingProblem& problem) const;
};

/// Costs of a trajectory, by term and by knot, and the values of its constraint rows.
/// @described solver @result
struct CostReport {
  /// Cost of one term.
  /// @described solver.CostEntry @result
  struct Entry {
    std::string name;
    double cost;
  };
  /// Cost of one knot.
  /// @described solver.CostKnot @result
  struct Knot {
    std::string name;
    double cost;
    std::vector<Entry> terms;
  };
  /// A constraint row at its worst knot: the knot with the largest violation. If the row is never
  /// violated, the worst knot is the knot at which the row is closest to a limit.
  /// @described solver.LimitedRow @result
  struct Row {
    std::string name;  ///< Name of the row, as in Problem.row_names
    std::string knot;  ///< Name of the knot, as in Problem.knot_name
    double value;
    double lower;
    double upper;
    /// Violation of the limits; negative within them: minus the distance to the nearest limit
    double violation;
    double scale = 0.0;  ///< Characteristic size of the row, in the row's unit

    /// Multiplier with the largest magnitude over all knots; see multipliers()
    double multiplier = 0.0;
    /// Name of the knot with the largest multiplier; empty: the row is active at no knot
    std::string pushed = {};
    int active = 0;  ///< Number of knots at which the row is active

    /// Returns true if the violation is larger than the solver's tolerance, or not a number.
    bool broken() const;
  };
  /// A constraint row at a knot where it is active or violated.
  /// @described solver @result
  struct ActiveLimit {
    int knot = 0;             ///< Index of the knot, 0 to N
    std::string row = {};     ///< Name of the row, as in Problem.row_names
    double value = 0.0;       ///< Value of the row, in the row's unit
    double lower = 0.0;       ///< Lower limit of the row; infinite if it has none
    double upper = 0.0;       ///< Upper limit of the row; infinite if it has none
    double multiplier = 0.0;  ///< Multiplier, in cost per unit of the row; see multipliers()
  };
  double total = 0.0;
  std::vector<Entry> terms;  ///< Cost of each term, summed over the knots; in order of appearance
  std::vector<Knot> knots;   ///< Cost of each knot, N + 1 entries
  std::vector<Row> rows;     ///< One entry for each constraint row, in order of appearance
  std::vector<ActiveLimit> limits;  ///< Active or violated rows, knot by knot

  /// Returns rows that are active at any knot, sorted by |multiplier| * scale, the largest first.
  std::vector<Row> active_constraints() const;

  /// Returns a readable table of the terms, the most expensive first. The table also has the five
  /// most expensive knots, the five most violated rows, and the five active rows with the largest
  /// |multiplier| * scale.
  std::string text() const;
};

/// Read-only view of a row-major matrix with padded rows; copies nothing.
using PaddedView = Eigen::Map<const RowMatrix, Eigen::Unaligned, Eigen::OuterStride<>>;

/// A matrix with a name for each row and each column.
/// @described solver @result
struct NamedMatrix {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  Eigen::MatrixXd values;
};

/// Solver of a ShootingProblem; the problem must outlive the solver. Results remain valid until the
/// next solve. Results are identical bit for bit for any number of threads. Between solves, costs,
/// references, bounds, the initial state and the number of controls of each knot may change. All
/// other sizes of the problem must stay the same.
class DdpSolver {
 public:
  /// Creates a solver and allocates all its memory. The first guess is the initial state at every
  /// knot, with zero controls. Throws Error if an option is out of range, or if the problem's sizes
  /// are inconsistent.
  explicit DdpSolver(ShootingProblem& problem, DdpOptions options = {});
  ~DdpSolver();
  DdpSolver(DdpSolver&&) noexcept;
  DdpSolver& operator=(DdpSolver&&) noexcept;

  const DdpOptions& options() const;
  /// Replaces the options; may allocate. Throws Error if an option is out of range, or if
  /// `segments` is not less than the number of knots.
  void set_options(DdpOptions options);
  /// Sets DdpOptions::time_budget [s] without allocating. A negative number or a NaN counts as 0.
  void set_time_budget(double seconds);
  /// Sets DdpOptions::max_iterations without allocating. Negative numbers count as 0. The upper
  /// limit is the max_iterations that the constructor or set_options() received.
  void set_max_iterations(int iterations);
  /// Sets LimitOptions::max_factorizations (at least 1) and LimitOptions::max_sweeps (at least 0),
  /// without allocating.
  void set_limit_budget(int max_factorizations, int max_sweeps) noexcept;

  /// Sets the guess for the next solve: states xs, (N + 1) x nx, and controls us, N x max_controls,
  /// with one row per knot. Without this call, a solve starts from the last result. Throws Error
  /// for matrices of other sizes.
  void set_guess(const Eigen::Ref<const RowMatrix>& xs, const Eigen::Ref<const RowMatrix>& us);
  /// Sets the guess for the next solve from raw memory in the layout of TrajectoryView. Throws
  /// nothing.
  void set_guess(const TrajectoryView& guess);
  /// Discards the constraint multipliers: the next solve starts without multipliers, as in a new
  /// solver.
  void forget_limits() noexcept;
  /// Shifts the constraint multipliers by `knots` knots, to follow a receding horizon. The next
  /// solve starts knot k with the multipliers of knot k + knots. The last `knots` knots retain
  /// their multipliers. If `knots` <= 0, nothing changes.
  void shift_limits(int knots) noexcept;
  /// Shifts the constraint multipliers of a receding horizon with knots of different length. The
  /// next solve starts knot k with the multipliers of knot from[k]. Entries of `from` must not
  /// decrease, and from[k] must be at least k. An entry above the last knot means the last knot.
  /// Knot k retains its own multipliers if `from` has no entry k, or if knots k and from[k] differ
  /// in the number of controls.
  void shift_limits(std::span<const int> from) noexcept;

  /// Iterates until one of the StopReasons occurs, and returns the summary. Allocates nothing and
  /// throws nothing itself. An exception from the callback or from the problem, in any thread,
  /// reaches the caller. The solver then holds the last evaluated trajectory, from which the next
  /// solve starts.
  const DdpSummary& solve();
  const DdpSummary& summary() const;
  std::string text() const;  ///< Returns summary().text() with names from the problem.

  MatrixView xs() const;  ///< States, (N + 1) x nx

  /// Controls, N x max_controls; in row k, only the first controls(k) entries are valid
  MatrixView us() const;

  /// Return the control policy of a knot: u = u_k + feedforward + gain (x (-) x_k). Here
  /// feedforward has nu entries, gain is nu x ndx, and (x_k, u_k) is the last linearized iterate.
  /// After convergence, (x_k, u_k) is the solution, and the feedforward is zero.
  VectorView feedforward(int knot) const;
  PaddedView gain(int knot) const;
  /// Returns the multipliers of a knot's constraint rows, in cost per unit of the row. The
  /// magnitude is the cost that would be saved per unit of the row if the active limit moved
  /// outwards. The sign is positive if the upper limit is active, and negative if the lower limit
  /// is active. The magnitude is at most the row's L1 penalty weight. Empty if the problem has no
  /// constraint rows.
  VectorView multipliers(int knot) const;
  /// Return the gradient (ndx) and the Hessian (ndx x ndx) of the value function at a knot, 0 to N.
  /// Both are taken at the last linearized iterate.
  VectorView value_gradient(int knot) const;
  PaddedView value_hessian(int knot) const;
  /// Return copies of gain() and value_hessian(), with the names of controls and entries of dx.
  NamedMatrix named_gain(int knot) const;
  NamedMatrix named_value_hessian(int knot) const;

  /// Returns the cost of the current trajectory by term and by knot. Allocates.
  CostReport cost_report() const;
  /// Returns the optimality error of the current trajectory: the largest entry of the Lagrangian's
  /// gradient with respect to the controls, in cost per unit of control. Multipliers of the
  /// dynamics are chosen such that the gradient with respect to the states is zero. Controls at an
  /// active bound do not count. Returns infinity if a knot cannot be evaluated.
  double optimality_error();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish

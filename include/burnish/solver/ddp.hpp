// Differential dynamic programming with multiple shooting: Gauss-Newton Hessians, starts that need
// not be feasible, bounds on controls. The direction comes from the Riccati recursion; it becomes
// an iterate by a rollout with feedback, as in Mastalli et al., "Crocoddyl" (2020) and "A
// feasibility-driven approach to control-limited DDP" (2022), or by moving all states and controls
// along it; see StepUpdate.
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

/// Why a solve ended.
/// @described solver
enum class StopReason {
  /// feasible, limits kept, and the expected improvement is below stop_tolerance, or what the
  /// tolerance of limits is worth
  Converged,
  MaxIterations,        ///< max_iterations were made
  TimeBudget,           ///< time_budget was spent
  NotEvaluated,         ///< a knot of the iterate cannot be evaluated: see status, knot, term
  NotPositiveDefinite,  ///< Quu of a knot, with the largest regularisation
  Infeasible,  ///< no trajectory near keeps all limits; this one breaks them least: see conflict
  NoStep,      ///< no step length was acceptable, with the largest regularisation
  Callback,    ///< the callback asked for it
};

/// Seconds of a solve by phase.
/// @described solver
struct PhaseTimes {
  double expand = 0.0;    ///< values and derivatives
  double backward = 0.0;  ///< Riccati recursion
  double trial = 0.0;     ///< rollouts and evaluations of the line search
  double total = 0.0;
};

/// A row with limits at a knot.
/// @described solver @result
struct RowPlace {
  int knot = 0;
  int row = 0;  ///< of those of the knot
};

/// A hard row of the first knot that the initial state alone puts outside its limits.
/// @described solver @result
struct StartRow {
  int row = 0;         ///< of those of the first knot
  double value = 0.0;  ///< in the row's unit
  double lower = 0.0;  ///< infinite where there is none
  double upper = 0.0;  ///< likewise
};

/// Why a solve ended and what it reached.
/// @described solver
struct DdpSummary {
  StopReason reason = StopReason::MaxIterations;
  int iterations = 0;  ///< line searches made
  double cost = 0.0;   ///< of the trajectory that is returned
  /// No gap is above gap_tolerance, and every hard row is within its limits.
  bool feasible = false;
  double expected_improvement = 0.0;  ///< the last one computed
  double regularization = 0.0;        ///< the last one used
  double largest_gap = 0.0;           ///< of the trajectory that is returned
  int gap_knot = 0;   ///< where: the state that the gap leads to, 0 for the initial one
  int gap_entry = 0;  ///< entry of dx
  /// largest violation of a hard row, in its scale, of the trajectory that is returned
  double outside = 0.0;
  int outside_knot = -1;  ///< where; -1: every row is within its limits
  int outside_row = -1;
  double limits_open = 0.0;  ///< what the last iteration's steps left of limits, in their scale
  int pushing = 0;           ///< rows that push
  /// hard rows that push with all that their price allows, since they cannot be kept
  int given_way = 0;
  std::vector<RowPlace> conflict = {};  ///< Infeasible: rows outside their limits, worst first
  /// Infeasible: rows that push against those in conflict, from the hardest down.
  std::vector<RowPlace> stopping = {};
  std::vector<StartRow> start_outside = {};  ///< whatever the reason
  /// NotEvaluated, NotPositiveDefinite, and NoStep where the last trial could not be evaluated:
  /// where and what.
  Status status = Status::Ok;
  int knot = -1;
  int term = -1;                ///< cost term that is not finite, -1: none, a row or the dynamics
  int row = -1;                 ///< row of a constraint that is not finite, -1: none
  bool in_derivatives = false;  ///< NotEvaluated: values are finite, derivatives are not
  int control = -1;             ///< NotPositiveDefinite: the first one whose pivot is not positive
  DdpOptions options;           ///< those it was solved with, without callback
  PhaseTimes seconds;
  std::vector<DdpProgress> log;  ///< an entry per iteration

  /// One sentence that says why the solver stopped, with names from the problem.
  std::string text(const ShootingProblem& problem) const;
};

/// Where a cost comes from.
/// @described solver @result
struct CostReport {
  /// What one cost term adds.
  /// @described solver.CostEntry @result
  struct Entry {
    std::string name;
    double cost;
  };
  /// What one knot costs.
  /// @described solver.CostKnot @result
  struct Knot {
    std::string name;
    double cost;
    std::vector<Entry> terms;
  };
  /// A row of a constraint, where it is furthest outside its limits, or nearest to one of them from
  /// inside.
  /// @described solver.LimitedRow @result
  struct Row {
    std::string name;  ///< as Problem.row_names has it
    std::string knot;  ///< as Problem.knot_name has it
    double value;
    double lower;
    double upper;
    double outside;           ///< how far; negative: the least distance to a limit from inside
    double scale = 0.0;       ///< in its unit: what counts as much of it
    double multiplier = 0.0;  ///< of the horizon the largest: see multipliers()
    std::string pushed = {};  ///< the knot that has that
    int active = 0;           ///< knots at which a limit pushes

    /// Outside by more than limits are kept to, or no number.
    bool broken() const;
  };
  /// A row at a knot where its limit pushes or is broken.
  /// @described solver @result
  struct ActiveLimit {
    int knot = 0;             ///< 0 to N
    std::string row = {};     ///< as Problem.row_names has it
    double value = 0.0;       ///< in the row's unit
    double lower = 0.0;       ///< infinite where there is none
    double upper = 0.0;       ///< likewise
    double multiplier = 0.0;  ///< cost per unit of the row; see multipliers()
  };
  double total = 0.0;
  std::vector<Entry> terms;         ///< summed over knots, in order of appearance
  std::vector<Knot> knots;          ///< N + 1
  std::vector<Row> rows;            ///< over all knots, in order of appearance
  std::vector<ActiveLimit> limits;  ///< along the horizon, knot by knot in the order of its rows

  /// The rows whose limits push, by their scale from the hardest down.
  std::vector<Row> pushing() const;

  /// A table for people: terms from the largest down, the five most expensive knots, the five rows
  /// that are furthest outside their limits, and the five whose limits push hardest by their scale.
  std::string text() const;
};

/// A matrix whose rows are padded, read in place.
using PaddedView = Eigen::Map<const RowMatrix, Eigen::Unaligned, Eigen::OuterStride<>>;

/// A result with the names of what its rows and columns stand for.
/// @described solver @result
struct NamedMatrix {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  Eigen::MatrixXd values;
};

/// Solves a ShootingProblem, which must outlive it; results are valid until the next solve. Between
/// solves the problem may change costs, references, bounds, the initial state and which knots have
/// how many controls, but not its sizes. Results have the same bits for any number of threads.
class DdpSolver {
 public:
  /// Allocates everything; the guess is the initial state at every knot and zero controls. Throws
  /// Error for options out of range and for problems whose sizes do not fit together.
  explicit DdpSolver(ShootingProblem& problem, DdpOptions options = {});
  ~DdpSolver();
  DdpSolver(DdpSolver&&) noexcept;
  DdpSolver& operator=(DdpSolver&&) noexcept;

  const DdpOptions& options() const;
  /// May allocate. Throws Error as the constructor does.
  void set_options(DdpOptions options);
  /// Allocates nothing. Anything but a number >= 0 means no time at all.
  void set_time_budget(double seconds);
  /// Allocates nothing; at most what the options said when the solver was made or given options.
  void set_max_iterations(int iterations);
  /// LimitOptions::max_factors and max_sweeps, at least 1 and 0.
  void set_limit_budget(int max_factors, int max_sweeps) noexcept;

  /// Where the next solve starts: xs (N + 1) x nx, us N x max_controls, a row per knot. Without a
  /// call it starts where the last one ended. Throws Error for other sizes.
  void set_guess(const Eigen::Ref<const RowMatrix>& xs, const Eigen::Ref<const RowMatrix>& us);
  /// The same from plain memory, laid out as TrajectoryView says; throws nothing.
  void set_guess(const TrajectoryView& guess);
  /// The next solve starts without the multipliers of the last one, as a solver does that is new.
  void forget_limits() noexcept;
  /// The next solve starts with the multipliers of the last one that many knots later: knot k with
  /// those of knot k + knots, as a horizon does that has moved on by so much. The last knots keep
  /// theirs, and so do all for a number that is not above zero.
  void shift_limits(int knots) noexcept;
  /// The same where knots are of different lengths: knot k with those of knot from[k], as far as
  /// there are entries. They are not to fall, nor to be before k; later knots than the last count
  /// as that, and a knot with other controls gives none.
  void shift_limits(std::span<const int> from) noexcept;

  /// Iterates until one of StopReason. Allocates nothing and throws nothing of its own: what the
  /// callback or a function of the problem throws, in any thread, reaches the caller. The
  /// trajectory is then the last one that was evaluated, and the next solve starts from it as
  /// usual.
  const DdpSummary& solve();
  const DdpSummary& summary() const;
  std::string text() const;  ///< summary().text() with the problem's names

  MatrixView xs() const;  ///< (N + 1) x nx
  MatrixView us() const;  ///< N x max_controls; entries past a knot's nu mean nothing
  /// Policy u = u_k + feedforward + gain (x (-) x_k) about the iterate that was expanded last;
  /// after convergence about the solution, with a feedforward of zero. nu; nu x ndx.
  VectorView feedforward(int knot) const;
  PaddedView gain(int knot) const;
  /// Of the knot's rows: the cost that a limit's being one unit further out would save, in units of
  /// cost per unit of the row, above zero where the upper one pushes. At most a row's price. Empty
  /// where the problem has no limits.
  VectorView multipliers(int knot) const;
  /// Value function about the same iterate: ndx; ndx x ndx. Knots 0 to N.
  VectorView value_gradient(int knot) const;
  PaddedView value_hessian(int knot) const;
  /// The same with names of controls and of entries of dx.
  NamedMatrix named_gain(int knot) const;
  NamedMatrix named_value_hessian(int knot) const;

  /// Cost of the present trajectory by term and by knot. Allocates.
  CostReport cost_report() const;
  /// Largest entry of the gradient of the Lagrangian by the controls at the present trajectory,
  /// with the multipliers that make its gradient by the states vanish; entries that push against a
  /// bound do not count. Infinite where a knot cannot be evaluated. Cost per unit of control.
  double optimality_error();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish

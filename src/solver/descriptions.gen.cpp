// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "solver/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(StopReason /*of*/) {
  static const Words all{
      "solver",
      "StopReason",
      "Reason why a solve ended.",
      {{"converged", "The trajectory is feasible and meets all limits. The expected improvement is below "
        "stop_tolerance, or below the change of cost that the allowed constraint violation can "
        "cause."},
       {"max_iterations", "The solver reached max_iterations."},
       {"time_budget", "The solver used up its time_budget."},
       {"not_evaluated", "A knot of the iterate cannot be evaluated: see DdpSummary.status, knot and term."},
       {"not_positive_definite", "The control Hessian Quu of a knot is not positive definite, even with the largest "
        "regularization."},
       {"infeasible", "No nearby trajectory meets all hard limits: see DdpSummary.conflict. The result violates"
        " hard limits as little as possible. Another possible cause is an initial state that "
        "violates a hard limit with any control: see DdpSummary.start_violations."},
       {"no_step", "No step length was accepted, even with the largest regularization."},
       {"callback", "The callback stopped the solve."}}};
  return all;
}

const Description& description_of(const PhaseTimes* /*of*/) {
  using S = PhaseTimes;
  static const Description all =
      Describe<S>("solver", "PhaseTimes",
                  "Computing time of a solve, by phase [s].")
          .field("expand", &S::expand,
                 "Evaluation of values and derivatives [{s}]")
          .field("backward", &S::backward,
                 "Riccati recursion [{s}]")
          .field("trial", &S::trial,
                 "Rollouts and evaluations of the line search [{s}]")
          .field("total", &S::total);
  return all;
}

const Description& description_of(const RowPlace* /*of*/) {
  using S = RowPlace;
  static const Description all =
      Describe<S>("solver", "RowPlace",
                  "A constraint row at one knot.")
          .result()
          .field("knot", &S::knot)
          .field("row", &S::row,
                 "Index of the row among the knot's constraint rows");
  return all;
}

const Description& description_of(const StartRow* /*of*/) {
  using S = StartRow;
  static const Description all =
      Describe<S>("solver", "StartRow",
                  "A hard constraint row of the first knot that the initial state violates, "
                  "whatever the control.")
          .result()
          .field("row", &S::row,
                 "Index of the row among the constraint rows of the first knot")
          .field("value", &S::value,
                 "Value of the row at the initial state, in the row's unit")
          .field("lower", &S::lower,
                 "Lower limit of the row; infinite if it has none")
          .field("upper", &S::upper,
                 "Upper limit of the row; infinite if it has none");
  return all;
}

const Description& description_of(const DdpSummary* /*of*/) {
  using S = DdpSummary;
  static const Description all =
      Describe<S>("solver", "DdpSummary",
                  "Result of a solve: the reason why it ended, and the quality of the trajectory.")
          .field("reason", &S::reason)
          .field("iterations", &S::iterations,
                 "Number of iterations, each with one line search")
          .field("cost", &S::cost,
                 "Cost of the returned trajectory")
          .field("feasible", &S::feasible,
                 "True if no gap between two steps exceeds gap_tolerance, and all hard constraint"
                 " rows are within their limits")
          .field("expected_improvement", &S::expected_improvement,
                 "Expected improvement along the last search direction")
          .field("regularization", &S::regularization,
                 "Regularization of the last search direction")
          .field("largest_gap", &S::largest_gap,
                 "Largest gap in the returned trajectory, between the end of a step and the next "
                 "state")
          .field("gap_knot", &S::gap_knot,
                 "Knot k at which x_k differs most from the end of step k - 1 (k = 0: from the "
                 "initial state)")
          .field("gap_entry", &S::gap_entry,
                 "Entry of dx with the largest gap")
          .field("violation", &S::violation,
                 "Largest violation of a hard constraint row in the returned trajectory, divided "
                 "by the row's scale")
          .field("violation_knot", &S::violation_knot,
                 "Knot with the largest violation; -1: no hard row is violated")
          .field("violation_row", &S::violation_row,
                 "Row with the largest violation; -1: no hard row is violated")
          .field("constraint_residual", &S::constraint_residual,
                 "Constraint residual after the last iteration, relative to the scales of the "
                 "rows")
          .field("active_constraints", &S::active_constraints,
                 "Number of active constraint rows")
          .field("unsatisfiable_rows", &S::unsatisfiable_rows,
                 "Number of hard rows that cannot be satisfied, because their multipliers have "
                 "reached the L1 penalty weight")
          .field("conflict", &S::conflict,
                 "Violated rows, the worst first; empty unless the reason is Infeasible")
          .field("stopping", &S::stopping,
                 "Active rows that oppose the rows in `conflict`; empty unless the reason is "
                 "Infeasible")
          .more("Sorted by |multiplier| * scale, the largest first")
          .field("start_violations", &S::start_violations,
                 "Hard rows that the initial state violates, whatever the control; filled for "
                 "every stop reason")
          .field("status", &S::status,
                 "Status of the failed evaluation")
          .more("Set for NotEvaluated, and for NoStep if the last trial could not be evaluated")
          .field("knot", &S::knot,
                 "Knot of the failure; -1: none")
          .more("Set for NotEvaluated and NotPositiveDefinite, and for NoStep if the last trial "
                "could not be evaluated")
          .field("term", &S::term,
                 "Cost term that is not finite; -1: none")
          .more("If -1, the cause can be a constraint row or the dynamics")
          .field("row", &S::row,
                 "Constraint row that is not finite; -1: none")
          .field("in_derivatives", &S::in_derivatives,
                 "True if values are finite but derivatives are not finite; only for NotEvaluated")
          .field("control", &S::control,
                 "First control whose pivot in the control Hessian Quu is not positive; only for "
                 "NotPositiveDefinite")
          .field("options", &S::options,
                 "Options of the solve, without the callback")
          .field("seconds", &S::seconds)
          .field("log", &S::log,
                 "Progress after each iteration");
  return all;
}

const Description& description_of(const CostReport* /*of*/) {
  using S = CostReport;
  static const Description all =
      Describe<S>("solver", "CostReport",
                  "Costs of a trajectory, by term and by knot, and the values of its constraint "
                  "rows.")
          .result()
          .field("total", &S::total)
          .field("terms", &S::terms,
                 "Cost of each term, summed over the knots; in order of appearance")
          .field("knots", &S::knots,
                 "Cost of each knot, N + 1 entries")
          .field("rows", &S::rows,
                 "One entry for each constraint row, in order of appearance")
          .field("limits", &S::limits,
                 "Active or violated rows, knot by knot");
  return all;
}

const Description& description_of(const CostReport::Entry* /*of*/) {
  using S = CostReport::Entry;
  static const Description all =
      Describe<S>("solver", "CostEntry",
                  "Cost of one term.")
          .result()
          .field("name", &S::name)
          .field("cost", &S::cost);
  return all;
}

const Description& description_of(const CostReport::Knot* /*of*/) {
  using S = CostReport::Knot;
  static const Description all =
      Describe<S>("solver", "CostKnot",
                  "Cost of one knot.")
          .result()
          .field("name", &S::name)
          .field("cost", &S::cost)
          .field("terms", &S::terms);
  return all;
}

const Description& description_of(const CostReport::Row* /*of*/) {
  using S = CostReport::Row;
  static const Description all =
      Describe<S>("solver", "LimitedRow",
                  "A constraint row at its worst knot: the knot with the largest violation. If "
                  "the row is never violated, the worst knot is the knot at which the row is "
                  "closest to a limit.")
          .result()
          .field("name", &S::name,
                 "Name of the row, as in Problem.row_names")
          .field("knot", &S::knot,
                 "Name of the knot, as in Problem.knot_name")
          .field("value", &S::value)
          .field("lower", &S::lower)
          .field("upper", &S::upper)
          .field("violation", &S::violation,
                 "Violation of the limits; negative within them: minus the distance to the "
                 "nearest limit")
          .field("scale", &S::scale,
                 "Characteristic size of the row, in the row's unit")
          .field("multiplier", &S::multiplier,
                 "Multiplier with the largest magnitude over all knots; see multipliers()")
          .field("pushed", &S::pushed,
                 "Name of the knot with the largest multiplier; empty: the row is active at no "
                 "knot")
          .field("active", &S::active,
                 "Number of knots at which the row is active");
  return all;
}

const Description& description_of(const CostReport::ActiveLimit* /*of*/) {
  using S = CostReport::ActiveLimit;
  static const Description all =
      Describe<S>("solver", "ActiveLimit",
                  "A constraint row at a knot where it is active or violated.")
          .result()
          .field("knot", &S::knot,
                 "Index of the knot, 0 to N")
          .field("row", &S::row,
                 "Name of the row, as in Problem.row_names")
          .field("value", &S::value,
                 "Value of the row, in the row's unit")
          .field("lower", &S::lower,
                 "Lower limit of the row; infinite if it has none")
          .field("upper", &S::upper,
                 "Upper limit of the row; infinite if it has none")
          .field("multiplier", &S::multiplier,
                 "Multiplier, in cost per unit of the row; see multipliers()");
  return all;
}

const Description& description_of(const NamedMatrix* /*of*/) {
  using S = NamedMatrix;
  static const Description all =
      Describe<S>("solver", "NamedMatrix",
                  "A matrix with a name for each row and each column.")
          .result()
          .field("rows", &S::rows)
          .field("columns", &S::columns)
          .field("values", &S::values);
  return all;
}

const Words& words_of(StepUpdate /*of*/) {
  static const Words all{
      "solver",
      "StepUpdate",
      "Computation of the next iterate from a search direction.",
      {{"rollout", "Rollout of the control policy through the dynamics (feasibility-driven DDP). A step of "
        "length alpha multiplies the gaps between the knots by 1 - alpha. After the first step of"
        " length 1, the trajectory is feasible."},
       {"multiple_shooting", "Step of all states and controls along the solution of the linear-quadratic problem. "
        "Knots are evaluated independently of each other, in packs and threads. Gaps vanish with "
        "convergence."}}};
  return all;
}

const Description& description_of(const Regularization* /*of*/) {
  using S = Regularization;
  static const Description all =
      Describe<S>("solver", "Regularization",
                  "Levenberg regularization: a number that is added to the diagonal of the "
                  "control Hessian Quu, in cost per squared unit of control.")
          .field("initial", &S::initial,
                 "Regularization at the start of a solve",
                 {.least = 0})
          .field("smallest", &S::smallest,
                 "Smallest nonzero regularization",
                 {.least = 0, .open = true})
          .more("A decrease below this value ends at 0. An increase from 0 starts at this value")
          .field("largest", &S::largest,
                 "Largest regularization; if this is not enough, the solver gives up")
          .field("factor", &S::factor,
                 "Ratio by which a step changes the regularization, up or down",
                 {.least = 1, .open = true})
          .field("decrease_above", &S::decrease_above,
                 "Step length above which the regularization decreases",
                 {.infinite = true})
          .field("increase_at_or_below", &S::increase_at_or_below,
                 "Step length at or below which the regularization increases",
                 {.infinite = true});
  return all;
}

const Description& description_of(const LineSearch* /*of*/) {
  using S = LineSearch;
  static const Description all =
      Describe<S>("solver", "LineSearch",
                  "Step lengths alpha = 1, 1/2, 1/4, ... of the line search, and conditions for "
                  "accepting a trial.")
          .field("halvings", &S::halvings,
                 "Largest number of halvings of the step length",
                 {.least = 0, .most = 60})
          .more("The smallest length is 2^-halvings")
          .field("sufficient_decrease", &S::sufficient_decrease,
                 "Fraction of the expected improvement that a rollout must achieve",
                 {.least = 0, .most = 1, .below = true})
          .more("Used by Rollout if the expected improvement dV(alpha) at step length alpha is >="
                " 0. A trial is accepted if cost(current) - cost(trial) > sufficient_decrease * "
                "dV(alpha). If the current iterate is not feasible, every trial is accepted, "
                "since closing gaps may raise the cost")
          .field("allowed_increase", &S::allowed_increase,
                 "Allowed cost increase of a rollout, as a multiple of the expected increase",
                 {.least = 0})
          .more("Used by Rollout if the expected improvement dV(alpha) at step length alpha is < "
                "0, because closing gaps raises the cost. A trial is accepted if cost(current) - "
                "cost(trial) > allowed_increase * dV(alpha)")
          .field("merit_decrease", &S::merit_decrease,
                 "Fraction of the predicted merit decrease that a trial must achieve",
                 {.least = 0, .most = 1, .below = true})
          .more("Used by MultipleShooting. The merit is cost + penalty * sum |gap|_1. D is the "
                "slope of the merit along the direction, and alpha is the step length. A trial is"
                " accepted if merit(trial) <= merit(current) + merit_decrease * alpha * D")
          .field("merit_fraction", &S::merit_fraction,
                 "Required downward slope of the merit, as a fraction of the gap penalty",
                 {.least = 0, .most = 1, .below = true})
          .more("Used by MultipleShooting. The merit is cost + penalty * sum |gap|_1. D is the "
                "slope of the merit along the direction. The penalty is raised until D <= "
                "-merit_fraction * penalty * sum |gap|_1")
          .field("rounding", &S::rounding,
                 "Relative rounding error of a sum of costs",
                 {.least = 0})
          .more("Every comparison of the line search is relaxed by rounding * |cost|");
  return all;
}

const Description& description_of(const LimitOptions* /*of*/) {
  using S = LimitOptions;
  static const Description all =
      Describe<S>("solver", "LimitOptions",
                  "Options for constraints. Each iteration solves a linear-quadratic problem with"
                  " an augmented Lagrangian (J. Nocedal, S. Wright, \"Numerical Optimization\", "
                  "2006, section 17.3). The inner minimization uses semismooth Newton steps (L. "
                  "Qi, J. Sun, \"A nonsmooth version of Newton's method\", 1993).")
          .field("weight", &S::weight,
                 "Penalty weight of the augmented Lagrangian, relative to the curvature of the "
                 "cost",
                 {.least = 0, .open = true})
          .more("The weight multiplies the square of (violation / scale of the row). A larger "
                "weight needs fewer updates of the multipliers, but increases rounding errors")
          .field("max_factorizations", &S::max_factorizations,
                 "Largest number of Riccati factorizations per iteration",
                 {.least = 1})
          .more("Factorizations of the interior-point method do not count")
          .field("max_sweeps", &S::max_sweeps,
                 "Largest number of Riccati sweeps per iteration that reuse a factorization",
                 {.least = 0})
          .field("interior_after", &S::interior_after,
                 "Number of factorizations in an iteration before an interior-point method starts",
                 {.least = 0})
          .more("The interior-point method finds the active set. It starts only if at least 20 "
                "factorizations of max_factorizations are left. It uses at most 80 "
                "factorizations, and usually only 10 to 20 of them. With 0, it starts immediately"
                " if there are no multipliers for a warm start")
          .field("l1_weight", &S::l1_weight,
                 "L1 penalty weight of hard rows, in units of (curvature of the cost) / (scale of"
                 " the row)",
                 {.least = 0, .open = true})
          .more("If rows remain violated at this weight, their squared violations are penalized "
                "instead, at first with this weight")
          .field("max_l1_weight", &S::max_l1_weight,
                 "Largest penalty weight of hard rows",
                 {.least = 0})
          .more("The weight is raised until all limits are met, or until the solver finds that "
                "this is impossible. With a value below `l1_weight`, the weight is never raised")
          .field("tolerance", &S::tolerance,
                 "Constraint tolerance, relative to the scale of each row",
                 {.least = 0, .open = true})
          .more("A limit is met if violation <= tolerance * scale of its row")
          .field("curvature", &S::curvature,
                 "Whether steps use the curvature of constraints (friction cones, distances with "
                 "an upper limit)")
          .more("Without this curvature, problems with constraints more curved than the cost take"
                " many more iterations. The solution is the same");
  return all;
}

const Description& description_of(const DdpProgress* /*of*/) {
  using S = DdpProgress;
  static const Description all =
      Describe<S>("solver", "DdpProgress",
                  "Progress of a solve after one iteration, passed to the callback.")
          .field("iteration", &S::iteration,
                 "Number of the iteration, from 1")
          .field("cost", &S::cost)
          .field("expected_improvement", &S::expected_improvement,
                 "Cost decrease |d1 + d2 / 2| that the quadratic model predicts for the full step")
          .field("largest_gap", &S::largest_gap)
          .field("step_length", &S::step_length,
                 "Accepted step length; 0: no length was accepted")
          .field("regularization", &S::regularization)
          .field("penalty", &S::penalty,
                 "Penalty weight of gaps in the merit (MultipleShooting only)")
          .field("feasible", &S::feasible)
          .field("violation", &S::violation,
                 "Largest violation of a hard row, divided by the scale of the row")
          .field("factorizations", &S::factorizations,
                 "Riccati factorizations in this iteration")
          .field("seconds", &S::seconds,
                 "Time since the solve began [{s}]");
  return all;
}

const Description& description_of(const DdpOptions* /*of*/) {
  using S = DdpOptions;
  static const Description all =
      Describe<S>("solver", "DdpOptions",
                  "Options of a DdpSolver. The description of each tolerance states the "
                  "inequality that uses the tolerance.")
          .field("update", &S::update)
          .field("max_iterations", &S::max_iterations,
                 "Largest number of iterations of a solve",
                 {.least = 0})
          .field("time_budget", &S::time_budget,
                 "Time limit of a solve [{s}]",
                 {.least = 0, .infinite = true})
          .more("The clock is read between phases and between trials. The guess is always "
                "evaluated. The result is the best iterate so far")
          .field("threads", &S::threads,
                 "Number of threads, the calling thread included",
                 {.least = 1, .most = 1024})
          .field("pin_threads", &S::pin_threads,
                 "Pin the solver's threads to cores (Linux only)")
          .more("The available cores are those of the thread that creates the solver or sets its "
                "options. Thread i runs on the i-th available core. The thread that calls solve()"
                " is not pinned")
          .field("share_knots", &S::share_knots,
                 "Let threads share the work within one knot of the Riccati recursion")
          .more("Used only if knots are large, such as the knots of a humanoid. Sharing is faster"
                " on cores with a common cache, and slower on others. Results are identical bit "
                "for bit")
          .field("segments", &S::segments,
                 "Number of segments of the horizon that the Riccati recursion processes in "
                 "parallel",
                 {.least = 1, .most = 1024})
          .more("Useful for long horizons and several cores; docs/performance.md, \"Threads\", "
                "says when segments are faster. Segments take up to three times the operations of"
                " a single sweep. The best number is usually threads + 1. With 1 or 2 segments, "
                "or with bounds on controls, a single sweep runs from the end to the start. The "
                "number of segments must be less than the number of knots. Gains and values equal"
                " the results of a single sweep up to rounding. For a given number of segments, "
                "results are identical bit for bit for any number of threads")
          .field("stop_tolerance", &S::stop_tolerance,
                 "Convergence tolerance of the expected improvement, in units of cost",
                 {.least = 0})
          .more("The condition is expected improvement < stop_tolerance, with a feasible "
                "trajectory")
          .field("gap_tolerance", &S::gap_tolerance,
                 "Largest gap between the knots of a feasible trajectory",
                 {.least = 0})
          .more("The condition is |entry| <= gap_tolerance for all entries of all gaps")
          .field("line_search", &S::line_search)
          .field("limits", &S::limits)
          .field("regularization", &S::regularization)
          .field("callback", &S::callback,
                 "Function called after each iteration; the result False stops the solve, None "
                 "and True continue")
          .more("Exceptions of the function reach the caller of solve()");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)

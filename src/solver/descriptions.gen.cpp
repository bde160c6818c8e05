// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "solver/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Words& words_of(StopReason /*of*/) {
  static const Words all{
      "solver",
      "StopReason",
      "Why a solve ended.",
      {{"converged", "feasible, limits kept, and the expected improvement is below stop_tolerance, or what the"
        " tolerance of limits is worth"},
       {"max_iterations", "max_iterations were made"},
       {"time_budget", "time_budget was spent"},
       {"not_evaluated", "a knot of the iterate cannot be evaluated: see status, knot, term"},
       {"not_positive_definite", "Quu of a knot, with the largest regularisation"},
       {"infeasible", "no trajectory near keeps all limits; this one breaks them least: see conflict"},
       {"no_step", "no step length was acceptable, with the largest regularisation"},
       {"callback", "the callback asked for it"}}};
  return all;
}

const Description& description_of(const PhaseTimes* /*of*/) {
  using S = PhaseTimes;
  static const Description all =
      Describe<S>("solver", "PhaseTimes",
                  "Seconds of a solve by phase.")
          .field("expand", &S::expand,
                 "values and derivatives")
          .field("backward", &S::backward,
                 "Riccati recursion")
          .field("trial", &S::trial,
                 "rollouts and evaluations of the line search")
          .field("total", &S::total);
  return all;
}

const Description& description_of(const RowPlace* /*of*/) {
  using S = RowPlace;
  static const Description all =
      Describe<S>("solver", "RowPlace",
                  "A row with limits at a knot.")
          .result()
          .field("knot", &S::knot)
          .field("row", &S::row,
                 "of those of the knot");
  return all;
}

const Description& description_of(const StartRow* /*of*/) {
  using S = StartRow;
  static const Description all =
      Describe<S>("solver", "StartRow",
                  "A hard row of the first knot that the initial state alone puts outside its "
                  "limits.")
          .result()
          .field("row", &S::row,
                 "of those of the first knot")
          .field("value", &S::value,
                 "in the row's unit")
          .field("lower", &S::lower,
                 "infinite where there is none")
          .field("upper", &S::upper,
                 "likewise");
  return all;
}

const Description& description_of(const DdpSummary* /*of*/) {
  using S = DdpSummary;
  static const Description all =
      Describe<S>("solver", "DdpSummary",
                  "Why a solve ended and what it reached.")
          .field("reason", &S::reason)
          .field("iterations", &S::iterations,
                 "line searches made")
          .field("cost", &S::cost,
                 "of the trajectory that is returned")
          .field("feasible", &S::feasible,
                 "No gap is above gap_tolerance, and every hard row is within its limits.")
          .field("expected_improvement", &S::expected_improvement,
                 "the last one computed")
          .field("regularization", &S::regularization,
                 "the last one used")
          .field("largest_gap", &S::largest_gap,
                 "of the trajectory that is returned")
          .field("gap_knot", &S::gap_knot,
                 "where: the state that the gap leads to, 0 for the initial one")
          .field("gap_entry", &S::gap_entry,
                 "entry of dx")
          .field("outside", &S::outside,
                 "largest violation of a hard row, in its scale, of the trajectory that is "
                 "returned")
          .field("outside_knot", &S::outside_knot,
                 "where; -1: every row is within its limits")
          .field("outside_row", &S::outside_row)
          .field("limits_open", &S::limits_open,
                 "what the last iteration's steps left of limits, in their scale")
          .field("pushing", &S::pushing,
                 "rows that push")
          .field("given_way", &S::given_way,
                 "hard rows that push with all that their price allows, since they cannot be kept")
          .field("conflict", &S::conflict,
                 "Infeasible: rows outside their limits, worst first")
          .field("stopping", &S::stopping,
                 "Infeasible: rows that push against those in conflict, from the hardest down.")
          .field("start_outside", &S::start_outside,
                 "whatever the reason")
          .field("status", &S::status,
                 "NotEvaluated, NotPositiveDefinite, and NoStep where the last trial could not be"
                 " evaluated: where and what.")
          .field("knot", &S::knot)
          .field("term", &S::term,
                 "cost term that is not finite, -1: none, a row or the dynamics")
          .field("row", &S::row,
                 "row of a constraint that is not finite, -1: none")
          .field("in_derivatives", &S::in_derivatives,
                 "NotEvaluated: values are finite, derivatives are not")
          .field("control", &S::control,
                 "NotPositiveDefinite: the first one whose pivot is not positive")
          .field("options", &S::options,
                 "those it was solved with, without callback")
          .field("seconds", &S::seconds)
          .field("log", &S::log,
                 "an entry per iteration");
  return all;
}

const Description& description_of(const CostReport* /*of*/) {
  using S = CostReport;
  static const Description all =
      Describe<S>("solver", "CostReport",
                  "Where a cost comes from.")
          .result()
          .field("total", &S::total)
          .field("terms", &S::terms,
                 "summed over knots, in order of appearance")
          .field("knots", &S::knots,
                 "N + 1")
          .field("rows", &S::rows,
                 "over all knots, in order of appearance")
          .field("limits", &S::limits,
                 "along the horizon, knot by knot in the order of its rows");
  return all;
}

const Description& description_of(const CostReport::Entry* /*of*/) {
  using S = CostReport::Entry;
  static const Description all =
      Describe<S>("solver", "CostEntry",
                  "What one cost term adds.")
          .result()
          .field("name", &S::name)
          .field("cost", &S::cost);
  return all;
}

const Description& description_of(const CostReport::Knot* /*of*/) {
  using S = CostReport::Knot;
  static const Description all =
      Describe<S>("solver", "CostKnot",
                  "What one knot costs.")
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
                  "A row of a constraint, where it is furthest outside its limits, or nearest to "
                  "one of them from inside.")
          .result()
          .field("name", &S::name,
                 "as Problem.row_names has it")
          .field("knot", &S::knot,
                 "as Problem.knot_name has it")
          .field("value", &S::value)
          .field("lower", &S::lower)
          .field("upper", &S::upper)
          .field("outside", &S::outside,
                 "how far; negative: the least distance to a limit from inside")
          .field("scale", &S::scale,
                 "in its unit: what counts as much of it")
          .field("multiplier", &S::multiplier,
                 "of the horizon the largest: see multipliers()")
          .field("pushed", &S::pushed,
                 "the knot that has that")
          .field("active", &S::active,
                 "knots at which a limit pushes");
  return all;
}

const Description& description_of(const CostReport::ActiveLimit* /*of*/) {
  using S = CostReport::ActiveLimit;
  static const Description all =
      Describe<S>("solver", "ActiveLimit",
                  "A row at a knot where its limit pushes or is broken.")
          .result()
          .field("knot", &S::knot,
                 "0 to N")
          .field("row", &S::row,
                 "as Problem.row_names has it")
          .field("value", &S::value,
                 "in the row's unit")
          .field("lower", &S::lower,
                 "infinite where there is none")
          .field("upper", &S::upper,
                 "likewise")
          .field("multiplier", &S::multiplier,
                 "cost per unit of the row; see multipliers()");
  return all;
}

const Description& description_of(const NamedMatrix* /*of*/) {
  using S = NamedMatrix;
  static const Description all =
      Describe<S>("solver", "NamedMatrix",
                  "A result with the names of what its rows and columns stand for.")
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
      "How a direction becomes the next iterate.",
      {{"rollout", "The controls' policy is rolled out through the dynamics; gaps shrink by 1 - alpha. After"
        " a step of length 1 the trajectory is feasible and stays so (feasibility-driven DDP)."},
       {"multiple_shooting", "States and controls move along the solution of the linear-quadratic problem; every knot "
        "is evaluated on its own, in packs and threads. Gaps vanish with convergence."}}};
  return all;
}

const Description& description_of(const Regularization* /*of*/) {
  using S = Regularization;
  static const Description all =
      Describe<S>("solver", "Regularization",
                  "Levenberg term, added to the diagonal of Quu, in cost per squared unit of "
                  "control.")
          .field("initial", &S::initial,
                 "",
                 {.least = 0})
          .field("smallest", &S::smallest,
                 "Below this there is none: a decrease ends at 0, an increase from 0 begins here.",
                 {.least = 0, .open = true})
          .field("largest", &S::largest,
                 "needed more than this: the solver gives up")
          .field("factor", &S::factor,
                 "of an increase, and 1 / factor of a decrease",
                 {.least = 1, .open = true})
          .field("decrease_above", &S::decrease_above,
                 "decreases after a step of length > this",
                 {.infinite = true})
          .field("increase_at_or_below", &S::increase_at_or_below,
                 "increases after a step of length <= this",
                 {.infinite = true});
  return all;
}

const Description& description_of(const LineSearch* /*of*/) {
  using S = LineSearch;
  static const Description all =
      Describe<S>("solver", "LineSearch",
                  "The step lengths 1, 1/2, 1/4, ... and what a trial must reach to be taken.")
          .field("halvings", &S::halvings,
                 "the smallest length is 2^-halvings",
                 {.least = 0, .most = 60})
          .field("sufficient_decrease", &S::sufficient_decrease,
                 "Rollout, expected improvement dV(alpha) >= 0: taken if the iterate is not "
                 "feasible, since closing its gaps may cost, or cost - trial > "
                 "sufficient_decrease * dV(alpha).",
                 {.least = 0, .most = 1, .below = true})
          .field("allowed_increase", &S::allowed_increase,
                 "Rollout, dV(alpha) < 0 (closing gaps costs): taken if cost - trial > "
                 "allowed_increase * dV(alpha).",
                 {.least = 0})
          .field("merit_decrease", &S::merit_decrease,
                 "MultipleShooting, merit = cost + penalty * sum |gap|_1 with slope D: taken if "
                 "trial <= merit + merit_decrease * alpha * D.",
                 {.least = 0, .most = 1, .below = true})
          .field("merit_share", &S::merit_share,
                 "MultipleShooting: the penalty makes D <= -merit_share * penalty * sum |gap|_1.",
                 {.least = 0, .most = 1, .below = true})
          .field("rounding", &S::rounding,
                 "Rounding of a sum of costs: every comparison above is relaxed by rounding * "
                 "|cost|.",
                 {.least = 0});
  return all;
}

const Description& description_of(const LimitOptions* /*of*/) {
  using S = LimitOptions;
  static const Description all =
      Describe<S>("solver", "LimitOptions",
                  "How rows are kept within their limits: semismooth Newton steps on an augmented"
                  " Lagrangian of the linear-quadratic problem of each iteration.")
          .field("weight", &S::weight,
                 "Weight of a violation, in units of the cost's curvature over a row's scale. "
                 "More needs fewer changes of multipliers and costs digits.",
                 {.least = 0, .open = true})
          .field("max_factors", &S::max_factors,
                 "recursions per iteration, without an interior-point method's",
                 {.least = 1})
          .field("max_sweeps", &S::max_sweeps,
                 "with kept factors, per iteration",
                 {.least = 0})
          .field("interior_after", &S::interior_after,
                 "Recursions of an iteration after which an interior-point method finds out which"
                 " rows push, where max_factors leaves 20. It takes at most 80 recursions, most "
                 "often 10 to 20. 0: at once, where nothing is known of multipliers.",
                 {.least = 0})
          .field("price", &S::price,
                 "Of a violation of a hard row, and weight of its square where that price leaves "
                 "some broken, in units of the cost's curvature over its scale.",
                 {.least = 0, .open = true})
          .field("largest_price", &S::largest_price,
                 "What it is raised to until limits are kept, or it is known that they cannot be;"
                 " below price: it stays.",
                 {.least = 0})
          .field("tolerance", &S::tolerance,
                 "Kept if every violation <= tolerance * scale of its row.",
                 {.least = 0, .open = true})
          .field("bends", &S::bends,
                 "Steps know how rows bend (distances with an upper limit, friction cones). "
                 "Without it limits that bend more than the cost take many more iterations, to "
                 "the same solution.");
  return all;
}

const Description& description_of(const DdpProgress* /*of*/) {
  using S = DdpProgress;
  static const Description all =
      Describe<S>("solver", "DdpProgress",
                  "What a callback sees after each iteration.")
          .field("iteration", &S::iteration,
                 "from 1")
          .field("cost", &S::cost)
          .field("expected_improvement", &S::expected_improvement,
                 "|d1 + d2 / 2|: what the quadratic model said before the step that the whole "
                 "step would save.")
          .field("largest_gap", &S::largest_gap)
          .field("step_length", &S::step_length,
                 "0: no length was acceptable")
          .field("regularization", &S::regularization)
          .field("penalty", &S::penalty,
                 "of gaps in the merit; MultipleShooting only")
          .field("feasible", &S::feasible)
          .field("outside", &S::outside,
                 "largest violation of a hard row, in its scale")
          .field("factors", &S::factors,
                 "recursions of this iteration")
          .field("seconds", &S::seconds,
                 "since the solve began");
  return all;
}

const Description& description_of(const DdpOptions* /*of*/) {
  using S = DdpOptions;
  static const Description all =
      Describe<S>("solver", "DdpOptions",
                  "How a DdpSolver works, each tolerance beside the inequality it enters.")
          .field("update", &S::update)
          .field("max_iterations", &S::max_iterations,
                 "",
                 {.least = 0})
          .field("time_budget", &S::time_budget,
                 "Seconds, looked at between phases and between trials; the best iterate so far "
                 "is kept. At least the guess is evaluated.",
                 {.least = 0, .infinite = true})
          .field("threads", &S::threads,
                 "",
                 {.least = 1, .most = 1024})
          .field("pin_threads", &S::pin_threads,
                 "Thread i of the solver stays on the i-th core that the thread which makes it "
                 "(or gives it options) may run on. The thread that solves is left as it is. "
                 "Linux alone.")
          .field("share_knots", &S::share_knots,
                 "Threads work together on each knot of the recursion where knots are large (a "
                 "humanoid's), which is faster on cores that share a cache and slower on others. "
                 "Results have the same bits.")
          .field("segments", &S::segments,
                 "The recursion works on so many parts of the horizon at the same time, for long "
                 "horizons and several cores: docs/performance.md, \"Threads\", says when that is"
                 " faster. It makes up to three times the operations, and threads + 1 segments "
                 "suit `threads` best; 1 and 2 mean one sweep from the end to the begin, as do "
                 "bounds on controls. Fewer than the problem has knots. Gains and values are "
                 "those of the whole horizon, but for rounding; their bits depend on this number "
                 "and not on that of threads.",
                 {.least = 1, .most = 1024})
          .field("stop_tolerance", &S::stop_tolerance,
                 "Converged if feasible and expected improvement < stop_tolerance (in units of "
                 "cost).",
                 {.least = 0})
          .field("gap_tolerance", &S::gap_tolerance,
                 "Feasible if every |entry of a gap| <= gap_tolerance.",
                 {.least = 0})
          .field("line_search", &S::line_search)
          .field("limits", &S::limits)
          .field("regularization", &S::regularization)
          .field("callback", &S::callback,
                 "called after each iteration; False stops the solve, None and True go on, and "
                 "what it raises reaches the caller of solve()");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)

#include "solver/descriptions.hpp"

namespace burnish {

const Words& words_of(StepUpdate /*of*/) {
  static const Words all{
      "solver",
      "StepUpdate",
      "How a direction becomes the next iterate.",
      {{"rollout",
        "The controls' policy is rolled out through the dynamics; gaps shrink by 1 - alpha. After "
        "a step of length 1 the trajectory is feasible and stays so (feasibility-driven DDP)."},
       {"multiple_shooting",
        "States and controls move along the solution of the linear-quadratic problem; every knot "
        "is evaluated on its own, in packs and threads. Gaps vanish with convergence."}}};
  return all;
}

const Words& words_of(StopReason /*of*/) {
  static const Words all{
      "solver",
      "StopReason",
      "Why a solve ended.",
      {{"converged",
        "feasible, limits kept, and the expected improvement is below stop_tolerance, or what the "
        "tolerance of limits is worth"},
       {"max_iterations", "max_iterations were made"},
       {"time_budget", "time_budget was spent"},
       {"not_evaluated", "a knot of the iterate cannot be evaluated: see status, knot, term"},
       {"not_positive_definite", "Quu of a knot, with the largest regularisation"},
       {"infeasible",
        "no trajectory near keeps all limits; this one breaks them least: see conflict"},
       {"no_step", "no step length was acceptable, with the largest regularisation"},
       {"callback", "the callback asked for it"}}};
  return all;
}

const Description& description_of(const Regularization* /*of*/) {
  using R = Regularization;
  static const Description all =
      Describe<R>(
          "solver", "Regularization",
          "Levenberg term, added to the diagonal of Quu, in cost per squared unit of control.")
          .field("initial", &R::initial, "", range::not_negative)
          .field("smallest", &R::smallest,
                 "Below this there is none: a decrease ends at 0, an increase from 0 begins here.",
                 range::positive)
          .field("largest", &R::largest, "needed more than this: the solver gives up")
          .field("factor", &R::factor, "of an increase, and 1 / factor of a decrease",
                 range::above(1))
          .field("decrease_above", &R::decrease_above, "decreases after a step of length > this",
                 range::any_or_infinite)
          .field("increase_at_or_below", &R::increase_at_or_below,
                 "increases after a step of length <= this", range::any_or_infinite);
  return all;
}

const Description& description_of(const LineSearch* /*of*/) {
  using L = LineSearch;
  static const Description all =
      Describe<L>("solver", "LineSearch",
                  "The step lengths 1, 1/2, 1/4, ... and what a trial must reach to be taken.")
          .field("halvings", &L::halvings, "the smallest length is 2^-halvings", range::from(0, 60))
          .field(
              "sufficient_decrease", &L::sufficient_decrease,
              "Rollout, expected improvement dV(alpha) >= 0: taken if the iterate is not feasible, "
              "since closing its gaps may cost, or cost - trial > sufficient_decrease * dV(alpha).",
              range::fraction)
          .field("allowed_increase", &L::allowed_increase,
                 "Rollout, dV(alpha) < 0 (closing gaps costs): taken if cost - trial > "
                 "allowed_increase * dV(alpha).",
                 range::not_negative)
          .field("merit_decrease", &L::merit_decrease,
                 "MultipleShooting, merit = cost + penalty * sum |gap|_1 with slope D: taken if "
                 "trial <= merit + merit_decrease * alpha * D.",
                 range::fraction)
          .field("merit_share", &L::merit_share,
                 "MultipleShooting: the penalty makes D <= -merit_share * penalty * sum |gap|_1.",
                 range::fraction)
          .field("rounding", &L::rounding,
                 "Rounding of a sum of costs: every comparison above is relaxed by rounding * "
                 "|cost|.",
                 range::not_negative);
  return all;
}

const Description& description_of(const LimitOptions* /*of*/) {
  using L = LimitOptions;
  static const Description all =
      Describe<L>("solver", "LimitOptions",
                  "How rows are kept within their limits: semismooth Newton steps on an augmented "
                  "Lagrangian of the linear-quadratic problem of each iteration.")
          .field("weight", &L::weight,
                 "Weight of a violation, in units of the cost's curvature over a row's scale. More "
                 "needs fewer changes of multipliers and costs digits.",
                 range::positive)
          .field("max_factors", &L::max_factors,
                 "recursions per iteration, without an interior-point method's", range::from(1))
          .field("max_sweeps", &L::max_sweeps, "with kept factors, per iteration", range::from(0))
          .field("interior_after", &L::interior_after,
                 "Recursions of an iteration after which an interior-point method finds out which "
                 "rows push, where max_factors leaves 20. It takes at most 80 recursions, most "
                 "often 10 to 20. 0: at once, where nothing is known of multipliers.",
                 range::from(0))
          .field("price", &L::price,
                 "Of a violation of a hard row, and weight of its square where that price leaves "
                 "some broken, in units of the cost's curvature over its scale.",
                 range::positive)
          .field("largest_price", &L::largest_price,
                 "What it is raised to until limits are kept, or it is known that they cannot be; "
                 "below price: it stays.",
                 range::not_negative)
          .field("tolerance", &L::tolerance,
                 "Kept if every violation <= tolerance * scale of its row.", range::positive)
          .field(
              "bends", &L::bends,
              "Steps know how rows bend (distances with an upper limit, friction cones). Without "
              "it limits that bend more than the cost take many more iterations, to the same "
              "solution.");
  return all;
}

const Description& description_of(const DdpProgress* /*of*/) {
  using D = DdpProgress;
  static const Description all =
      Describe<D>("solver", "DdpProgress", "What a callback sees after each iteration.")
          .field("iteration", &D::iteration, "from 1")
          .field("cost", &D::cost)
          .field("expected_improvement", &D::expected_improvement,
                 "|d1 + d2 / 2|: what the quadratic model said before the step that the whole step "
                 "would save.")
          .field("largest_gap", &D::largest_gap)
          .field("step_length", &D::step_length, "0: no length was acceptable")
          .field("regularization", &D::regularization)
          .field("penalty", &D::penalty, "of gaps in the merit; MultipleShooting only")
          .field("feasible", &D::feasible)
          .field("outside", &D::outside, "largest violation of a hard row, in its scale")
          .field("factors", &D::factors, "recursions of this iteration")
          .field("seconds", &D::seconds, "since the solve began");
  return all;
}

const Description& description_of(const DdpOptions* /*of*/) {
  using D = DdpOptions;
  static const Description all =
      Describe<D>("solver", "DdpOptions",
                  "How a DdpSolver works, each tolerance beside the inequality it enters.")
          .field("update", &D::update)
          .field("max_iterations", &D::max_iterations, "", range::from(0))
          .field("time_budget", &D::time_budget,
                 "Seconds, looked at between phases and between trials; the best iterate so far is "
                 "kept. At least the guess is evaluated.",
                 range::not_negative_or_infinite)
          .field("threads", &D::threads, "", range::from(1, 1024))
          .field(
              "pin_threads", &D::pin_threads,
              "Thread i of the solver stays on the i-th core that the thread which makes it (or "
              "gives it options) may run on. The thread that solves is left as it is. Linux alone.")
          .field("share_knots", &D::share_knots,
                 "Threads work together on each knot of the recursion where knots are large (a "
                 "humanoid's), which is faster on cores that share a cache and slower on others. "
                 "Results have the same bits.")
          .field("segments", &D::segments,
                 "The recursion works on so many parts of the horizon at the same time, for long "
                 "horizons and several cores: docs/performance.md, \"Threads\", says when that is "
                 "faster. It makes up to three times the operations, and threads + 1 segments suit "
                 "`threads` best; 1 and 2 mean one sweep from the end to the begin, as do bounds "
                 "on controls. Fewer than the problem has knots. Gains and values are those of the "
                 "whole horizon, but for rounding; their bits depend on this number and not on "
                 "that of threads.",
                 range::from(1, 1024))
          .field(
              "stop_tolerance", &D::stop_tolerance,
              "Converged if feasible and expected improvement < stop_tolerance (in units of cost).",
              range::not_negative)
          .field("gap_tolerance", &D::gap_tolerance,
                 "Feasible if every |entry of a gap| <= gap_tolerance.", range::not_negative)
          .field("line_search", &D::line_search)
          .field("limits", &D::limits)
          .field("regularization", &D::regularization)
          .field("callback", &D::callback,
                 "called after each iteration; False stops the solve, None and True go on, and "
                 "what it raises reaches the caller of solve()");
  return all;
}

const Description& description_of(const PhaseTimes* /*of*/) {
  using P = PhaseTimes;
  static const Description all =
      Describe<P>("solver", "PhaseTimes", "Seconds of a solve by phase.")
          .field("expand", &P::expand, "values and derivatives")
          .field("backward", &P::backward, "Riccati recursion")
          .field("trial", &P::trial, "rollouts and evaluations of the line search")
          .field("total", &P::total);
  return all;
}

const Description& description_of(const RowPlace* /*of*/) {
  using R = RowPlace;
  static const Description all = Describe<R>("solver", "RowPlace", "A row with limits at a knot.")
                                     .field("knot", &R::knot)
                                     .field("row", &R::row, "of those of the knot")
                                     .result();
  return all;
}

const Description& description_of(const StartRow* /*of*/) {
  using S = StartRow;
  static const Description all =
      Describe<S>("solver", "StartRow",
                  "A hard row of the first knot that the initial state alone puts outside its "
                  "limits.")
          .field("row", &S::row, "of those of the first knot")
          .field("value", &S::value, "in the row's unit")
          .field("lower", &S::lower, "infinite where there is none")
          .field("upper", &S::upper, "likewise")
          .result();
  return all;
}

const Description& description_of(const DdpSummary* /*of*/) {
  using D = DdpSummary;
  static const Description all =
      Describe<D>("solver", "DdpSummary", "Why a solve ended and what it reached.")
          .field("reason", &D::reason)
          .field("iterations", &D::iterations, "line searches made")
          .field("cost", &D::cost, "of the trajectory that is returned")
          .field("feasible", &D::feasible,
                 "No gap is above gap_tolerance, and every hard row is within its limits.")
          .field("expected_improvement", &D::expected_improvement, "the last one computed")
          .field("regularization", &D::regularization, "the last one used")
          .field("largest_gap", &D::largest_gap, "of the trajectory that is returned")
          .field("gap_knot", &D::gap_knot,
                 "where: the state that the gap leads to, 0 for the initial one")
          .field("gap_entry", &D::gap_entry, "entry of dx")
          .field("outside", &D::outside,
                 "largest violation of a hard row, in its scale, of the trajectory that is "
                 "returned")
          .field("outside_knot", &D::outside_knot, "where; -1: every row is within its limits")
          .field("outside_row", &D::outside_row)
          .field("limits_open", &D::limits_open,
                 "what the last iteration's steps left of limits, in their scale")
          .field("pushing", &D::pushing, "rows that push")
          .field("given_way", &D::given_way,
                 "hard rows that push with all that their price allows, since they cannot be kept")
          .field("conflict", &D::conflict, "Infeasible: rows outside their limits, worst first")
          .field("stopping", &D::stopping,
                 "Infeasible: rows that push against those in conflict, from the hardest down.")
          .field("start_outside", &D::start_outside, "whatever the reason")
          .field("status", &D::status,
                 "NotEvaluated, NotPositiveDefinite, and NoStep where the last trial could not be "
                 "evaluated: where and what.")
          .field("knot", &D::knot)
          .field("term", &D::term, "cost term that is not finite, -1: none, a row or the dynamics")
          .field("row", &D::row, "row of a constraint that is not finite, -1: none")
          .field("in_derivatives", &D::in_derivatives,
                 "NotEvaluated: values are finite, derivatives are not")
          .field("control", &D::control,
                 "NotPositiveDefinite: the first one whose pivot is not positive")
          .field("options", &D::options, "those it was solved with, without callback")
          .field("seconds", &D::seconds)
          .field("log", &D::log, "an entry per iteration");
  return all;
}

const Description& description_of(const CostReport::Entry* /*of*/) {
  using E = CostReport::Entry;
  static const Description all = Describe<E>("solver", "CostEntry", "What one cost term adds.")
                                     .result()
                                     .field("name", &E::name)
                                     .field("cost", &E::cost);
  return all;
}

const Description& description_of(const CostReport::Knot* /*of*/) {
  using K = CostReport::Knot;
  static const Description all = Describe<K>("solver", "CostKnot", "What one knot costs.")
                                     .result()
                                     .field("name", &K::name)
                                     .field("cost", &K::cost)
                                     .field("terms", &K::terms);
  return all;
}

const Description& description_of(const CostReport::Row* /*of*/) {
  using R = CostReport::Row;
  static const Description all =
      Describe<R>("solver", "LimitedRow",
                  "A row of a constraint, where it is furthest outside its limits, or nearest to "
                  "one of them from inside.")
          .result()
          .field("name", &R::name, "as Problem.row_names has it")
          .field("knot", &R::knot, "as Problem.knot_name has it")
          .field("value", &R::value)
          .field("lower", &R::lower)
          .field("upper", &R::upper)
          .field("outside", &R::outside,
                 "how far; negative: the least distance to a limit from inside")
          .field("scale", &R::scale, "in its unit: what counts as much of it")
          .field("multiplier", &R::multiplier, "of the horizon the largest: see multipliers()")
          .field("pushed", &R::pushed, "the knot that has that")
          .field("active", &R::active, "knots at which a limit pushes");
  return all;
}

const Description& description_of(const CostReport::ActiveLimit* /*of*/) {
  using L = CostReport::ActiveLimit;
  static const Description all =
      Describe<L>("solver", "ActiveLimit", "A row at a knot where its limit pushes or is broken.")
          .result()
          .field("knot", &L::knot, "0 to N")
          .field("row", &L::row, "as Problem.row_names has it")
          .field("value", &L::value, "in the row's unit")
          .field("lower", &L::lower, "infinite where there is none")
          .field("upper", &L::upper, "likewise")
          .field("multiplier", &L::multiplier, "cost per unit of the row; see multipliers()");
  return all;
}

const Description& description_of(const CostReport* /*of*/) {
  using C = CostReport;
  static const Description all =
      Describe<C>("solver", "CostReport", "Where a cost comes from.")
          .result()
          .field("total", &C::total)
          .field("terms", &C::terms, "summed over knots, in order of appearance")
          .field("knots", &C::knots, "N + 1")
          .field("rows", &C::rows, "over all knots, in order of appearance")
          .field("limits", &C::limits, "along the horizon, knot by knot in the order of its rows");
  return all;
}

const Description& description_of(const NamedMatrix* /*of*/) {
  using N = NamedMatrix;
  static const Description all =
      Describe<N>("solver", "NamedMatrix",
                  "A result with the names of what its rows and columns stand for.")
          .result()
          .field("rows", &N::rows)
          .field("columns", &N::columns)
          .field("values", &N::values);
  return all;
}

}  // namespace burnish

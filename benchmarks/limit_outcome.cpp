#include "limit_outcome.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace burnish::bench {
namespace {

/// Largest violation, as a fraction of the scale, and largest gap of a converged trajectory; chosen
/// by hand.
constexpr double max_violation = 1e-6, max_gap = 1e-6;
/// Limits count as active if the optimum without limits violates them by more than this fraction of
/// their scale; chosen by hand.
constexpr double min_active_violation = 1e-3;
/// Largest number of problems that are drawn to find one that can be solved without limits; chosen
/// by hand.
constexpr int max_attempts = 100;

Error unsolved() {
  return Error("none of " + std::to_string(max_attempts) +
               " problems without limits could be solved");
}

/// Draws a problem with limits that a given trajectory satisfies. Repeats the draw if the problem
/// cannot be solved without limits.
LimitProblem draw_feasible(Draws& draws, const RobotChoice& choice, Sort& sort) {
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    LimitProblem problem = draw_problem(draws, choice);
    problem.limits = draw_kinds(draws, problem);
    const bool near = draws.chance(0.5);
    LimitProblem other = problem;
    if (!near) other.aims = other_aims(draws, problem.aims);
    const auto trajectory = solve_without_limits(other);
    if (!trajectory) continue;
    const bool touching = draws.chance(0.3);
    const auto limits = near && touching ? limits_around(draws, problem, *trajectory, 1e-9, 1e-5)
                                         : limits_around(draws, problem, *trajectory, 1e-3, 0.3);
    if (!limits) continue;
    problem.limits = *limits;
    Case limited(problem, {});
    const double outside = violation(limited.problem(), *trajectory);
    if (outside > 1e-9)
      throw Error("a trajectory violates the limits drawn around it by " + std::to_string(outside));
    const auto optimum = near ? trajectory : solve_without_limits(problem);
    if (!optimum) continue;
    sort =
        violation(limited.problem(), *optimum) > min_active_violation ? Sort::Beyond : Sort::Near;
    return problem;
  }
  throw unsolved();
}

/// Draws a problem with limits that are independent of any solution. Repeats the draw if the
/// problem cannot be solved without limits.
LimitProblem draw_freely(Draws& draws, const RobotChoice& choice) {
  for (int attempt = 0; attempt < max_attempts; ++attempt) {
    LimitProblem problem = draw_problem(draws, choice);
    problem.limits = free_limits(draws, problem, draw_kinds(draws, problem));
    if (solve_without_limits(problem)) return problem;
  }
  throw unsolved();
}

DdpOptions options_of(const OutcomeOptions& wanted) {
  DdpOptions options{.max_iterations = wanted.iterations};
  if (wanted.shooting) options.update = StepUpdate::MultipleShooting;
  if (wanted.verbose)
    options.callback = [](const DdpProgress& p) {
      std::printf(
          "%4d cost %12.7g expected %9.2g gap %8.1g step %7.3g regular. %7.1g violation %8.2g "
          "recursions %d\n",
          p.iteration, p.cost, p.expected_improvement, p.largest_gap, p.step_length,
          p.regularization, p.violation, p.factorizations);
      return true;
    };
  return options;
}

Sort sort_of(const Judgement& judgement) {
  if (judgement.verdict == Judgement::Verdict::Feasible) return Sort::Feasible;
  return judgement.verdict == Judgement::Verdict::Infeasible ? Sort::Infeasible : Sort::Unclear;
}

}  // namespace

std::string_view name_of(Sort sort) {
  constexpr std::string_view names[] = {"limits near the optimum", "optimum outside the limits",
                                        "free draw, feasible", "free draw, infeasible",
                                        "free draw, unclear"};
  return names[static_cast<std::size_t>(sort)];
}

bool Outcome::is_wrongly_converged() const {
  return converged() && (violation > max_violation || gap > max_gap);
}

std::string Outcome::text_of_problem() const {
  std::string kinds;
  for (const Limit& limit : problem.limits)
    kinds += " " + std::string(name_of(limit.kind)) + (limit.late ? " (late)" : "");
  char knots[64];
  std::snprintf(knots, sizeof knots, "%d knots of %.2g ms", problem.knots, 1e3 * problem.step);
  return "seed " + std::to_string(seed) + ": " + problem.robot +
         (problem.holds ? ", holds, " : ", slides, ") + knots + ", " + std::string(name_of(sort)) +
         ";" + kinds;
}

Outcome run_seed(std::uint64_t seed, const OutcomeOptions& options) {
  Draws draws(seed);
  Outcome o{.seed = seed};
  const bool by_construction = seed % 2 == 0;
  o.problem = by_construction ? draw_feasible(draws, options.choice, o.sort)
                              : draw_freely(draws, options.choice);
  if (!options.write.empty())
    std::ofstream(options.write) << text_of(
        o.problem, {.description = "seed " + std::to_string(seed) + " of burnish_limit_problems"});
  Case limited(o.problem, {});
  if (!by_construction) {
    o.judgement = judge(o.problem, limited.problem());
    o.sort = sort_of(o.judgement);
    if (options.verbose)
      std::printf("judged: %s with violations of %.3g, then %.3g%s\n",
                  std::string(name_of(o.sort)).c_str(), o.judgement.before, o.judgement.violation,
                  o.judgement.settled ? "" : ", not converged");
  }
  if (options.verbose) std::printf("%s\n", o.text_of_problem().c_str());
  DdpSolver solver(limited.problem(), options_of(options));
  solver.set_guess(limited.guess().xs, limited.guess().us);
  const DdpSummary& summary = solver.solve();
  o.reason = summary.reason;
  o.iterations = summary.iterations;
  o.seconds = summary.seconds.total;
  o.text = solver.text();
  for (const DdpProgress& p : summary.log) {
    o.cut_short += p.factorizations >= solver.options().limits.max_factorizations;
    o.zero_steps += p.step_length == 0.0;
    o.regularization = std::max(o.regularization, p.regularization);
  }
  const TrajectoryGuess end{solver.xs(), solver.us()};
  o.violation = violation(limited.problem(), end);
  o.gap = largest_gap(limited.problem(), end);
  // A trajectory within all limits proves that they are feasible.
  if (!by_construction && o.converged() && o.violation <= max_violation && o.gap <= max_gap)
    o.sort = Sort::Feasible;
  if (options.verbose) std::printf("%s\n%s\n", solver.cost_report().text().c_str(), o.text.c_str());
  return o;
}

}  // namespace burnish::bench

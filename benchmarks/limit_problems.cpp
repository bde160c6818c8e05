// Solves of random problems with limits. Half of the problems are feasible by construction; the
// feasibility of the others is judged by solves with quadratic penalties. Prints outcomes by kind,
// and the seeds that failed. docs/constraints.md has the results.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "limit_outcome.hpp"

namespace burnish::bench {
namespace {

/// Aims for the solver on problems that are feasible by construction, as fractions of the problems.
constexpr double min_converged = 0.99, max_called_infeasible = 0.01;

struct Arguments {
  std::uint64_t seed = 1;
  int count = 500;
  bool require = false;
  OutcomeOptions options;
};

int iterations_at(std::vector<int> of, double quantile) {
  if (of.empty()) return 0;
  std::sort(of.begin(), of.end());
  return of[static_cast<std::size_t>(quantile * static_cast<double>(of.size() - 1) + 0.5)];
}

using Choose = std::function<bool(const Outcome&)>;

struct Counts {
  int problems = 0, converged = 0, infeasible = 0, unended = 0, wrong = 0;
};

Counts count(const std::vector<Outcome>& outcomes, const Choose& choose) {
  Counts c;
  for (const Outcome& o : outcomes) {
    if (!choose(o)) continue;
    ++c.problems;
    c.converged += o.converged();
    c.infeasible += o.called_infeasible();
    c.unended += !o.ended();
    c.wrong += o.is_wrong();
  }
  return c;
}

void print_row(const std::string& name, const std::vector<Outcome>& outcomes,
               const Choose& choose) {
  const Counts c = count(outcomes, choose);
  if (c.problems == 0) return;
  std::vector<int> iterations;
  for (const Outcome& o : outcomes)
    if (choose(o) && o.converged()) iterations.push_back(o.iterations);
  fmt::print("{:<28} {:>8} {:>9} {:>10} {:>9} {:>5}   {:>3} {:>3} {:>3} {:>3}\n", name, c.problems,
             c.converged, c.infeasible, c.unended, c.wrong, iterations_at(iterations, 0.5),
             iterations_at(iterations, 0.9), iterations_at(iterations, 0.99),
             iterations_at(iterations, 1.0));
}

void print_header(const char* title) {
  fmt::print("\n{:<28} {:>8} {:>9} {:>10} {:>9} {:>5}   {}\n", title, "problems", "converged",
             "infeasible", "not ended", "wrong", "iterations: p50 p90 p99 max");
}

void print_tables(const std::vector<Outcome>& outcomes) {
  print_header("all");
  print_row("feasible by construction", outcomes,
            [](const Outcome& o) { return o.by_construction(); });
  for (const Sort sort : sorts)
    print_row("  " + std::string(name_of(sort)), outcomes,
              [sort](const Outcome& o) { return o.sort == sort; });
  print_header("feasible by construction");
  for (const LimitKind kind : limit_kinds)
    for (const bool late : {false, true})
      print_row(std::string(name_of(kind)) + (late ? ", late" : ""), outcomes,
                [kind, late](const Outcome& o) {
                  return o.by_construction() &&
                         std::any_of(o.problem.limits.begin(), o.problem.limits.end(),
                                     [&](const Limit& limit) {
                                       return limit.kind == kind && limit.late == late;
                                     });
                });
  std::vector<std::string> robots;
  for (const Outcome& o : outcomes)
    if (std::find(robots.begin(), robots.end(), o.problem.robot) == robots.end())
      robots.push_back(o.problem.robot);
  for (const std::string& robot : robots)
    for (const bool holds : {false, true})
      print_row(robot + (holds ? ", holds" : ", slides"), outcomes, [&](const Outcome& o) {
        return o.by_construction() && o.problem.robot == robot && o.problem.holds == holds;
      });
}

void print_failures(const std::vector<Outcome>& outcomes) {
  fmt::print("\n");
  for (const Outcome& o : outcomes) {
    if (!o.failed()) continue;
    fmt::print("{}\n  {} iterations: {}\n", o.text_of_problem(), o.iterations, o.text);
    fmt::print("  {} linear-quadratic problems cut short, {} zero steps, regularization {:.1g}\n",
               o.cut_short, o.zero_steps, o.regularization);
    if (!o.by_construction())
      fmt::print("  violations with penalties: {:.2g}, then {:.2g} of the scale\n",
                 o.judgement.before, o.judgement.violation);
    if (o.is_wrongly_converged())
      fmt::print("  converged with a violation of {:.2g} and a gap of {:.2g}\n", o.violation,
                 o.gap);
  }
}

bool meets_aims(const std::vector<Outcome>& outcomes) {
  const Counts c = count(outcomes, [](const Outcome& o) { return o.by_construction(); });
  const bool wrongly = std::any_of(outcomes.begin(), outcomes.end(),
                                   [](const Outcome& o) { return o.is_wrongly_converged(); });
  return c.converged >= min_converged * c.problems &&
         c.infeasible <= max_called_infeasible * c.problems && !wrongly;
}

int run(const Arguments& arguments) {
  std::vector<Outcome> outcomes;
  double seconds = 0.0;
  for (int i = 0; i < arguments.count; ++i) {
    outcomes.push_back(run_seed(arguments.seed + static_cast<std::uint64_t>(i), arguments.options));
    seconds += outcomes.back().seconds;
  }
  fmt::print("{} problems from seed {}, at most {} iterations, {}: {:.1f} s of solves\n",
             arguments.count, arguments.seed, arguments.options.iterations,
             arguments.options.shooting ? "multiple shooting" : "rollout", seconds);
  print_tables(outcomes);
  print_failures(outcomes);
  return arguments.require && !meets_aims(outcomes) ? 1 : 0;
}

int main_of(int count, char** words) {
  Arguments arguments;
  CLI::App app("Solve random optimal control problems with limits, and count the outcomes");
  app.add_option("--seed", arguments.seed,
                 "Seed of the first problem; even seeds are feasible by construction");
  app.add_option("--count", arguments.count, "Number of problems, with consecutive seeds");
  app.add_option("--iterations", arguments.options.iterations,
                 "Largest number of iterations of a solve");
  app.add_option("--robot", arguments.options.choice.robot,
                 "Robot or URDF file, in place of the bundled arms");
  app.add_option("--frame", arguments.options.choice.frame, "Frame of the tool");
  app.add_option("--write", arguments.options.write, "Write the last problem to this file");
  app.add_flag("--shooting", arguments.options.shooting,
               "Use multiple shooting in place of rollouts");
  app.add_flag("--verbose", arguments.options.verbose, "Print every iteration");
  app.add_flag("--require", arguments.require, "Fail if the aims are missed");
  CLI11_PARSE(app, count, words);
  return run(arguments);
}

}  // namespace
}  // namespace burnish::bench

int main(int count, char** words) {
  try {
    return burnish::bench::main_of(count, words);
  } catch (const std::exception& error) {
    fmt::print(stderr, "limit_problems: {}\n", error.what());
    return 2;
  }
}

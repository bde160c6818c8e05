// burnish solve: solves an optimal control problem from a file; writes its trajectory, gains and
// plots.
#include <fmt/format.h>

#include "burnish/ocp/check.hpp"
#include "burnish/ocp/step_check.hpp"
#include "command.hpp"
#include "model/mass_check.hpp"
#include "record/json_text.hpp"
#include "record/page_files.hpp"
#include "record/run_folder.hpp"
#include "record/solution.hpp"
#include "robot_arguments.hpp"
#include "signals.hpp"
#include "task_argument.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

struct SolveArguments {
  std::string file, out;
  int iterations = -1, threads = -1;
  double tolerance = -1.0;
  bool check = false, pin = false, quiet = false, json = false, force = false, strict = false;
  bool no_page = false;
};

DdpOptions options_of(const ProblemFile& problem, const SolveArguments& arguments) {
  DdpOptions options = problem.solver;
  if (arguments.iterations >= 0) options.max_iterations = arguments.iterations;
  if (arguments.threads >= 0) options.threads = arguments.threads;
  if (arguments.pin) options.pin_threads = true;
  // Passes NaN on, so that options.check() rejects it.
  if (!(arguments.tolerance < 0.0)) options.stop_tolerance = arguments.tolerance;
  options.check();
  const bool talks = !arguments.quiet && !arguments.json;
  options.callback = [talks](const DdpProgress& p) {
    if (talks) {
      fmt::print("{:5d}  {:14.8g}  {:11.3g}  {:11.3g}  {:7.4g}  {:9.1g}  {:9.3f}\n", p.iteration,
                 p.cost, p.expected_improvement, p.largest_gap, p.step_length, p.regularization,
                 p.seconds);
      std::fflush(stdout);
    }
    return !StopRequest::asked();
  };
  return options;
}

/// Checks the derivatives of the problem and prints the result. Returns false if the derivatives
/// are wrong.
bool check(Problem& problem, const SolveArguments& arguments) {
  const ProblemReport report = check_problem(problem);
  if (!arguments.json) fmt::print("{}\n", report.text());
  return report.pass;
}

void print_start(const Problem& problem, const std::string& file) {
  fmt::print("{}: {}, {} knots, {} states, {} controls\n", file, problem.model().name,
             problem.knots(), problem.state().ndx, problem.max_controls());
  fmt::print("{:>5}  {:>14}  {:>11}  {:>11}  {:>7}  {:>9}  {:>9}\n", "iter", "cost", "expected",
             "largest gap", "step", "regular.", "time [s]");
}

int solve(const SolveArguments& arguments) {
  refuse_file_of_another_command(arguments.file, "solve");
  const ProblemFile file = read_problem_file(arguments.file);
  print_warnings(file.robot, arguments.strict);
  named_by(arguments.file, [&] { require_simulable(file.robot.model); });
  Problem problem = named_by(arguments.file, [&] { return Problem(file.spec); });
  for (const std::string& complaint : complaints(problem))
    fmt::print(stderr, "burnish: {}: note: {}\n", arguments.file, complaint);
  if (arguments.check && !check(problem, arguments)) return exit_failed;
  DdpSolver solver =
      named_by(arguments.file, [&] { return DdpSolver(problem, options_of(file, arguments)); });
  const TrajectoryGuess guess =
      named_by(arguments.file, [&] { return make_guess(problem, file.guess); });
  solver.set_guess(guess.xs, guess.us);
  const StopRequest stop("the solver ends after this iteration and its results are written");
  RunFolder folder({.out = arguments.out,
                    .name = fs::path(arguments.file).stem().string() + "_solution",
                    .force = arguments.force});
  folder.claim({"trajectory.csv", "gains.json", "summary.json", "limits.csv", "states.svg",
                "torques.svg", "forces.svg", "path.svg", "limits.svg", "cost.svg", "run.json",
                "run.html"});

  const bool talks = !arguments.quiet && !arguments.json;
  if (talks) print_start(problem, arguments.file);
  const DdpSummary& summary = solver.solve();
  const StepReport steps = check_steps(problem, solver.xs(), solver.us());
  const auto report = summary_json(arguments.file, problem, solver, steps);
  std::vector<std::string> names;
  PageWriter pages(!arguments.no_page, false);
  std::string unwritten;  // reason why files are missing
  try {
    names = write_solution(problem, solver, report, folder.path());
    for (std::string& name : pages.write(folder.path(), [&] {
           return solution_page({arguments.file, file}, problem, solver, steps);
         }))
      names.push_back(std::move(name));
    folder.finish();
  } catch (const Error& error) {
    unwritten = error.what();
  }
  if (arguments.json) {
    fmt::print("{}\n", json_text(report));
  } else {
    if (talks) fmt::print("\n{}\n", solver.cost_report().text());
    fmt::print("{}\n", solver.text());
    if (talks) fmt::print("{}\n", steps.text());
    if (talks && unwritten.empty())
      fmt::print("in {}: {}\n", folder.path().string(), fmt::join(names, ", "));
  }
  if (const std::string missing = pages.missing_meshes(); !missing.empty())
    fmt::print(stderr, "burnish: {}: note: {}\n", arguments.file, missing);
  if (steps.coarse)
    fmt::print(stderr, "burnish: {}: warning: {}\n", arguments.file, steps.warning());
  if (!unwritten.empty()) throw Error(unwritten);
  return summary.reason == StopReason::Converged ? exit_ok : exit_failed;
}

}  // namespace

void add_solve(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("solve", "Solve an optimal control problem from a YAML file");
  const auto arguments = std::make_shared<SolveArguments>();
  command->add_option("PROBLEM", arguments->file, "Problem file")->type_name("")->required();
  command
      ->add_option("--out", arguments->out,
                   "Output folder [a new one: PROBLEM_solution, PROBLEM_solution_2, ...]")
      ->type_name("DIR");
  command->add_flag("--force", arguments->force, "Replace the results in the output folder");
  command
      ->add_option("--iterations", arguments->iterations,
                   "Largest number of iterations [from the file, or 100]")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--threads", arguments->threads, "Number of threads [from the file, or 1]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->add_flag("--pin-threads", arguments->pin, "Pin each thread except the first to a core");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Expected improvement of the cost below which the solver has converged [1e-9]")
      ->type_name("T")
      ->check(CLI::PositiveNumber);
  command->add_flag("--check", arguments->check,
                    "Check the derivatives of the problem first, and stop if the check fails");
  command->add_flag("--no-page", arguments->no_page, "Omit run.json and run.html");
  command->add_flag("--quiet", arguments->quiet, "Print only the final result");
  command->add_flag("--json", arguments->json, "Print summary.json and nothing else");
  add_strict(*command, arguments->strict);
  command->footer(
      "Examples:\n"
      "  burnish solve examples/problems/reaching.yaml\n"
      "  burnish solve examples/problems/polishing.yaml --out /tmp/polishing --threads 4\n"
      "\n"
      "Writes run.html (a page for any browser, with a replay of the planned motion),\n"
      "trajectory.csv, gains.json, summary.json, limits.csv (if the problem has constraints) and\n"
      "plots. Ctrl-C (or SIGTERM, or SIGHUP) stops after the iteration and writes the results so\n"
      "far.\n"
      "docs/optimal_control.md describes problem files.\n"
      "Exit codes: 0 converged; 1 not converged; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = solve(*arguments); });
}

}  // namespace burnish::app

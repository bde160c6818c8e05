// burnish solve: an optimal control problem from a file to a trajectory, gains and plots.
#include <fmt/format.h>

#include <csignal>
#include <fstream>

#include "burnish/ocp/check.hpp"
#include "command.hpp"
#include "json_text.hpp"
#include "robot_arguments.hpp"
#include "solution.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

struct SolveArguments {
  std::string file, out;
  int iterations = -1, threads = -1;
  double tolerance = -1.0;
  bool check = false, pin = false, quiet = false, json = false, strict = false;
};

volatile std::sig_atomic_t solve_must_end = 0;

/// The first Ctrl-C ends the solve after its iteration, the second one the program.
extern "C" void stop_after_iteration(int signal) {
  solve_must_end = 1;
  std::signal(signal, SIG_DFL);
}

DdpOptions options_of(const ProblemFile& problem, const SolveArguments& arguments) {
  DdpOptions options = problem.solver;
  if (arguments.iterations >= 0) options.max_iterations = arguments.iterations;
  if (arguments.threads >= 0) options.threads = arguments.threads;
  if (arguments.pin) options.pin_threads = true;
  if (arguments.tolerance >= 0.0) options.stop_tolerance = arguments.tolerance;
  options.check();
  const bool talks = !arguments.quiet && !arguments.json;
  options.callback = [talks](const DdpProgress& p) {
    if (talks) {
      fmt::print("{:5d}  {:14.8g}  {:11.3g}  {:11.3g}  {:7.4g}  {:9.1g}  {:9.3f}\n", p.iteration,
                 p.cost, p.expected_improvement, p.largest_gap, p.step_length, p.regularization,
                 p.seconds);
      std::fflush(stdout);
    }
    return solve_must_end == 0;
  };
  return options;
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text << '\n';
  stream.close();
  if (!stream) throw Error(fmt::format("cannot write '{}'", file.string()));
}

fs::path make_folder(const SolveArguments& arguments) {
  fs::path folder = arguments.out;
  if (folder.empty()) folder = fs::path(arguments.file).stem().string() + "_solution";
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw Error(fmt::format("cannot make the folder '{}'{}", folder.string(),
                            error ? ": " + error.message() : ""));
  return folder;
}

/// False where the derivatives are wrong.
bool check(Problem& problem, const SolveArguments& arguments) {
  const ProblemReport report = check_problem(problem);
  if (!arguments.json) fmt::print("{}\n", report.text());
  return report.pass;
}

int solve(const SolveArguments& arguments) {
  const ProblemFile file = read_problem_file(arguments.file);
  print_warnings(file.robot, arguments.strict);
  Problem problem(file.spec);
  for (const std::string& complaint : complaints(problem))
    fmt::print(stderr, "burnish: {}: note: {}\n", arguments.file, complaint);
  if (arguments.check && !check(problem, arguments)) return exit_failed;
  DdpSolver solver(problem, options_of(file, arguments));
  const TrajectoryGuess guess = make_guess(problem, file.guess);
  solver.set_guess(guess.xs, guess.us);
  const fs::path folder = make_folder(arguments);

  const bool talks = !arguments.quiet && !arguments.json;
  if (talks) {
    fmt::print("{}: {}, {} knots, {} states, {} controls\n", arguments.file, problem.model().name,
               problem.knots(), problem.state().ndx, problem.max_controls());
    fmt::print("{:>5}  {:>14}  {:>11}  {:>11}  {:>7}  {:>9}  {:>9}\n", "iter", "cost", "expected",
               "largest gap", "step", "regular.", "time [s]");
  }
  solve_must_end = 0;
  const auto before = std::signal(SIGINT, stop_after_iteration);
  const DdpSummary& summary = solver.solve();
  std::signal(SIGINT, before);

  const Trace trace = solution_trace(problem, solver.xs(), solver.us());
  trace.write_csv(folder / "trajectory.csv");
  const auto report = summary_json(arguments.file, problem, solver);
  write_text(folder / "summary.json", json_text(report));
  write_text(folder / "gains.json", json_text(gains_json(problem, solver)));
  const std::vector<std::string> plots = write_plots(problem, trace, summary, folder);
  if (arguments.json) {
    fmt::print("{}\n", json_text(report));
  } else {
    if (talks) fmt::print("\n{}\n", solver.cost_report().text());
    fmt::print("{}\n", solver.text());
    if (talks)
      fmt::print("in {}: trajectory.csv, gains.json, summary.json, {}\n", folder.string(),
                 fmt::join(plots, ", "));
  }
  return summary.reason == StopReason::Converged ? exit_ok : exit_failed;
}

}  // namespace

void add_solve(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("solve", "An optimal control problem from a YAML file");
  const auto arguments = std::make_shared<SolveArguments>();
  command->add_option("PROBLEM", arguments->file, "Problem file")->type_name("")->required();
  command->add_option("--out", arguments->out, "Folder for what is written [PROBLEM_solution]")
      ->type_name("DIR");
  command
      ->add_option("--iterations", arguments->iterations, "Iterations at most [the file's, or 100]")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--threads", arguments->threads, "Threads [the file's, or 1]")
      ->type_name("N")
      ->check(CLI::PositiveNumber);
  command->add_flag("--pin-threads", arguments->pin, "Keep each thread but the first on a core");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Converged when the expected improvement of the cost is below [1e-9]")
      ->type_name("T")
      ->check(CLI::PositiveNumber);
  command->add_flag("--check", arguments->check,
                    "Check the problem's derivatives first; if they fail, do not solve");
  command->add_flag("--quiet", arguments->quiet, "Say nothing but how it ended");
  command->add_flag("--json", arguments->json, "Print summary.json and nothing else");
  add_strict(*command, arguments->strict);
  command->footer(
      "Examples:\n"
      "  burnish solve examples/problems/reaching.yaml\n"
      "  burnish solve examples/problems/polishing.yaml --out /tmp/polishing --threads 4\n"
      "\n"
      "Writes trajectory.csv, gains.json, summary.json and plots. Ctrl-C stops after the\n"
      "iteration and writes what there is. docs/optimal_control.md describes problem files.\n"
      "Exit codes: 0 converged; 1 not converged; 2 bad input.");
  command->callback([arguments, &exit_code] { exit_code = solve(*arguments); });
}

}  // namespace burnish::app

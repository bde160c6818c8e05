// burnish experiment: one of the polishing experiments, from its runs to its tables and figures.
#include <fmt/format.h>
#include <unistd.h>

#include <set>

#include "command.hpp"
#include "polishing/record/experiment_files.hpp"
#include "progress_bar.hpp"
#include "record/run_folder.hpp"
#include "robot_arguments.hpp"
#include "shell_word.hpp"
#include "signals.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using polishing::PlantKind;

struct ExperimentArguments {
  std::string name, plant, out;
  std::vector<std::string> surfaces, robots, tools, overrides;
  int seeds = 0, first_seed = 0, threads = 0;
  bool quick = false, quiet = false, force = false, strict = false;
};

/// What repeats the results: options that change them and no others.
std::string command_of(const ExperimentArguments& a) {
  std::string command = "burnish experiment " + a.name;
  if (a.seeds > 0) command += fmt::format(" --seeds {}", a.seeds);
  if (a.first_seed > 0) command += fmt::format(" --first-seed {}", a.first_seed);
  for (const std::string& surface : a.surfaces) command += " --surface " + shell_word(surface);
  for (const std::string& robot : a.robots) command += " --robot " + shell_word(robot);
  for (const std::string& tool : a.tools) command += " --tool " + shell_word(tool);
  if (!a.plant.empty()) command += " --plant " + a.plant;
  if (a.quick) command += " --quick";
  for (const std::string& word : a.overrides) command += " --set " + shell_word(word);
  return command;
}

polishing::ExperimentSpec spec_of(const ExperimentArguments& a) {
  polishing::ExperimentSpec spec;
  if (!a.plant.empty()) spec.plant = a.plant == "ideal" ? PlantKind::Ideal : PlantKind::Mujoco;
  spec.seeds = a.seeds;
  spec.first_seed = a.first_seed;
  spec.threads = a.threads;
  spec.quick = a.quick;
  spec.surfaces = a.surfaces;
  spec.robots = a.robots;
  spec.tools = a.tools;
  spec.overrides = a.overrides;
  spec.stopped = [] { return StopRequest::asked(); };
  if (!a.quiet && isatty(STDERR_FILENO) != 0)
    spec.progress = [name = a.name](double share, const std::string& what) {
      show_progress(name, share, what);
    };
  return spec;
}

int perform(const ExperimentArguments& arguments) {
  const polishing::Experiment& experiment = polishing::experiment_named(arguments.name);
  const polishing::ExperimentSpec spec = spec_of(arguments);
  if (experiment.name != "robots" && !(arguments.robots.empty() && arguments.tools.empty()))
    throw Error("--robot and --tool are for the experiment 'robots'; for " +
                fmt::format("'{}'", experiment.name) + " say --set robot=NAME");
  if (arguments.tools.size() > arguments.robots.size())
    throw Error(
        fmt::format("{} times --tool and {} times --robot; wanted no more tools than robots",
                    arguments.tools.size(), arguments.robots.size()));
  // Bad words are refused, and the folder is there, before minutes of computing.
  std::set<std::string> robots;
  for (const std::string& surface :
       arguments.surfaces.empty() ? std::vector<std::string>{"table"} : arguments.surfaces)
    robots.insert(check_experiment_task(spec, surface).robot);
  for (const std::string& robot : robots) print_warnings_of(robot, arguments.strict);
  const StopRequest stop("the runs end, and what there is of them is written");
  RunFolder folder(
      {.out = arguments.out, .name = "experiment_" + arguments.name, .force = arguments.force});
  folder.claim({"results.md", "results.json", "results.csv"});
  const polishing::ExperimentReport report = experiment.perform(spec);
  if (spec.progress) fmt::print(stderr, "\r\033[K");

  const std::string command = command_of(arguments);
  std::vector<std::string> names = experiment_files(report);
  std::string unwritten;  // why files are missing
  try {
    folder.claim(names);
    write_experiment(report, experiment.name, command, folder.path());
    folder.finish();
  } catch (const Error& error) {
    unwritten = error.what();
  }
  if (!arguments.quiet) {
    fmt::print("{}", experiment_text(report, command));
    if (unwritten.empty())
      fmt::print("\nin {}: {}\n", folder.path().string(), fmt::join(names, ", "));
  }
  if (!unwritten.empty()) throw Error(unwritten);
  return report.failures.empty() && !report.interrupted ? exit_ok : exit_failed;
}

std::string list_of_experiments() {
  std::string text;
  for (const polishing::Experiment& experiment : polishing::experiments())
    text += fmt::format("  {:<12}  {}\n", experiment.name, experiment.summary);
  return text;
}

void add_options(CLI::App& command, ExperimentArguments& a) {
  command.add_option("EXPERIMENT", a.name, "Its name, see below")->required()->type_name("");
  command
      .add_option(
          "--seeds", a.seeds,
          "Number of seeds: of runs that differ in what is drawn [paper 5, robots 5, seeds 200]")
      ->type_name("N")
      ->check(CLI::Range(1, polishing::max_seeds));
  command.add_option("--first-seed", a.first_seed, "First of the seeds [0]")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option("--surface", a.surfaces,
                  "Other surfaces than the experiment's own; again for more (not: orientation)")
      ->type_name("SURFACE")
      ->allow_extra_args(false);
  command
      .add_option("--robot", a.robots,
                  "Robot or URDF file in place of those that come along; again for more (robots)")
      ->type_name("ROBOT")
      ->allow_extra_args(false);
  command
      .add_option("--tool", a.tools,
                  "Frame that holds the tool, for each --robot in its turn [tool] (robots)")
      ->type_name("FRAME")
      ->allow_extra_args(false);
  command
      .add_option("--plant", a.plant,
                  polishing::has_mujoco() ? "Simulator: mujoco or ideal [mujoco]"
                                          : "Simulator: ideal; this build has no MuJoCo [ideal]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mujoco", "ideal"}));
  command
      .add_option("--set", a.overrides,
                  "Any key of a task file, such as force=20; repeatable. What the experiment "
                  "sweeps stays its own")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--threads", a.threads,
                  "Runs at once, which changes no result; tick has one [one per core]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quick", a.quick, "Few and short runs, to see whether it works");
  command
      .add_option("--out", a.out,
                  "Folder for what is written [a new one: experiment_NAME, experiment_NAME_2, ...]")
      ->type_name("DIR");
  command.add_flag("--force", a.force, "Replace the run that the folder of --out holds");
  command.add_flag("--quiet", a.quiet, "Print nothing");
  add_strict(command, a.strict);
}

}  // namespace

void add_experiment(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("experiment", "Many polishing runs and what they show, in one command");
  const auto arguments = std::make_shared<ExperimentArguments>();
  add_options(*command, *arguments);
  command->footer(
      "Experiments:\n" + list_of_experiments() +
      "\n"
      "Examples:\n"
      "  burnish experiment paper --seeds 3\n"
      "  burnish experiment orientation --set path.radius=0.04\n"
      "  burnish experiment seeds --first-seed 17 --seeds 1\n"
      "\n"
      "Each leaves results.md (its tables), results.json (all), results.csv (a row per run) and\n"
      "figures. Ctrl-C (or SIGTERM, or SIGHUP) ends the runs and writes what there is.\n"
      "docs/experiments.md shows and explains the results.\n"
      "Exit codes: 0 all runs polished, as the task's `verdict` asks for, whether aims were met or "
      "not;\n"
      "1 some did not; 2 bad input.");
  command->callback([arguments, &exit_code] { exit_code = perform(*arguments); });
}

}  // namespace burnish::app

// burnish sweep and burnish tune: campaigns that a file defines, executed by the Python package
// burnish.
#include <fmt/format.h>

#include "command.hpp"
#include "hand_over.hpp"

namespace burnish::app {
namespace {

struct SweepArguments {
  std::string file, scheduler, out, shard;
  int threads = 0;
  double time_limit = 0.0;
  bool resume = false, mixed = false, quiet = false;

  std::vector<std::string> words(const std::string& command) const {
    std::vector<std::string> words{command, file};
    const auto add = [&](const char* option, const std::string& value) {
      words.insert(words.end(), {option, value});
    };
    if (!scheduler.empty()) add("--scheduler", scheduler);
    if (!out.empty()) add("--out", out);
    if (threads > 0) add("--threads", std::to_string(threads));
    if (time_limit > 0.0) add("--time-limit", fmt::format("{}", time_limit));
    if (!shard.empty()) add("--shard", shard);
    if (resume) words.emplace_back("--resume");
    if (mixed) words.emplace_back("--mixed");
    if (quiet) words.emplace_back("--quiet");
    return words;
  }
};

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary,
                      const std::string& file, const std::shared_ptr<SweepArguments>& arguments) {
  CLI::App* command = app.add_subcommand(name, summary);
  SweepArguments& a = *arguments;
  command->add_option("FILE", a.file, file)->type_name("")->required();
  command
      ->add_option("--scheduler", a.scheduler,
                   "Distribute the runs to the workers of a Dask scheduler, such as "
                   "tcp://192.168.0.5:8786")
      ->type_name("ADDRESS");
  command
      ->add_option("--threads", a.threads,
                   "Number of parallel runs [one per core]; results do not depend on this number")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--time-limit", a.time_limit,
                   "Largest computing time of a run, in seconds [10 times the time of earlier "
                   "runs, at least 120]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command->add_option("--out", a.out, "Output folder [a new one, named after the file]")
      ->type_name("DIR");
  command->add_flag(
      "--resume", a.resume,
      "Continue an earlier campaign in the output folder, and skip the runs that it contains");
  command->add_flag("--mixed", a.mixed,
                    "Accept runs made on other kinds of processors, which differ in the last "
                    "digits; the results state it");
  command->add_flag("--quiet", a.quiet, "Print nothing");
  command->callback([arguments, name] {
    hand_over_to_python(arguments->words(name),
                        arguments->scheduler.empty() ? "numpy" : "distributed");
  });
  return command;
}

}  // namespace

void add_sweep(CLI::App& app) {
  const auto arguments = std::make_shared<SweepArguments>();
  CLI::App* command =
      add_command(app, "sweep", "Run a task over values of its keys, as a file defines",
                  "Campaign file: a task, and values or ranges of its keys", arguments);
  command
      ->add_option("--shard", arguments->shard,
                   "Make only part I of N of the runs, such as 2/4, or several parts, such as "
                   "1,3/4; burnish merge then makes the table")
      ->type_name("I/N");
  command->footer(
      "Examples:\n"
      "  burnish sweep friction.yaml\n"
      "  burnish sweep friction.yaml --shard 2/4 --out part_2 --resume\n"
      "\n"
      "Writes results.csv (a row per run), results.h5, results.html with distributions, and the\n"
      "worst runs with the commands that repeat them. Needs the Python package burnish.\n"
      "docs/campaigns.md describes the file.\n"
      "Exit codes: 0 all runs succeeded; 1 some did not; 2 invalid input.");
}

void add_tune(CLI::App& app) {
  add_command(app, "tune", "Optimise keys of a task on some seeds, and test them on others",
              "Tuning file: a task, keys with ranges, and the objective",
              std::make_shared<SweepArguments>())
      ->footer(
          "Examples:\n"
          "  burnish tune tuning.yaml\n"
          "\n"
          "Writes tuned.yaml (the task), tuning.md (changed keys, improvement with 95 % "
          "intervals,\n"
          "sensitivity to keys) and evaluations.csv. Needs the Python package burnish, with NLopt\n"
          "or SciPy. docs/campaigns.md describes the file.\n"
          "Exit codes: 0 significantly better on the test seeds; 1 not significantly better;\n"
          "2 invalid input.");
}

}  // namespace burnish::app

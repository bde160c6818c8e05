// burnish sweep and burnish tune: campaigns that a file states, which Python does.
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
                   "Leave the runs to the workers of a Dask scheduler, such as "
                   "tcp://192.168.0.5:8786")
      ->type_name("ADDRESS");
  command
      ->add_option("--threads", a.threads, "Runs at once, which changes no result [one per core]")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--time-limit", a.time_limit,
                   "Computing time that a run may take, s [20 times the median of those before]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--out", a.out, "Folder for what is written [a new one, called after the file]")
      ->type_name("DIR");
  command->add_flag("--resume", a.resume,
                    "Go on with what the folder of --out holds: no run is made twice");
  command->add_flag(
      "--mixed", a.mixed,
      "Take runs too that kernels for other processors made, as the results then say");
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
      add_command(app, "sweep", "Runs of a task over values of its keys, as a file says",
                  "Campaign: a task, and what its keys take", arguments);
  command
      ->add_option("--shard", arguments->shard,
                   "Make every Nth run alone, from the Ith on, and no table: burnish merge does; "
                   "several: 1,3/4")
      ->type_name("I/N");
  command->footer(
      "Examples:\n"
      "  burnish sweep friction.yaml\n"
      "  burnish sweep friction.yaml --shard 2/4 --out part_2 --resume\n"
      "\n"
      "Leaves results.csv (a row per run), results.h5, results.html with distributions, and "
      "the\n"
      "worst runs with the commands that repeat them. It is done by the Python package "
      "burnish;\n"
      "docs/campaigns.md says what the file states.\n"
      "Exit codes: 0 all runs were done; 1 some were not; 2 bad input.");
}

void add_tune(CLI::App& app) {
  add_command(app, "tune", "Make a task better on some seeds, judged on others",
              "Tuning: a task, keys with ranges, and what to minimise",
              std::make_shared<SweepArguments>())
      ->footer(
          "Examples:\n"
          "  burnish tune tuning.yaml\n"
          "\n"
          "Leaves tuned.yaml (the task), tuning.md (what changed, what it bought with 95 % "
          "intervals,\n"
          "which keys matter) and evaluations.csv. It is done by the Python package burnish, with "
          "NLopt\n"
          "or SciPy; docs/campaigns.md says what the file states.\n"
          "Exit codes: 0 better on seeds that it was not tuned on; 1 not surely; 2 bad input.");
}

}  // namespace burnish::app

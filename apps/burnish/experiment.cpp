// burnish experiment: runs of a polishing experiment, with its tables and figures.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "campaign.hpp"
#include "command.hpp"
#include "hand_over.hpp"
#include "progress_bar.hpp"
#include "robot_arguments.hpp"
#include "signals.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using polishing::ExperimentSpec;

struct ExperimentArguments {
  Campaign campaign;
  std::string out, shard, scheduler;
  int threads = 0;
  double time_limit = 0.0;
  bool quiet = false, force = false, strict = false, resume = false, mixed = false, list = false;

  bool measures() const { return campaign.name == "tick"; }
};

polishing::Shard shard_of(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  std::vector<std::string> words = CLI::detail::split(text.substr(0, slash), ',');
  words.push_back(slash == std::string::npos ? "" : text.substr(slash + 1));
  std::vector<int> read;
  for (const std::string& word : words) {
    int number = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    read.push_back(error == std::errc() && at == end ? number : 0);
  }
  polishing::Shard shard{.numbers = {read.begin(), read.end() - 1}, .count = read.back()};
  std::sort(shard.numbers.begin(), shard.numbers.end());
  if (shard.numbers.empty() || shard.numbers.front() < 1 || shard.numbers.back() > shard.count)
    throw Error(
        fmt::format("--shard is '{}'; wanted I/N, part I of N parts, such as 2/4, or several "
                    "parts, such as 1,3/4",
                    text));
  return shard;
}

/// Throws Error for options that conflict with each other.
void check_options(const ExperimentArguments& a) {
  if (a.measures() && !(a.shard.empty() && a.scheduler.empty() && !a.resume && !a.list))
    throw Error(
        "the experiment 'tick' measures computing times in one process; wanted none of --shard, "
        "--scheduler, --resume and --list");
  if (a.campaign.name == "standing" && !a.scheduler.empty())
    throw Error(
        "some runs of the experiment 'standing' depend on earlier runs, which --scheduler does not "
        "support; wanted --shard in place of --scheduler, or neither option");
  if (a.resume && a.out.empty())
    throw Error("--resume needs a folder to continue in; wanted --out DIR");
  if (!a.scheduler.empty() && (!a.shard.empty() || a.list || a.threads > 0 || a.force))
    throw Error(
        "--scheduler distributes the runs to workers; wanted none of --shard, --list, --threads "
        "and --force");
  if (a.resume && a.force) throw Error("--resume and --force are both given; wanted one of them");
}

/// Throws Error if the folder of --out contains runs of another campaign. Campaigns that differ
/// only in their seeds count as one campaign.
void check_resumed(const ExperimentArguments& a) {
  const std::optional<CampaignFile> there = CampaignFile::read(a.out);
  if (!there) return;
  if (there->version != program_version())
    throw Error(
        fmt::format("'{}' holds runs of burnish {}, but this is burnish {}; wanted another folder",
                    a.out, there->version, program_version()));
  if (there->campaign.name == CampaignFile::sweep)
    throw Error(fmt::format("'{}' holds runs of burnish sweep; wanted another folder", a.out));
  Campaign same = there->campaign;
  same.seeds = a.campaign.seeds;
  same.first_seed = a.campaign.first_seed;
  if (!(same == a.campaign))
    throw Error(
        fmt::format("'{}' holds runs of `{}`; wanted these options (only --seeds and "
                    "--first-seed may differ), or another folder",
                    a.out, there->campaign.command()));
}

ExperimentSpec spec_of(const ExperimentArguments& a) {
  ExperimentSpec spec = a.campaign.spec();
  spec.threads = a.threads;
  spec.time_limit = a.time_limit;
  spec.mixed = a.mixed;
  spec.shard = shard_of(a.shard);
  spec.stopped = [] { return StopRequest::asked(); };
  if (!a.quiet && isatty(STDERR_FILENO) != 0)
    spec.progress = [name = a.campaign.name, left = std::make_shared<RemainingTime>()](
                        double done, const std::string& what) {
      show_progress(name, done, left->text(done) + what);
    };
  return spec;
}

std::vector<std::string> words_for_python(const ExperimentArguments& a) {
  std::vector<std::string> words{"experiment", "--scheduler", a.scheduler};
  if (!a.out.empty()) words.insert(words.end(), {"--out", a.out});
  if (a.time_limit > 0.0)
    words.insert(words.end(), {"--time-limit", fmt::format("{}", a.time_limit)});
  for (const auto& [wanted, flag] :
       {std::pair(a.resume, "--resume"), {a.mixed, "--mixed"}, {a.quiet, "--quiet"}})
    if (wanted) words.emplace_back(flag);
  words.emplace_back("--");
  const std::vector<std::string> campaign = a.campaign.command_words();
  words.insert(words.end(), campaign.begin() + 2, campaign.end());
  return words;
}

int list_runs(const ExperimentArguments& a, ExperimentSpec spec) {
  const polishing::RunStore store(a.campaign.name, program_version(), {fs::path()});
  spec.store = &store;
  spec.list = [](std::size_t index, const std::string& result, const std::string& run) {
    fmt::print("{}\t{}\t{}\n", index + 1, result, run);
  };
  polishing::experiment_named(a.campaign.name).perform(spec);
  return exit_ok;
}

/// Finishes the folder of a shard, prints the counts of the shard's runs, and returns the exit
/// code.
int finish_shard(const ExperimentArguments& a, const polishing::RunCounts& counts,
                 RunFolder& folder) {
  folder.finish();
  if (!a.quiet)
    fmt::print(
        "shard {} of `{}`: {} of {} runs, {} new and {} from before, {} not polished\nin "
        "{}: {}/\n",
        a.shard, a.campaign.command(), counts.found + counts.made, counts.wanted, counts.made,
        counts.found, counts.failed, folder.path().string(), results_folder);
  return counts.failed == 0 && counts.found + counts.made == counts.wanted ? exit_ok : exit_failed;
}

int perform(const ExperimentArguments& a) {
  // Checks the options and creates the folder first, before minutes of computing.
  check_options(a);
  ExperimentSpec spec = spec_of(a);
  check_campaign(a.campaign, a.strict);
  if (a.resume) check_resumed(a);
  if (a.list) return list_runs(a, spec);
  if (!a.scheduler.empty()) hand_over_to_python(words_for_python(a), "distributed");
  const StopRequest stop("the runs end and their results so far are written");
  std::string name = "experiment_" + a.campaign.name;
  if (!a.shard.empty())
    name += fmt::format("_{}_of_{}", fmt::join(spec.shard.numbers, "_"), spec.shard.count);
  RunFolder folder({.out = a.out, .name = name, .force = a.force, .resume = a.resume});
  const polishing::RunStore store(a.campaign.name, program_version(),
                                  {folder.path() / results_folder});
  polishing::RunCounts counts;
  spec.counts = &counts;
  if (a.shard.empty()) folder.claim({"results.md", "results.json", "results.csv"});
  if (!a.measures()) {
    spec.store = &store;
    folder.claim({CampaignFile::name, std::string(results_folder) + "/"});
    CampaignFile{a.campaign, program_version(), a.shard}.write(folder.path());
  }
  const polishing::ExperimentReport report =
      polishing::experiment_named(a.campaign.name).perform(spec);
  if (spec.progress) fmt::print(stderr, "\r\033[K");
  if (!a.shard.empty()) return finish_shard(a, counts, folder);
  return write_report(report, a.campaign, folder, a.quiet);
}

std::string list_of_experiments() {
  std::string text;
  for (const polishing::Experiment& experiment : polishing::experiments())
    text += fmt::format("  {:<12}  {}\n", experiment.name, experiment.summary);
  return text;
}

void add_robots(CLI::App& command, Campaign& a) {
  command
      .add_option("--robot", a.robots,
                  "Robot in place of the bundled robots: name, URDF or MJCF file; repeatable; for "
                  "the experiments robots and force_test")
      ->type_name("ROBOT")
      ->allow_extra_args(false);
  command
      .add_option("--tool", a.tools,
                  "Frame of the tool, one for each --robot in order [tool]; for the experiments "
                  "robots and force_test")
      ->type_name("FRAME")
      ->allow_extra_args(false);
  command
      .add_option("--folder", a.folder,
                  "Folder with checkouts of public repositories. Runs the arms and legged robots "
                  "listed in its robots.yaml or, without that file, in docs/public_robots.md; for "
                  "the experiment robots")
      ->type_name("DIR");
}

void add_words(CLI::App& command, Campaign& a) {
  command.add_option("EXPERIMENT", a.name, "Name of the experiment, see below")
      ->required()
      ->type_name("");
  command
      .add_option(
          "--seeds", a.seeds,
          "Number of seeds, each a run with other random disturbances [frames 2, robots with "
          "--folder 3, paper, robots, force_test and surfaces 5, tilt 10, standing 50, seeds 200]")
      ->type_name("N")
      ->check(CLI::Range(1, polishing::max_seeds));
  command.add_option("--first-seed", a.first_seed, "First seed [0]")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  command
      .add_option(
          "--ranges", a.ranges,
          "Ranges of the random disturbances: usual, wide (6 degrees, 5 mm) or curved (also curved "
          "shapes in turn, with 20 % error of curvature) [usual]; for the experiment seeds")
      ->type_name("NAME");
  command
      .add_option("--surface", a.surfaces,
                  "Surface in place of the experiment's surfaces; repeatable; not for the "
                  "experiment orientation")
      ->type_name("SURFACE")
      ->allow_extra_args(false);
  add_robots(command, a);
  command
      .add_option("--plant", a.plant,
                  polishing::has_mujoco() ? "Simulator: mujoco or ideal [mujoco]"
                                          : "Simulator: ideal; this build has no MuJoCo [ideal]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"mujoco", "ideal"}));
  command
      .add_option("--set", a.overrides,
                  "Set a key of the task, such as force=20; repeatable. The experiment overrides "
                  "the keys that it varies")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      .add_option_function<double>(
          "--duration",
          [&a](double duration) {
            a.overrides.push_back(fmt::format("phases.polish_duration={}", duration));
          },
          "Time on the path, in seconds; short for --set phases.polish_duration=S [from the "
          "experiment]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command.add_flag("--quick", a.quick,
                   "Make few and short runs, to test that the experiment works");
}

void add_options(CLI::App& command, ExperimentArguments& a) {
  add_words(command, a.campaign);
  command
      .add_option("--threads", a.threads,
                  "Number of parallel runs [one per core]; results do not depend on this number; "
                  "the experiment tick uses one")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--shard", a.shard,
                  "Make only part I of N of the runs, such as 2/4, or several parts, such as "
                  "1,3/4; burnish merge then makes the tables")
      ->type_name("I/N");
  command.add_flag(
      "--resume", a.resume,
      "Continue an earlier experiment in the output folder, and skip the runs that it contains");
  command
      .add_option("--time-limit", a.time_limit,
                  "Largest computing time of a run, in seconds [10 times the time of earlier runs, "
                  "at least 120]")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command.add_flag("--mixed", a.mixed,
                   "Accept runs made on other kinds of processors, which differ in the last "
                   "digits; the results state it");
  command
      .add_option("--scheduler", a.scheduler,
                  "Distribute the runs to the workers of a Dask scheduler, such as "
                  "tcp://192.168.0.5:8786")
      ->type_name("ADDRESS");
  command.add_flag("--list", a.list,
                   "Print the number, the result file and the name of each run, and make no runs");
  command
      .add_option("--out", a.out,
                  "Output folder [a new one: experiment_NAME, experiment_NAME_2, ...]")
      ->type_name("DIR");
  command.add_flag("--force", a.force, "Replace the results in the output folder");
  command.add_flag("--quiet", a.quiet, "Print nothing");
  add_strict(command, a.strict);
}

}  // namespace

void add_experiment(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("experiment", "Make the runs, tables and figures of an experiment");
  const auto arguments = std::make_shared<ExperimentArguments>();
  add_options(*command, *arguments);
  command->footer(
      "Experiments:\n" + list_of_experiments() +
      "\n"
      "Examples:\n"
      "  burnish experiment paper --seeds 3\n"
      "  burnish experiment orientation --set path.radius=0.04\n"
      "  burnish experiment force_test --robot my_arm.urdf --tool flange\n"
      "  burnish experiment robots --folder ~/checkouts\n"
      "  burnish experiment seeds --first-seed 17 --seeds 1\n"
      "  burnish experiment seeds --ranges wide --seeds 20\n"
      "  burnish experiment standing --seeds 10 --duration 2\n"
      "  burnish experiment seeds --shard 2/4 --out part_2 --resume\n"
      "\n"
      "Each writes results.md (tables), results.json (all numbers), results.csv (a row per run),\n"
      "figures, and the result of each run in runs/. Ctrl-C (or SIGTERM, or SIGHUP) ends the\n"
      "runs and writes the results so far; --resume continues from there.\n"
      "docs/experiments.md shows and explains the results; docs/campaigns.md describes "
      "experiments\n"
      "on several machines.\n"
      "Exit codes: 0 all runs polished, as the task's `verdict` requires, even if aims were "
      "missed;\n"
      "1 some runs did not polish; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = perform(*arguments); });
}

}  // namespace burnish::app

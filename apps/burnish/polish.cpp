// burnish polish: simulation of the polishing task in closed loop, with metrics, plots and records.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>

#include "base/yaml_word.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "command.hpp"
#include "fitted_controller.hpp"
#include "job_notes.hpp"
#include "plan_steps.hpp"
#include "polish_arguments.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/record/run_files.hpp"
#include "polishing/resting_hand.hpp"
#include "polishing/rotors.hpp"
#include "polishing/verdict.hpp"
#include "pressing/closed_run.hpp"
#include "progress_bar.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"
#include "report/figures.hpp"
#include "robot_arguments.hpp"
#include "settings_posture.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "task_argument.hpp"
#include "tick_table.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using polishing::ControllerKind;
using polishing::PlantKind;
using polishing::PolishJob;
using polishing::RunResult;

files::SpecTexts<polishing::Task> make_task(const PolishArguments& arguments,
                                            const std::string& surface) {
  std::vector<files::Override> words;
  const auto say = [&](const std::string& key, const char* option, const std::string& value) {
    if (!value.empty())
      words.push_back({key + "=" + yaml_word(value), std::string(option) + " " + value});
  };
  say("robot", "--robot", arguments.robot);
  say("tool.frame", "--tool", arguments.tool);
  say("surface", "--surface", surface);
  say("disturbances", "--disturbances", arguments.disturbances);
  if (arguments.assume_rotors) words.push_back({"assume_rotors=true", "--assume-rotors"});
  if (arguments.duration)
    words.push_back({fmt::format("phases.polish_duration={}", *arguments.duration),
                     fmt::format("--duration {}", *arguments.duration)});
  for (const std::string& word : arguments.overrides) words.push_back({word});
  if (!arguments.file.empty())
    return polishing::parse_said_task(read_text(arguments.file, "YAML file"), arguments.file,
                                      words);
  files::SpecTexts<polishing::Task> said;
  said.spec.disturbances = disturbance_preset("mismatch");
  files::change(said, words);
  polishing::check_task(said.spec);
  return said;
}

/// Returns the controllers to run. The default is MPC and baseline, or MPC alone if the task needs
/// plans.
std::vector<ControllerKind> controllers_of(const PolishArguments& arguments,
                                           const polishing::Task& task) {
  using enum ControllerKind;
  if (arguments.controller.empty() && !polishing::wants_plans(task).empty()) return {Mpc};
  if (arguments.controller.empty() || arguments.controller == "both") return {Mpc, Baseline};
  if (arguments.controller == "all") return {Mpc, Baseline, Admittance};
  for (const ControllerKind kind : {Mpc, Baseline})
    if (arguments.controller == name_of(kind)) return {kind};
  return {Admittance};
}

/// Returns the command line that repeats one of the runs.
std::string command_of(const PolishArguments& arguments, const std::string& surface,
                       const PolishJob& job) {
  std::vector<std::string> words{"burnish", "polish"};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  if (!arguments.file.empty()) words.push_back(arguments.file);
  add("--robot", arguments.robot);
  add("--tool", arguments.tool);
  add("--surface", surface);
  add("--controller", name_of(job.spec.controller));
  add("--plant", name_of(job.spec.plant));
  add("--disturbances", arguments.disturbances);
  for (const std::string& change : arguments.overrides) add("--set", change);
  add("--seed", std::to_string(job.spec.task.disturbances.seed));
  if (arguments.duration) add("--duration", fmt::format("{}", *arguments.duration));
  if (arguments.assume_rotors) words.emplace_back("--assume-rotors");
  if (arguments.unchecked) words.emplace_back("--unchecked");
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

/// Texts from which each task was read, by the name of the place (surface) of the task.
using Texts = std::map<std::string, std::vector<document::Reader>>;

std::vector<PolishJob> make_jobs(const PolishArguments& arguments, Texts& texts) {
  std::vector<std::string> surfaces = arguments.surfaces;
  if (surfaces.empty() && arguments.file.empty()) {
    surfaces = {"table"};
    if (arguments.robot.empty()) surfaces.emplace_back("board");
  }
  if (surfaces.empty()) surfaces = {""};
  if (!arguments.file.empty()) refuse_other_file(arguments.file, "polish", "--robot");
  std::vector<PolishJob> jobs;
  for (const std::string& surface : surfaces) {
    files::SpecTexts<polishing::Task> said = make_task(arguments, surface);
    polishing::Task& task = said.spec;
    std::string place =
        surface.empty() ? fs::path(arguments.file).stem().string() : place_name(surface, task);
    if (texts.contains(place)) place = surface;  // two surfaces would have the same name
    std::vector<int> seeds = arguments.seeds;
    if (seeds.empty()) seeds = {static_cast<int>(task.disturbances.seed)};
    for (const int seed : seeds) {
      task.disturbances.seed = static_cast<std::uint64_t>(seed);
      for (const ControllerKind controller : controllers_of(arguments, task)) {
        PolishJob job;
        job.place = place;
        job.name = job.place + "_" + name_of(controller);
        if (seeds.size() > 1) job.name += fmt::format("_seed{}", seed);
        job.spec.task = task;
        job.spec.controller = controller;
        job.spec.check_reach = !arguments.unchecked;
        if (!arguments.plant.empty())
          job.spec.plant = arguments.plant == "ideal" ? PlantKind::Ideal : PlantKind::Mujoco;
        job.command = command_of(arguments, surface, job);
        for (const PolishJob& other : jobs)
          if (other.name == job.name)
            throw Error(fmt::format(
                "the run {} is requested twice; wanted different surfaces or seeds", job.name));
        texts[job.place] = said.texts;
        jobs.push_back(std::move(job));
      }
    }
  }
  return jobs;
}

/// Loads each robot only once, because a robot from a pipe can be read only once.
void load_robots(std::vector<PolishJob>& jobs, const Texts& texts, bool strict) {
  std::map<std::pair<std::string, std::string>, Robot> robots;
  for (PolishJob& job : jobs) {
    const polishing::Task& task = job.spec.task;
    const auto key = std::pair(task.robot, task.tool);
    auto found = robots.find(key);
    if (found == robots.end()) {
      found = files::placed(texts.at(job.place), [&] {
        return robots.emplace(key, polishing::load_task_robot(task)).first;
      });
      print_warnings(found->second, strict);
    }
    job.spec.robot = found->second;
  }
}

/// Results of the checks at one place (surface), made before the first run.
struct CheckedPlace {
  PolishJob* job;  ///< First job at the place.
  polishing::ReachReport reach = {};
  /// Start posture that the search found; empty without a search.
  std::optional<Posture> found = {};
  std::optional<HomeMove> home = {};
  /// Postures from which a motion to the start is free of collisions, if the task states no home.
  std::vector<polishing::FreeHome> free_homes = {};
  std::vector<LightJoint> light_joints = {};
  FittedController controller = {};
};

/// Prints the start posture that the search found. With --write-posture, also adds it to the
/// settings of the robot.
void keep_posture(const CheckedPlace& place, const PolishArguments& arguments) {
  const PolishJob& job = *place.job;
  const std::string& name = arguments.write_posture;
  if (!place.found) {
    if (name.empty()) return;
    throw Error(
        fmt::format("--write-posture {}: the start posture at {} comes from the robot's settings; "
                    "wanted a task that searches for its start posture",
                    name, job.place));
  }
  const fs::path file = name.empty() ? fs::path() : settings_file_of(job.spec.task.robot);
  if (!name.empty()) add_posture(file, name, *place.found);
  if (!arguments.talks()) return;
  fmt::print("{}: start posture found by search: {}\n", job.place, posture_text(*place.found));
  if (!name.empty()) fmt::print("posture '{}' was added to {}\n", name, file.string());
}

/// Fits the gains to the arm, then checks the reach and the motion from home.
void check_place(CheckedPlace& place, const std::vector<document::Reader>& said, bool unchecked) {
  polishing::Task& task = place.job->spec.task;
  const bool plans = place.job->spec.controller == ControllerKind::Mpc;
  if (unchecked && !plans) return;
  const polishing::Setting setting = files::placed(said, [&] {
    polishing::Setting made = polishing::make_setting(task, *place.job->spec.robot);
    pressing::check_disturbances(made.robot.model, made.scene, task.disturbances);
    return made;
  });
  if (plans) place.controller = fit_controller(task, setting);
  if (!unchecked) {
    const std::string& name = place.job->place;
    if (plans) print_step_complaints(name, polishing::make_mpc(task, setting));
    place.reach = polishing::check_reach(task, setting);
    if (!place.reach.ok())
      throw Error(fmt::format("{} is out of reach: {}", name, place.reach.text));
    const polishing::ReachReport home_move = polishing::check_home(task, setting);
    if (!home_move.ok())
      throw Error(fmt::format("{}: the motion from home to the start is not possible: {}", name,
                              home_move.text));
    place.home = setting.home;
    if (!place.home) place.free_homes = polishing::free_homes(task, setting);
    place.light_joints = polishing::light_joints(task, setting);
    if (polishing::searches_posture(task, setting.robot) && !task.standing.stands())
      place.found = posture_of(setting.robot.model, setting.q_start);
  }
}

/// Checks all places (surfaces) before the first run, and prints notes and margins. The gains are
/// fitted once per place, for all jobs of the place.
void check(std::vector<PolishJob>& jobs, const Texts& texts, const PolishArguments& arguments) {
  std::vector<CheckedPlace> places;
  for (const PolishJob& job : jobs)
    if (const std::string refusal = polishing::wants_plans(job.spec.task);
        job.spec.controller != ControllerKind::Mpc && !refusal.empty())
      throw Error(job.name + ": " + refusal);
  for (PolishJob& job : jobs) {
    if (places.empty() || places.back().job->place != job.place) {
      places.push_back({.job = &job});
      check_place(places.back(), texts.at(job.place), arguments.unchecked);
    }
    const polishing::Task& fitted = places.back().job->spec.task;
    job.spec.task.model_error = fitted.model_error;
    job.spec.task.weights = fitted.weights;
  }
  for (const CheckedPlace& place : places) {
    if (!place.light_joints.empty())
      fmt::print(stderr, "burnish: {}: note: {}, or --assume-rotors\n", place.job->place,
                 light_joints_text(place.light_joints));
    keep_posture(place, arguments);
    if (arguments.talks() && !arguments.unchecked)
      describe_home_move(place.job->place, place.home, place.free_homes);
    describe(place.controller, place.job->place, arguments.talks());
    describe_job(*place.job, place.reach, texts.at(place.job->place), arguments.talks());
  }
}

RunResult run_job(PolishJob& job, bool bar) {
  RunProgressText text(job.name, bar);
  job.spec.progress = [&text](double time, double end) {
    text.show(time, end);
    return !StopRequest::asked();
  };
  RunResult result = polishing::run_task(job.spec);
  if (bar) fmt::print(stderr, "\r\033[K");
  return result;
}

/// Results of all runs of this command, and the state of their files.
struct Outcomes {
  PageWriter pages;
  bool is_single = false;  ///< True if the output folder is the folder of the only run.
  std::vector<RunResult> results = {};
  nlohmann::ordered_json summary = nlohmann::ordered_json::array();
  std::string unwritten = {};  ///< Reason why files could not be written; empty: all were written.
  std::string page_note = {};

  /// Calls work() unless an earlier call failed. An Error is kept in `unwritten`, so that the
  /// results are still printed.
  template <class Write>
  void write(const Write& work) {
    if (!unwritten.empty()) return;
    try {
      work();
    } catch (const Error& error) {
      unwritten = error.what();
    }
  }
};

/// Writes the files of the last run, and summary.json for all runs so far. Returns the names of the
/// last run's files.
std::vector<std::string> write_last(const PolishJob& job, const PolishArguments& arguments,
                                    const fs::path& folder, Outcomes& outcomes) {
  const RunResult& result = outcomes.results.back();
  std::vector<std::string> names;
  const pressing::RecordedRun record = recorded(job, result);
  outcomes.summary.push_back(run_json(record));
  outcomes.write([&] {
    names = write_run(record, {.record_every = arguments.record_every, .plots = arguments.plots},
                      outcomes.is_single ? folder : folder / job.name, outcomes.pages);
    if (!outcomes.is_single) write_text(folder / "summary.json", json_text(outcomes.summary));
  });
  return names;
}

void print_end(const std::vector<PolishJob>& jobs, const Outcomes& outcomes, const fs::path& folder,
               const PolishArguments& arguments) {
  if (arguments.json)
    return fmt::print("{}\n",
                      json_text(outcomes.is_single ? outcomes.summary[0] : outcomes.summary));
  if (arguments.is_run && arguments.quiet) return;
  const std::vector<RunResult>& results = outcomes.results;
  std::vector<NamedMetrics> rows;
  std::vector<NamedStanding> stood;
  std::string rotors;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].metrics) rows.push_back({jobs[i].name, *results[i].metrics});
    if (results[i].standing) stood.push_back({jobs[i].name, *results[i].standing});
    if (const std::string assumed = polishing::assumed_rotors_text(results[i].setting);
        !assumed.empty())
      rotors +=
          jobs[i].name + ": assumed rotor inertias, in controller and plant: " + assumed + "\n";
  }
  if (!rows.empty()) fmt::print("\n{}", metrics_table(rows));
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].verdict)
      if (const std::string text = cut_short_text(jobs[i].spec.task, *results[i].verdict);
          !text.empty())
        fmt::print("{}: {}\n", jobs[i].name, text);
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].rest)
      fmt::print("{}: {}\n", jobs[i].name, rest_text(jobs[i].spec.task.rest, *results[i].rest));
  if (!stood.empty()) fmt::print("\n{}", standing_table(stood));
  fmt::print("{}", rotors);
  print_timing(jobs, results);
  if (arguments.time) print_times(jobs, results);
  if (!arguments.talks() || !outcomes.unwritten.empty()) return;
  if (!outcomes.is_single)
    fmt::print("\nin {}: summary.json, and a folder for each run\n", folder.string());
  if (!outcomes.page_note.empty()) fmt::print("{}\n", outcomes.page_note);
}

void make_runs(std::vector<PolishJob>& jobs, const PolishArguments& arguments,
               const fs::path& folder, Outcomes& outcomes) {
  const bool bar = arguments.talks() && isatty(STDERR_FILENO) != 0;
  for (PolishJob& job : jobs) {
    outcomes.results.push_back(run_job(job, bar));
    const RunResult& result = outcomes.results.back();
    const auto names = write_last(job, arguments, folder, outcomes);
    if (arguments.talks() || (!arguments.json && !result.succeeded))
      fmt::print("{}: {}\n", job.name, result.outcome);
    if (arguments.talks() && outcomes.unwritten.empty())
      fmt::print("  {}: {}\n", (outcomes.is_single ? folder : folder / job.name).string(),
                 fmt::join(names, ", "));
    std::fflush(stdout);
    outcomes.results.back().trace = {};
    if (StopRequest::asked()) break;
  }
  outcomes.write([&] { outcomes.page_note = outcomes.pages.finish(folder); });
}

/// Throws Error if --write-posture is combined with --unchecked or with several surfaces.
void check_write_posture(const PolishArguments& arguments, const std::vector<PolishJob>& jobs) {
  if (arguments.write_posture.empty()) return;
  const std::string option = "--write-posture " + arguments.write_posture;
  if (arguments.unchecked) throw Error(option + " cannot be combined with --unchecked");
  for (const PolishJob& job : jobs)
    if (job.place != jobs.front().place)
      throw Error(option + " is given for several surfaces; wanted one --surface");
  settings_file_of(jobs.front().spec.task.robot);
}

}  // namespace

int polish(const PolishArguments& arguments) {
  Texts texts;
  std::vector<PolishJob> jobs = make_jobs(arguments, texts);
  check_write_posture(arguments, jobs);
  if (!arguments.write_task.empty()) {
    polishing::write_task(jobs.front().spec.task, arguments.write_task);
    return exit_ok;
  }
  named_by(arguments.file, [&] {
    load_robots(jobs, texts, arguments.strict);
    check(jobs, texts, arguments);
  });
  const StopRequest stop("the run ends and its results so far are written");
  const std::string task =
      arguments.file.empty() ? "polishing" : fs::path(arguments.file).stem().string();
  RunFolder folder({.out = arguments.out, .name = task + "_run", .force = arguments.force});
  const bool is_single = arguments.is_run && jobs.size() == 1;
  std::vector<std::string> names{"summary.json", "comparison.html"};
  for (const PolishJob& job : jobs) names.push_back(job.name + "/");
  folder.claim(is_single ? pressing::run_file_names() : names);

  Outcomes outcomes{.pages = {!arguments.no_page, arguments.mcap}, .is_single = is_single};
  make_runs(jobs, arguments, folder.path(), outcomes);
  outcomes.write([&] { folder.finish(); });
  if (const std::string missing = outcomes.pages.missing_meshes(); !missing.empty())
    fmt::print(stderr, "burnish: note: {}\n", missing);
  print_end(jobs, outcomes, folder.path(), arguments);
  if (!outcomes.unwritten.empty()) throw Error(outcomes.unwritten);
  const bool succeeded = std::all_of(outcomes.results.begin(), outcomes.results.end(),
                                     [](const RunResult& result) { return result.succeeded; });
  return succeeded && !StopRequest::asked() ? exit_ok : exit_failed;
}

void add_polish(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "polish", "Simulate a robot that polishes a surface, and score the result");
  const auto arguments = std::make_shared<PolishArguments>();
  arguments->add_to(*command);
  command->footer(
      "Examples:\n"
      "  burnish polish                                    table and board, MPC and baseline\n"
      "  burnish polish --surface board --controller mpc --set force=20 --set path.rate=2\n"
      "  burnish polish --robot my_arm.urdf --tool flange  searches a start posture on the table\n"
      "  burnish polish my_task.yaml --disturbances joint_friction --seed 1 --seed 2\n"
      "  burnish polish --controller all                   MPC and two controllers without plans\n"
      "  burnish polish --surface table --write-task my_task.yaml\n"
      "\n"
      "Each run writes a folder with run.html (a page for any browser), trace.csv, metrics.json,\n"
      "task.yaml, run.json and, after a fault, fault.txt and last_second.csv. Several runs also\n"
      "write comparison.html. Ctrl-C (or SIGTERM, or SIGHUP) ends the run and writes the results\n"
      "so far. docs/polishing.md and docs/run_page.md describe the files.\n"
      "Exit codes: 0 polished, as the task's `verdict` requires; 1 not polished: a fault, no "
      "contact,\n"
      "a metric outside the verdict, or an interruption; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = polish(*arguments); });
}

}  // namespace burnish::app

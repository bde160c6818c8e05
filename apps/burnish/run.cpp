// burnish run: closed-loop simulation of the task that a task file selects, with metrics and an
// HTML page.
#include "burnish/tasks/polishing/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "base/sentence.hpp"
#include "base/whole_file.hpp"
#include "base/yaml_word.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "command.hpp"
#include "named_tasks.hpp"
#include "plan_steps.hpp"
#include "polish_arguments.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/recorded_run.hpp"
#include "pressing/task_form.hpp"
#include "progress_bar.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"
#include "report/figures.hpp"
#include "robot_arguments.hpp"
#include "shell_word.hpp"
#include "signals.hpp"
#include "sim/light_joints.hpp"
#include "task_argument.hpp"

namespace burnish::app {
namespace {

/// Returns the overrides of task keys that --robot, --tool, --set and `seed` imply.
std::vector<files::Override> changes_of(const RunArguments& a, std::optional<int> seed) {
  std::vector<files::Override> words;
  if (!a.robot.empty()) words.push_back({"robot=" + yaml_word(a.robot), "--robot " + a.robot});
  if (!a.tool.empty()) words.push_back({"tool.frame=" + yaml_word(a.tool), "--tool " + a.tool});
  for (const std::string& word : a.overrides) words.push_back({word});
  if (seed)
    words.push_back({fmt::format("disturbances.seed={}", *seed), fmt::format("--seed {}", *seed)});
  return words;
}

/// Returns the command line that repeats a run.
std::string command_of(const RunArguments& a, std::optional<int> seed, PlantKind plant) {
  std::string text = "burnish run " + shell_word(a.file) + " --plant " + name_of(plant);
  if (!a.robot.empty()) text += " --robot " + shell_word(a.robot);
  if (!a.tool.empty()) text += " --tool " + shell_word(a.tool);
  if (seed) text += fmt::format(" --seed {}", *seed);
  for (const std::string& change : a.overrides) text += " --set " + shell_word(change);
  return text + (a.unchecked ? " --unchecked" : "");
}

/// Prints a note about joints whose description lacks a rotor inertia.
template <class Task, class Setting>
void note_light_joints(const Task& task, const Setting& setting) {
  const double period = 1.0 / task.tick_rate;
  const std::vector<LightJoint> light =
      light_joints(setting.robot.model, setting.q_start, task.disturbances,
                   {plant_step(period), period, task.limits.joint_speed_ratio});
  if (!light.empty()) fmt::print(stderr, "burnish: note: {}\n", light_joints_text(light));
}

/// Prints delay and gain margins of an arm's control loop under the disturbances `sensors`. Prints
/// a warning if the margins are smaller than required, and nothing if they cannot be computed.
template <class Task>
void print_margins(const std::string& name, const Task& task, const MpcSpec& spec, bool talks) {
  if (!without_margins(spec).empty()) return;
  const LoopChain chain =
      polishing::chain_of(disturbance_preset("sensors"), task.stiffness, task.damping);
  const LoopAnalysis air(spec, chain, free_phase(spec)), contact(spec, chain, pressing_phase(spec));
  const polishing::RequiredMargins wanted;
  const auto meets = [&](const LoopAnalysis& loop) {
    return loop.tolerates(spec.model_error, wanted.delay, wanted.gain);
  };
  const polishing::TaskMargins margins{air.margins(spec.model_error),
                                       contact.margins(spec.model_error)};
  if (!meets(air) || !meets(contact))
    fmt::print(stderr,
               "burnish: {}: warning: the control loop tolerates {}; wanted {:g} ms of extra "
               "delay, and gains of 0.5 to 2 in each joint\n",
               name, margins.text(), 1e3 * wanted.delay);
  else if (talks)
    fmt::print("{}: the control loop tolerates {}\n", name, margins.text());
}

/// Prints notes and warnings about a run, before the run begins.
template <class RunSpec>
void print_notes(const RunArguments& a, const std::string& name, const RunSpec& spec,
                 bool states_disturbances) {
  note_light_joints(spec.task, *spec.setting);
  if constexpr (requires { spec.task.step; })
    print_step_complaints(name, make_mpc(spec.task, *spec.setting));
  for (const std::string& note : task_notes(spec.task, states_disturbances))
    fmt::print(stderr, "burnish: note: {}\n", note);
  if constexpr (requires { setting_notes(spec.task, *spec.setting); })
    for (const std::string& note : setting_notes(spec.task, *spec.setting))
      fmt::print(stderr, "burnish: note: {}\n", note);
  if constexpr (requires { spec.task.stiffness; })
    print_margins(name, spec.task, make_mpc(spec.task, *spec.setting), a.talks());
}

/// Reads and checks the task and the robot, and returns the specification of the run with this
/// seed. Creates no folder.
template <class TaskType>
auto checked_run(const RunArguments& a, std::optional<int> seed, bool is_first) {
  using RunSpec = typename TaskType::RunSpec;
  const auto said = files::read_said<typename TaskType::Task>(a.file, changes_of(a, seed));
  pressing::NamedRun<RunSpec> run{.name = std::filesystem::path(a.file).stem().string(),
                                  .spec = {.task = said.spec}};
  RunSpec& spec = run.spec;
  const std::string file = run.name;
  if (a.seeds.size() > 1) run.name += fmt::format("_seed{}", *seed);
  if (!a.plant.empty()) spec.plant = a.plant == "ideal" ? PlantKind::Ideal : PlantKind::Mujoco;
  spec.check_reach = !a.unchecked;
  run.command = command_of(a, seed, spec.plant);
  files::placed(said.texts, [&] {
    named_by(a.file, [&] {
      check_task(spec.task);
      if (!a.write_task.empty()) return;
      const Robot robot = load_task_robot(spec.task);
      if constexpr (requires { spec.task.standing; })
        check_stated_feet(robot.model, spec.task.standing, said.texts);
      if (is_first) print_warnings(robot, a.strict);
      if constexpr (requires { fit_to_robot(spec.task, robot); })
        if (is_overridden(said.texts, "robot"))
          for (const std::string& change : fit_to_robot(spec.task, robot))
            if (is_first) fmt::print(stderr, "burnish: note: {}\n", change);
      spec.setting = make_setting(spec.task, robot);
      pressing::check_disturbances(spec.setting->robot.model, spec.setting->scene,
                                   spec.task.disturbances);
      if (spec.check_reach) refuse_out_of_reach(spec.task, *spec.setting);
      if (is_first) print_notes(a, file, spec, pressing::states_disturbances(said.texts));
    });
  });
  return run;
}

/// Metrics and HTML pages of all runs of this command.
struct RunOutcomes {
  PageWriter pages;
  bool succeeded = true;
  nlohmann::ordered_json summary = nlohmann::ordered_json::array();
  std::vector<NamedMetrics> metrics = {};
  std::vector<NamedStanding> stood = {};
};

/// Makes a run and writes its files into `folder`.
template <class Run>
void make_run(Run& run, const RunArguments& a, const std::filesystem::path& folder,
              RunOutcomes& outcomes) {
  const bool talks = a.talks(), bar = talks && isatty(STDERR_FILENO) != 0;
  RunProgressText text(run.name, bar);
  run.spec.progress = [&](double time, double end) {
    text.show(time, end);
    return !StopRequest::asked();
  };
  const auto result = run_task(run.spec);
  if (bar) fmt::print(stderr, "\r\033[K");
  const pressing::RecordedRun record = recorded(run, result);
  const auto names =
      write_run(record, {.record_every = a.record_every, .plots = a.plots}, folder, outcomes.pages);
  outcomes.succeeded = outcomes.succeeded && result.succeeded;
  outcomes.summary.push_back(run_json(record));
  if (record.metrics) outcomes.metrics.push_back({run.name, *record.metrics});
  if (result.standing) outcomes.stood.push_back({run.name, *result.standing});
  if (talks || (!a.json && !result.succeeded)) fmt::print("{}: {}\n", run.name, result.outcome);
  if (talks) fmt::print("  {}: {}\n", folder.string(), fmt::join(names, ", "));
  std::fflush(stdout);
}

/// Writes summary.json and the HTML page of all seeds, and prints the tables of all seeds.
void end_seeds(const RunArguments& a, const std::filesystem::path& folder,
               const RunOutcomes& outcomes) {
  write_text(folder / "summary.json", json_text(outcomes.summary));
  const std::string note = outcomes.pages.finish(folder);
  if (a.json) return;
  if (!outcomes.metrics.empty()) fmt::print("\n{}", metrics_table(outcomes.metrics));
  if (!outcomes.stood.empty()) fmt::print("\n{}", standing_table(outcomes.stood));
  if (!a.quiet && !note.empty()) fmt::print("{}\n", note);
}

/// Runs a task of the type `TaskType`, which selects the overloads of all functions.
template <class TaskType>
int run_as(const RunArguments& a) {
  std::vector<std::optional<int>> seeds(a.seeds.begin(), a.seeds.end());
  if (seeds.empty()) seeds.push_back(std::nullopt);
  for (auto seed = seeds.begin(); seed != seeds.end(); ++seed)
    if (std::count(seeds.begin(), seed, *seed) > 0)
      throw Error(fmt::format("seed {} is given twice; wanted different seeds", **seed));
  const bool several = seeds.size() > 1;
  std::vector<decltype(checked_run<TaskType>(a, seeds[0], true))> runs;
  std::vector<std::string> claimed =
      several ? std::vector<std::string>{"summary.json", "comparison.html"}
              : pressing::run_file_names();
  for (const std::optional<int>& seed : seeds) {
    runs.push_back(checked_run<TaskType>(a, seed, runs.empty()));
    if (!a.write_task.empty()) {
      write_whole_file(a.write_task, task_text(runs.front().spec.task));
      return exit_ok;
    }
    if (several) claimed.push_back(runs.back().name + "/");
  }
  const StopRequest stop("the run ends and its results so far are written");
  RunFolder folder({.out = a.out,
                    .name = std::filesystem::path(a.file).stem().string() + "_run",
                    .force = a.force});
  folder.claim(claimed);
  RunOutcomes outcomes{.pages = {!a.no_page, a.mcap}};
  for (auto& run : runs) {
    make_run(run, a, several ? folder.path() / run.name : folder.path(), outcomes);
    if (StopRequest::asked()) break;
  }
  if (several) end_seeds(a, folder.path(), outcomes);
  folder.finish();
  if (const std::string missing = outcomes.pages.missing_meshes(); !missing.empty())
    fmt::print(stderr, "burnish: note: {}\n", missing);
  if (a.json) fmt::print("{}\n", json_text(several ? outcomes.summary : outcomes.summary[0]));
  return outcomes.succeeded ? exit_ok : exit_failed;
}

/// Runs a polishing task with the MPC, as `burnish polish` does.
int run_polishing(const RunArguments& a) {
  PolishArguments of{a};
  of.controller = name_of(polishing::ControllerKind::Mpc);
  of.is_run = true;
  return polish(of);
}

/// Runs the task that the file selects. A file without the key `task` is read as the first task in
/// the table; its reader then reports the missing key.
int run(const RunArguments& arguments) {
  const std::string& file = arguments.file;
  refuse_other_file(file, "run", "burnish run TASK --robot");
  if (is_polishing_task(file)) return run_polishing(arguments);
  const auto task = files::Reader::parse(read_text(file, "YAML file"), file).find("task");
  std::optional<int> code;
  std::function<int()> first;
  each_named_task([&](const auto& named) {
    using TaskType = std::decay_t<decltype(named)>;
    if (!first) first = [&] { return run_as<TaskType>(arguments); };
    if (task && !code && task->is(named.name)) code = run_as<TaskType>(arguments);
  });
  if (task && !code)
    task->refuse("unknown task " + in_quotes(task->node().text) + "; wanted " +
                 fmt::format("{}", fmt::join(task_names(), " or ")) +
                 did_you_mean(task->node().text, task_names()));
  return code ? *code : first();
}

/// Returns the list of tasks for help texts: "`task: press_hold` presses ...; `task: ...".
std::string what_tasks_do() {
  std::string text;
  each_named_task([&](const auto& named) {
    text += fmt::format("{}`task: {}` {}", text.empty() ? "" : ";\n", named.name, named.does);
  });
  return text;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("run", "Simulate the task of a task file, such as press_hold");
  const auto arguments = std::make_shared<RunArguments>();
  command->add_option("TASK", arguments->file, "Task file, with a key such as `task: press_hold`")
      ->type_name("")
      ->required();
  add_run_options(*command, *arguments,
                  {.robot = "from the task file",
                   .tool = "from the task file",
                   .out = "TASK_run, TASK_run_2, ...",
                   .key = "PATH=VALUE",
                   .quiet = "Print nothing unless the run fails",
                   .json = "Print metrics.json and nothing else"});
  command->footer(
      "Examples:\n"
      "  burnish run tasks/press_hold/arm7.yaml\n"
      "  burnish run tasks/push_wall/talos.yaml --set force=30\n"
      "  burnish run tasks/stand/quadruped.yaml --set disturbances=joint_friction\n"
      "  burnish run tasks/press_hold/arm7.yaml --seed 1 --seed 2 --seed 3\n"
      "  burnish run my_task.yaml --plant ideal --out /tmp/my_run\n"
      "  burnish run tasks/press_hold/arm7.yaml --robot my_arm.urdf --tool flange \\\n"
      "      --set 'aside={my_joint: 0.5}'\n"
      "\n"
      "The file names its task:\n" +
      what_tasks_do() +
      ".\n\nWrites trace.csv, metrics.json, task.yaml, run.html, run.json and, after a fault,\n"
      "fault.txt and last_second.csv. Ctrl-C (or SIGTERM, or SIGHUP) ends the run and writes the\n"
      "results so far. With several seeds, writes a folder for each, summary.json and\n"
      "comparison.html, and prints a table. A file without the key `task` is a polishing task,\n"
      "which runs as with burnish polish --controller mpc. docs/tasks.md describes tasks.\n"
      "Exit codes: 0 succeeded; 1 failed, for example by a fault, a fall or an interruption;\n"
      "2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace burnish::app

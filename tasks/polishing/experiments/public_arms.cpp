#include "polishing/experiments/public_arms.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/found_posture.hpp"
#include "polishing/rotors.hpp"

namespace burnish::polishing {
namespace {

/// Time on the path [s]. The circle grows during the first half; metrics are computed over the
/// second half.
constexpr double path_duration = 4.0;
/// Delay of the commands [s], and whether the controller compensates it.
constexpr std::pair<double, bool> delays[] = {{3e-3, false}, {5e-3, true}};

Task task_of(const ExperimentSpec& spec, const PublicRobot& arm, const std::string& surface,
             const std::string& preset) {
  Task task = experiment_task(spec, surface, preset, path_duration);
  override_task(task, arm.changes);
  override_task(task, spec.overrides);  // last, so that they override the changes of the list
  task.robot = arm.name;  // results must not depend on the location of the description
  task.tool = arm.tool;
  return task;
}

Task task_of(const ExperimentSpec& spec, const ArmTrial& trial) {
  Task task = task_of(spec, trial.bench->arm, trial.bench->surface, trial.preset);
  if (trial.delay > 0.0) task.disturbances.command_delay = trial.delay;
  if (trial.known) task.command_delay = trial.delay;
  return task;
}

/// Run of an arm with the steps of `burnish polish`.
struct ArmRun {
  ArmBench* bench;
  RunSpec spec;   ///< Specification; start and force come from the bench.
  bool predicts;  ///< True to predict the extra delay that the control loop tolerates.
  std::string name;

  RunFigures operator()(const RunProgress& progress) const {
    std::call_once(bench->searched, &ArmBench::search, bench);
    if (!bench->reason.empty()) throw Error(bench->reason);
    RunSpec run = spec;
    run.progress = progress;
    run.robot = bench->robot;
    run.task.force = bench->force;
    start_from(bench->q_start, *run.robot, run.task);
    const Setting setting = make_setting(run.task, *run.robot);
    const RunResult result = run_task(run);
    RunFigures figure = figures_of(name, run.task, result);
    figure.made = !result.interrupted;
    figure.measured = measured(run.task, setting);
    return figure;
  }

 private:
  std::vector<MeasuredFigure> measured(const Task& task, const Setting& setting) const {
    const auto count = [](std::size_t number) { return static_cast<double>(number); };
    std::vector<MeasuredFigure> all{
        {"arm", public_figures::force, task.force},
        {"arm", public_figures::mass, setting.robot.model.total_mass()},
        {"arm", public_figures::rotors, count(setting.assumed_rotors.size())},
        {"arm", public_figures::light, count(light_joints(task, setting).size())}};
    if (!predicts) return all;
    if (const auto found = margins(task, setting))
      all.push_back({"arm", public_figures::delay, found->delay()});
    return all;
  }
};

/// Returns the text of all inputs of a run, for the name of its stored result.
std::string text_of(const ArmRun& run) {
  return name_of(run.spec.controller) + '\n' + burnish::name_of(run.spec.plant) + '\n' +
         task_text(run.spec.task) + run.bench->numbers;
}

std::vector<std::string> arm_surfaces(const ExperimentSpec& spec) {
  if (!spec.surfaces.empty()) return spec.surfaces;
  if (spec.quick) return {"table"};
  return {"table", "board", "tilt_45"};
}

}  // namespace

void ArmBench::search() {
  const auto attempt = [&](double newton) -> std::string {
    Task tried = task;
    tried.force = newton;
    try {
      const Setting setting = make_setting(tried, robot);
      const ReachReport reach = check_reach(tried, setting);
      if (!reach.ok()) return "the task is out of reach: " + reach.text;
      force = newton;
      q_start = setting.q_start;
      return {};
    } catch (const Error& error) {
      return error.what();
    }
  };
  double refused = task.force, possible = std::min(least_force, task.force);
  if (attempt(refused).empty()) return;
  if (reason = attempt(possible); !reason.empty()) return;
  while (refused - possible > 1.0) {
    const double middle = std::floor(0.5 * (refused + possible));
    (attempt(middle).empty() ? possible : refused) = middle;
  }
}

std::string ArmTrial::name() const {
  if (delay == 0.0) return preset + ", " + name_of(controller);
  return number(1e3 * delay) + " ms " + (known ? "known" : "unknown");
}

void PublicArms::add_trial(ArmTrial trial, int seeds, std::vector<BatchRun>& runs) {
  const PublicRobot& arm = trial.bench->arm;
  const std::string name = arm.name + ", " + trial.bench->surface + ", " + trial.name();
  for (int seed = spec_.first_seed; seed < spec_.first_seed + seeds; ++seed) {
    BatchRun run{.name = name + ", seed " + std::to_string(seed)};
    trial.runs.push_back(runs.size());
    run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
    if (spec_.shard.has(runs.size())) {
      ArmRun made{.bench = trial.bench,
                  .spec = {.task = task_of(spec_, trial), .controller = trial.controller},
                  .predicts = trial.delay > 0.0 && !trial.known,
                  .name = run.name};
      made.spec.task.disturbances.seed = run.spec.task.disturbances.seed;
      made.spec.plant = spec_.plant;
      made.spec.check_reach = false;  // search() checks the reach, once for all runs
      made.spec.plan_rate = 0.0;
      run.depends_on = text_of(made);
      run.perform = std::move(made);
    }
    runs.push_back(std::move(run));
  }
  trials_.push_back(std::move(trial));
}

void PublicArms::add(const PublicRobot& arm, const std::filesystem::path& file,
                     std::vector<BatchRun>& runs) {
  const int seeds = seeds_of(spec_, spec_.quick ? 1 : 3);
  bool first = true;
  for (const std::string& surface : arm_surfaces(spec_)) {
    auto bench = std::make_unique<ArmBench>();
    bench->arm = arm;
    bench->surface = surface;
    bench->task = task_of(spec_, arm, surface, "mismatch");
    try {
      Task named = bench->task;
      named.robot = file.string();
      bench->robot = load_task_robot(named);
    } catch (const Error& error) {
      unread_.push_back({arm.name, "description", error.what()});
      return;
    }
    bench->numbers = numbers_of(bench->robot);
    ArmBench* const at = bench.get();
    benches_.push_back(std::move(bench));
    for (const char* preset : {"mismatch", "joint_friction"})
      for (const ControllerKind controller : {ControllerKind::Mpc, ControllerKind::Baseline})
        add_trial({.bench = at, .preset = preset, .controller = controller}, seeds, runs);
    for (const auto& [delay, known] : delays)
      if (first) add_trial({.bench = at, .delay = delay, .known = known}, 1, runs);
    first = false;
  }
}

void PublicArms::report(const std::vector<RunFigures>& figures, PublicReport& common,
                        ExperimentReport& report) const {
  for (const UntriedRobot& each : unread_) common.add_untried(each);
  for (const ArmTrial& trial : trials_)
    for (const RunFigures& run : chosen(figures, trial.runs))
      common.add_run(trial.bench->arm.name, trial.bench->surface, trial.name(), run);
  if (trials_.empty()) return;
  for (auto make : {arms_table, delays_table})
    if (ResultTable table = make(trials_, figures, common); !table.rows.empty())
      report.tables.push_back(std::move(table));
}

}  // namespace burnish::polishing

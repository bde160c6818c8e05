#include "polishing/experiments/public_legs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/degrees.hpp"
#include "base/sentence.hpp"
#include "base/yaml_word.hpp"
#include "burnish/tasks/stand/stand.hpp"
#include "polishing/experiments/shipped_tasks.hpp"

namespace burnish::polishing {
namespace {

/// Returns the bundled task that `robot` selects, changed to this robot and its feet.
stand::Task task_of(const ExperimentSpec& spec, const PublicRobot& robot) {
  const auto& texts = shipped_stand_texts();
  const auto found =
      std::ranges::find_if(texts, [&](const auto& each) { return each.first == robot.task; });
  std::string feet;
  for (const std::string& foot : robot.feet) feet += (feet.empty() ? "" : ", ") + yaml_word(foot);
  std::vector<std::string> changes{"robot=" + yaml_word(robot.name), "standing.feet=[" + feet + "]",
                                   "disturbances=mismatch"};
  // Replaces a posture of the task file by a search: that posture suits only the bundled robot.
  const stand::Task shipped = stand::parse_task(std::string(found->second), robot.task + ".yaml");
  if (!shipped.posture.empty()) changes.emplace_back("posture=search");
  if (spec.quick)
    changes.insert(changes.end(),
                   {"standing.settle=0.3", "phases.settle_duration=0.1", "phases.sway_duration=0.5",
                    "phases.rest_duration=0.1", "sway.rise=0.2"});
  changes.insert(changes.end(), robot.changes.begin(), robot.changes.end());
  return stand::parse_task(std::string(found->second), robot.task + ".yaml", changes);
}

/// Returns additional measurements of a run: mass, whether the robot fell, amplitudes of the sway
/// within the robot's limits, and errors and slip during the sway.
std::vector<MeasuredFigure> measured_of(const stand::RunResult& result) {
  const stand::Sway& sway = result.setting.sway;
  std::vector<MeasuredFigure> all{
      {"robot", public_figures::mass, result.setting.robot.model.total_mass()},
      {"robot", "fell", result.fell ? 1.0 : 0.0}};
  const char* const axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    all.push_back({"sway", std::string("shift_") + axes[i], sway.shift[i]});
    all.push_back({"sway", std::string("turn_") + axes[i], sway.turn[i]});
  }
  if (!result.sway) return all;
  all.push_back({"sway", "com_rmse", result.sway->com_rmse});
  all.push_back({"sway", "turn_rmse", result.sway->turn_rmse});
  all.push_back({"sway", "foot_slip", result.sway->foot_slip});
  return all;
}

struct StandingRun {
  stand::Task task = {};
  Robot robot = {};
  std::string name = {};

  RunFigures operator()(const RunProgress& progress) const {
    const stand::RunResult result = stand::run_task({.task = task,
                                                     .setting = stand::make_setting(task, robot),
                                                     .plan_rate = 0.0,
                                                     .progress = progress});
    RunFigures figure{.name = name, .outcome = result.outcome, .made = !result.interrupted};
    figure.succeeded = result.succeeded;
    figure.fault = result.fault.kind;
    figure.finite = all_finite(result.trace);
    figure.seed = task.disturbances.seed;
    figure.ticks = result.ticks;
    figure.standing = result.standing;
    figure.q_start = result.setting.q_start;
    figure.measured = measured_of(result);
    return figure;
  }
};

/// Returns the figures name_x, name_y and name_z as text, such as "30, 20, 20".
std::string amplitudes(const RunFigures& run, const std::string& name, double factor) {
  std::string text;
  for (const char* axis : {"_x", "_y", "_z"}) {
    char words[32];
    std::snprintf(words, sizeof words, "%s%.3g", text.empty() ? "" : ", ",
                  factor * measured(run, name + axis));
    text += words;
  }
  return text;
}

double largest(const std::vector<RunFigures>& runs, const char* figure, double factor) {
  std::vector<double> values;
  for (const RunFigures& run : runs) values.push_back(measured(run, figure));
  return factor * largest_of(values);
}

template <class Counts>
double number_of(const std::vector<RunFigures>& runs, const Counts& counts) {
  return static_cast<double>(std::count_if(runs.begin(), runs.end(), counts));
}

std::vector<ResultCell> cells_of(const PublicRobot& robot, const std::vector<RunFigures>& runs) {
  const RunFigures& first = runs.front();
  const auto bad = std::ranges::find_if(runs, [](const RunFigures& run) { return !run.succeeded; });
  return {robot.name,
          robot.task,
          measured(first, public_figures::mass),
          static_cast<double>(runs.size()),
          static_cast<double>(polished_of(runs)),
          number_of(runs, [](const RunFigures& run) { return run.fault != FaultKind::None; }),
          number_of(runs, [](const RunFigures& run) { return measured(run, "fell") > 0.0; }),
          amplitudes(first, "shift", 1e3),
          amplitudes(first, "turn", degrees_per_radian),
          shown("standing.com_moved", largest_of(collect(runs, "standing.com_moved"))),
          largest(runs, "com_rmse", 1e3),
          largest(runs, "turn_rmse", degrees_per_radian),
          largest(runs, "foot_slip", 1e3),
          bad == runs.end() ? std::string("-") : bad->outcome};
}

}  // namespace

void PublicLegs::add(const PublicRobot& robot, const std::filesystem::path& file,
                     std::vector<BatchRun>& runs) {
  if (spec_.plant != PlantKind::Mujoco) {
    unread_.push_back({robot.name, "ground", "standing needs the plant mujoco"});
    return;
  }
  StandingRun stands{.task = task_of(spec_, robot)};
  try {
    stand::Task named = stands.task;
    named.robot = file.string();
    stands.robot = stand::load_task_robot(named);
  } catch (const Error& error) {
    unread_.push_back({robot.name, "description", error.what()});
    return;
  }
  standers_.push_back({robot});
  const std::string depends_on = stand::task_text(stands.task) + numbers_of(stands.robot);
  const int seeds = seeds_of(spec_, spec_.quick ? 1 : 3);
  for (int seed = spec_.first_seed; seed < spec_.first_seed + seeds; ++seed) {
    stands.name = robot.name + ", stand, seed " + std::to_string(seed);
    stands.task.disturbances.seed = static_cast<std::uint64_t>(seed);
    standers_.back().runs.push_back(runs.size());
    BatchRun run{.name = stands.name};
    run.spec.task.disturbances.seed = stands.task.disturbances.seed;
    run.perform = stands;
    run.depends_on = depends_on;
    runs.push_back(std::move(run));
  }
}

void PublicLegs::report(const std::vector<RunFigures>& figures, PublicReport& common,
                        ExperimentReport& report) const {
  for (const UntriedRobot& each : unread_) common.add_untried(each);
  if (standers_.empty()) return;
  ResultTable table{.name = "legs",
                    .title = "Robots with legs: standing and swaying for ten seconds"};
  table.columns = {{"robot"},
                   {"task"},
                   {"mass", "kg", 1},
                   {"seeds", "", 0},
                   {"stood", "", 0},
                   {"faults", "", 0},
                   {"falls", "", 0},
                   {"sway x, y, z [mm]"},
                   {"roll, pitch, yaw [deg]"},
                   {"com_moved, worst", "mm", 1},
                   {"com_rmse, worst", "mm", 2},
                   {"turn_rmse, worst", "deg", 2},
                   {"foot_slip, worst", "mm", 1},
                   {"outcome"}};
  PublicAim aim{.what = "stands, sways and comes to rest", .where = "ground"};
  for (const Stander& stander : standers_) {
    const std::vector<RunFigures> runs = chosen(figures, stander.runs);
    for (const RunFigures& run : runs) common.add_run(stander.robot.name, "ground", "stand", run);
    if (!all_made(runs)) continue;
    aim.count(stander.robot.name, polished_of(runs) == static_cast<int>(runs.size()));
    if (const std::string reason = refusal_of(runs); !reason.empty())
      common.add_untried({stander.robot.name, "ground", reason});
    else
      table.add(cells_of(stander.robot, runs));
  }
  if (!table.rows.empty()) report.tables.push_back(std::move(table));
  common.add_aim(std::move(aim));
}

}  // namespace burnish::polishing

// Experiment robots: the default task with other robots.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/to_size.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/public_arms.hpp"
#include "polishing/experiments/public_legs.hpp"
#include "polishing/experiments/scaled_robot.hpp"
#include "robots/known_robots.hpp"

namespace burnish::polishing {
namespace {

/// Robot with the frame of its tool.
struct Holder {
  std::string robot, tool;
  double mass = 0.0;  ///< Moving mass to scale the robot to; 0: not scaled [kg].
};

/// Returns the bundled robots with the frames of their tools. For a robot that cannot hold a tool,
/// the frame is the most likely place for a tool.
std::vector<Holder> shipped() {
  return {{"talos:right_arm", "tool"}, {"talos", "tool"},        {"arm7", "tool"},
          {"arm7:six", "tool"},        {"arm7:wall", "tool"},    {"arm7", "tool", 3.0},
          {"arm7", "tool", 10.0},      {"arm7", "tool", 30.0},   {"crane:left_only", "left_tip"},
          {"crane", "right_tip"},      {"quadruped", "fl_foot"}, {"quadruped:fixed", "fl_foot"},
          {"pendulum", "tip"}};
}

struct Entry {
  Holder holder;
  std::string surface;
  std::string name = {};    ///< Name of the robot, with its size if scaled.
  std::string reason = {};  ///< Reason why the robot cannot polish, if found before the run.
  double mass = 0.0;        ///< Moving mass [kg].
  int joints = 0;
  double bandwidth = 0.0;      ///< Bandwidth of the model-error estimate [rad/s].
  std::vector<int> runs = {};  ///< Indices of the runs in the batch.
};

std::vector<Holder> holders(const ExperimentSpec& spec) {
  if (spec.robots.empty()) {
    std::vector<Holder> all = shipped();
    if (spec.quick) all = {{"arm7", "tool", 10.0}, {"pendulum", "tip"}};
    return all;
  }
  std::vector<Holder> given;
  for (std::size_t i = 0; i < spec.robots.size(); ++i)
    given.push_back({spec.robots[i], i < spec.tools.size() ? spec.tools[i] : "tool"});
  return given;
}

Robot robot_of(const Holder& holder, const Task& task) {
  Robot robot = load_task_robot(task);
  return holder.mass > 0.0 ? scaled_robot(std::move(robot), holder.mass) : robot;
}

/// Returns the run of an entry, without a seed. If the robot cannot do the task, returns nothing
/// and sets Entry::reason.
std::optional<RunSpec> run_of(const ExperimentSpec& spec, Entry& entry) {
  RunSpec run;
  run.plant = spec.plant;
  entry.name = entry.holder.robot;
  try {
    run.task = experiment_task(spec, entry.surface, "mismatch", 8.3);
    run.task.robot = entry.holder.robot;
    run.task.tool = entry.holder.tool;
    run.robot = robot_of(entry.holder, run.task);
    const Model& model = run.robot->model;
    if (entry.holder.mass > 0.0) entry.name += ", scaled";
    entry.mass = model.total_mass();
    entry.joints = model.nv;
    const Setting setting = make_setting(run.task, *run.robot);
    const ReachReport reach = check_reach(run.task, setting, run.reach);
    if (!reach.ok()) throw Error("the task is out of reach: " + reach.text);
    entry.bandwidth = make_mpc(run.task, setting).model_error.usual_bandwidth();
    return run;
  } catch (const Error& error) {
    entry.reason = error.what();
    return std::nullopt;
  }
}

ResultTable runs_table(const std::vector<Entry>& entries, const std::vector<RunFigures>& runs) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"robot"}, {"tool"}, {"surface"}, {"mass", "kg", 1}, {"seed", "", 0}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (const Entry& entry : entries)
    for (const int index : entry.runs) {
      const RunFigures& run = runs[to_size(index)];
      std::vector<ResultCell> row{entry.name, entry.holder.tool, entry.surface, entry.mass,
                                  static_cast<double>(run.seed)};
      for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
      table.add(std::move(row));
    }
  return table;
}

ResultTable summary_table(const std::vector<Entry>& entries, const std::vector<RunFigures>& runs) {
  const std::vector<SummaryColumn> summary{
      {"force_rmse", mean_of},
      {"force_rmse", largest_of, "worst"},
      {"force_peak", largest_of, "force_peak, worst"},
      {"position_rmse", mean_of},
      {"position_rmse", largest_of, "worst"},
      {"without_contact", largest_of, "without_contact, worst"}};
  ResultTable table{.name = "summary", .title = "Mean and worst over the seeds"};
  table.columns = {{"robot"},         {"tool"},           {"surface"},
                   {"mass", "kg", 1}, {"joints", "", 0},  {"bandwidth", "rad/s", 0},
                   {"seeds", "", 0},  {"polished", "", 0}};
  add_columns(summary, table);
  for (const Entry& entry : entries) {
    if (!entry.reason.empty()) continue;
    std::vector<RunFigures> all;
    for (const int index : entry.runs) all.push_back(runs[to_size(index)]);
    const auto polished =
        std::count_if(all.begin(), all.end(), [](const RunFigures& run) { return run.succeeded; });
    std::vector<ResultCell> row{entry.name,
                                entry.holder.tool,
                                entry.surface,
                                entry.mass,
                                static_cast<double>(entry.joints),
                                entry.bandwidth,
                                static_cast<double>(all.size()),
                                static_cast<double>(polished)};
    add_cells(summary, all, row);
    table.add(std::move(row));
  }
  return table;
}

ResultTable reasons_table(const std::vector<Entry>& entries) {
  ResultTable table{.name = "others", .title = "Robots that do not polish, and why"};
  table.columns = {{"robot"}, {"tool"}, {"surface"}, {"reason"}};
  for (const Entry& entry : entries)
    if (!entry.reason.empty())
      table.add({entry.name, entry.holder.tool, entry.surface, entry.reason});
  return table;
}

/// Adds a finding for each bundled robot that the experiment does not include.
void note_missing(const std::vector<Entry>& entries, ExperimentReport& report) {
  std::set<std::string> there;
  for (const Entry& entry : entries)
    there.insert(entry.holder.robot.substr(0, entry.holder.robot.find(':')));
  for (const auto& [name, file] : known_robots())
    if (!there.contains(name))
      report.findings.push_back("Robot " + name +
                                " was not tried; add it with the frame of its tool.");
}

/// Adds a finding for each robot whose description is missing in the folder.
void note_absent(const std::vector<PublicRobot>& absent, std::size_t all,
                 ExperimentReport& report) {
  report.findings.push_back(std::to_string(all - absent.size()) + " of " + std::to_string(all) +
                            " descriptions are in the folder.");
  for (const PublicRobot& robot : absent)
    report.findings.push_back("Missing: " + robot.name + ", " + robot.url() + ".");
}

/// Returns the runs that were not rejected.
std::vector<RunFigures> not_refused(const std::vector<RunFigures>& figures) {
  std::vector<RunFigures> runs;
  std::ranges::copy_if(figures, std::back_inserter(runs),
                       [](const RunFigures& run) { return !run.refused; });
  return runs;
}

ExperimentReport perform_public_robots(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Public robots with default settings"};
  PublicArms arms(spec);
  PublicLegs legs(spec);
  std::vector<BatchRun> runs;
  std::vector<PublicRobot> absent;
  const std::vector<PublicRobotFile> robots = public_robots_in(spec.folder);
  for (const auto& [robot, file] : robots) {
    if (!file)
      absent.push_back(robot);
    else if (robot.stands())
      legs.add(robot, *file, runs);
    else
      arms.add(robot, *file, runs);
  }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  if (!spec.reports()) return report;
  note_absent(absent, robots.size(), report);
  PublicReport common;
  arms.report(figures, common, report);
  legs.report(figures, common, report);
  common.write(report);
  note_failures(spec, not_refused(figures), report);
  return report;
}

}  // namespace

ExperimentReport perform_robots(const ExperimentSpec& spec) {
  if (!spec.folder.empty()) return perform_public_robots(spec);
  ExperimentReport report{.title = "The default task with other robots"};
  const std::vector<std::string> surfaces =
      spec.surfaces.empty() ? std::vector<std::string>{"table"} : spec.surfaces;
  const int seeds = spec.seeds > 0 ? spec.seeds : spec.quick ? 1 : 5;
  std::vector<Entry> entries;
  for (const Holder& holder : holders(spec))
    for (const std::string& surface : surfaces) entries.push_back({holder, surface});
  std::vector<std::optional<RunSpec>> found(entries.size());
  for_each_index(static_cast<int>(entries.size()), spec.threads, [&](int index) {
    const auto i = to_size(index);
    if (!spec.stopped || !spec.stopped()) found[i] = run_of(spec, entries[i]);
  });
  std::vector<BatchRun> runs;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (int seed = spec.first_seed; found[i] && seed < spec.first_seed + seeds; ++seed) {
      BatchRun run{entries[i].name + ", " + entries[i].surface + ", seed " + std::to_string(seed),
                   *found[i]};
      run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
      run.spec.plan_rate = 0.0;
      entries[i].runs.push_back(static_cast<int>(runs.size()));
      runs.push_back(std::move(run));
    }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  report.tables = {runs_table(entries, figures), summary_table(entries, figures)};
  if (ResultTable reasons = reasons_table(entries); !reasons.rows.empty())
    report.tables.push_back(std::move(reasons));
  const auto polished = std::count_if(figures.begin(), figures.end(),
                                      [](const RunFigures& run) { return run.succeeded; });
  report.findings.push_back(std::to_string(polished) + " of " + std::to_string(figures.size()) +
                            " runs polished.");
  // Reports a robot that cannot hold a tool as a failure only if the user named this robot.
  for (const Entry& entry : entries)
    if (!spec.robots.empty() && !entry.reason.empty())
      report.failures.push_back(entry.name + ", " + entry.surface + ": " + entry.reason);
  if (spec.robots.empty() && !spec.quick) note_missing(entries, report);
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

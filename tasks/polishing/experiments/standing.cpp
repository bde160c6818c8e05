// Experiment standing: a standing robot polishes under all presets of disturbances with many seeds,
// and is pushed.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/pushes.hpp"
#include "polishing/experiments/shipped_tasks.hpp"

namespace burnish::polishing {
namespace {

/// Case of the experiment: a bundled task file, optionally with another surface and the posture for
/// this surface.
struct StandingCase {
  const char *name, *file, *surface, *posture;
};
constexpr StandingCase standing_cases[] = {
    {"board", "standing", "", ""},
    {"table", "standing", "table", "standing_table"},
    {"two_arms", "two_arms", "", ""},  // with a fixed pelvis, for comparison
    {"two_arms_standing", "two_arms_standing", "", ""}};

constexpr const char* pushed_frame = "torso_2_link";

/// Runs that differ only in their seed.
struct StandingGroup {
  const StandingCase* what;
  std::string disturbances;
  std::vector<RunFigures> runs = {};
};

std::vector<const StandingCase*> cases_of(const ExperimentSpec& spec) {
  std::vector<const StandingCase*> all;
  if (spec.surfaces.empty()) {
    for (const StandingCase& each : standing_cases)
      if (!spec.quick || each.file == std::string("standing")) all.push_back(&each);
    if (spec.quick) all.resize(1);
    return all;
  }
  for (const std::string& surface : spec.surfaces) {
    if (surface != "board" && surface != "table")
      throw Error("surface " + in_quotes(surface) +
                  " has no standing posture; wanted board or table");
    all.push_back(&standing_cases[surface == "board" ? 0 : 1]);
  }
  return all;
}

Task task_of(const ExperimentSpec& spec, const StandingCase& what, const std::string& preset) {
  Task task = shipped_task(what.file);
  if (*what.surface != '\0') put_on(task, what.surface);
  if (*what.posture != '\0') task.posture = what.posture;
  task.disturbances = disturbance_preset(preset);
  task.polish_duration = 4.0;
  if (spec.quick) {
    task.polish_duration = 0.8;
    task.path.start_up = 0.4;
    task.reach_duration = 0.2;
    task.standing.settle = 0.2;
  }
  override_task(task, spec.overrides);
  return task;
}

std::vector<std::string> presets_of(const ExperimentSpec& spec) {
  if (spec.quick) return {"none", "mismatch"};
  return disturbance_presets();
}

/// Returns the runs of all cases and presets. Appends one group for each case and preset.
std::vector<BatchRun> preset_runs(const ExperimentSpec& spec, std::vector<StandingGroup>& groups) {
  const int seeds = seeds_of(spec, spec.quick ? 1 : 50);
  std::vector<BatchRun> runs;
  for (const StandingCase* what : cases_of(spec))
    for (const std::string& preset : presets_of(spec)) {
      groups.push_back({what, preset});
      // Without disturbances, one seed is enough: all seeds give equal results.
      const std::size_t before = runs.size();
      add_seeds(spec, std::string(what->name) + ", " + preset, task_of(spec, *what, preset),
                preset == "none" ? 1 : seeds, runs);
      groups.back().runs.resize(runs.size() - before);
    }
  return runs;
}

std::vector<ResultCell> cells_of(const RunFigures& run) {
  std::vector<ResultCell> cells{static_cast<double>(run.seed), std::string(name_of(run.fault)),
                                std::string(fell(run) ? "yes" : "no")};
  for (const char* figure : {"standing.base_tilt", "standing.com_moved", "standing.slip",
                             "standing.pressure_margin", "standing.min_load"})
    cells.emplace_back(shown(figure, run[figure]));
  for (ResultCell& cell : run_cells(run)) cells.push_back(std::move(cell));
  return cells;
}

ResultTable runs_table(const std::vector<StandingGroup>& groups,
                       const std::vector<PushDirection>& directions) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"task"},        {"disturbances"}, {"push", "N", 0}, {"towards", "deg", 0},
                   {"seed", "", 0}, {"fault"},        {"fell"}};
  for (const char* figure : {"standing.base_tilt", "standing.com_moved", "standing.slip",
                             "standing.pressure_margin", "standing.min_load"})
    table.columns.push_back(figure_column(figure));
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  const auto add = [&](std::vector<ResultCell> row, const RunFigures& run) {
    for (ResultCell& cell : cells_of(run)) row.push_back(std::move(cell));
    table.add(std::move(row));
  };
  for (const StandingGroup& group : groups)
    for (const RunFigures& run : group.runs)
      add({std::string(group.what->name), group.disturbances, ResultCell(), ResultCell()}, run);
  for (const PushDirection& direction : directions)
    for (const PushDirection::Trial& tried : direction.tried)
      add({std::string(groups.front().what->name), std::string("mismatch"), tried.force,
           direction.angle},
          tried.run);
  return table;
}

double count_of(const std::vector<RunFigures>& runs, bool (*counts)(const RunFigures& run)) {
  return static_cast<double>(std::count_if(runs.begin(), runs.end(), counts));
}

ResultTable summary_table(const std::vector<StandingGroup>& groups) {
  const std::vector<SummaryColumn> summary{{"force_rmse", mean_of},
                                           {"force_rmse", largest_of, "worst"},
                                           {"force_peak", largest_of, "force_peak, worst"},
                                           {"position_rmse", mean_of},
                                           {"position_rmse", largest_of, "worst"},
                                           {"standing.com_moved", largest_of, "com_moved, worst"}};
  ResultTable table{.name = "summary", .title = "Mean and worst over the seeds"};
  table.columns = {{"task"},         {"disturbances"}, {"seeds", "", 0}, {"polished", "", 0},
                   {"falls", "", 0}, {"faults", "", 0}};
  add_columns(summary, table);
  for (const StandingGroup& group : groups) {
    std::vector<ResultCell> row{
        std::string(group.what->name),
        group.disturbances,
        count_of(group.runs, [](const RunFigures& run) { return run.made; }),
        count_of(group.runs, [](const RunFigures& run) { return run.succeeded; }),
        count_of(group.runs, fell),
        count_of(group.runs, [](const RunFigures& run) { return run.fault != FaultKind::None; })};
    add_cells(summary, group.runs, row);
    table.add(std::move(row));
  }
  return table;
}

/// Returns a panel with the errors of all seeds in ascending order, one curve per preset.
Panel sorted_panel(const std::vector<StandingGroup>& groups, const StandingCase* what,
                   const char* figure, const char* title, const char* label) {
  Panel panel{.title = std::string(title) + ", " + what->name,
              .x_label = "fraction of the seeds [%]",
              .y_label = label};
  for (const StandingGroup& group : groups) {
    if (group.what != what) continue;
    std::vector<double> values = collect(group.runs, figure);
    values.erase(std::remove_if(values.begin(), values.end(),
                                [](double value) { return !std::isfinite(value); }),
                 values.end());
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const auto size = static_cast<Eigen::Index>(values.size());
    Curve curve{.name = group.disturbances,
                .x = Eigen::VectorXd::LinSpaced(size + 1, 0.0, 100.0),
                .y = Eigen::VectorXd(size + 1)};
    for (Eigen::Index i = 0; i <= size; ++i)
      curve.y[i] = shown(figure, values[to_size(std::min(i, size - 1))]);
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

Figure errors_figure(const std::vector<StandingGroup>& groups) {
  Figure figure{.name = "errors", .plot = {.title = "Errors of every seed", .columns = 2}};
  figure.plot.panel_width = 480;
  const StandingCase* before = nullptr;
  for (const StandingGroup& group : groups) {
    if (group.what == before) continue;
    before = group.what;
    figure.plot.panels.push_back(
        sorted_panel(groups, before, "force_rmse", "Force", "rms error [N]"));
    figure.plot.panels.push_back(
        sorted_panel(groups, before, "position_rmse", "Path", "rms error [mm]"));
  }
  return figure;
}

/// Settings and state of the search for the largest push in each direction.
struct PushPlan {
  Task task;
  double step;  ///< Resolution of the found force [N].
  std::vector<PushDirection> directions;
  /// Approximate number of runs per direction: the first push, a doubled push, and bisections.
  std::size_t expected = 6;
};

PushPlan push_plan(const ExperimentSpec& spec) {
  return {.task = task_of(spec, *cases_of(spec).front(), "mismatch"),
          .step = spec.quick ? first_push : 10.0,
          .directions = push_directions(spec.quick ? 2 : 12)};
}

/// Makes the runs that follow the first push of a direction, for all directions in the shard of
/// `spec`. These runs depend only on earlier pushes in the same direction.
void search_pushes(const ExperimentSpec& spec, PushPlan& plan, BatchSeries& series) {
  while (true) {
    std::vector<BatchRun> runs;
    std::vector<std::pair<PushDirection*, double>> of;
    for (std::size_t d = 0; d < plan.directions.size(); ++d) {
      PushDirection& direction = plan.directions[d];
      const std::optional<double> force =
          spec.shard.has(d) ? next_push(direction, plan.step) : std::nullopt;
      if (!force) continue;
      runs.push_back(push_run(spec, plan.task, pushed_frame, direction.angle, *force));
      of.emplace_back(&direction, *force);
    }
    if (runs.empty()) return;
    const std::vector<RunFigures> figures = series.run_all(runs);
    for (std::size_t i = 0; i < figures.size(); ++i)
      note_push(of[i].second, figures[i], *of[i].first);
  }
}

void note_pushes(const PushPlan& plan, ExperimentReport& report) {
  const auto survived = std::count_if(
      plan.directions.begin(), plan.directions.end(),
      [](const PushDirection& direction) { return direction.tried.front().survived; });
  report.findings.push_back(std::to_string(survived) + " of " +
                            std::to_string(plan.directions.size()) + " pushes of " +
                            number(first_push) + " N were survived.");
}

}  // namespace

ExperimentReport perform_standing(const ExperimentSpec& spec) {
  if (spec.plant != PlantKind::Mujoco)
    throw Error("the ideal plant does not support a standing robot; wanted the plant mujoco");
  ExperimentReport report{.title = "A standing robot, disturbed and pushed"};
  PushPlan plan = push_plan(spec);
  std::vector<BatchRun> runs;
  for (const PushDirection& direction : plan.directions)
    runs.push_back(push_run(spec, plan.task, pushed_frame, direction.angle, first_push));
  std::vector<StandingGroup> groups;
  for (BatchRun& run : preset_runs(spec, groups)) runs.push_back(std::move(run));
  const std::size_t pushes = plan.directions.size();
  BatchSeries series(spec, runs.size() + (plan.expected - 1) * pushes);
  const std::vector<RunFigures> figures = series.run(runs);
  if (spec.list) return report;
  std::size_t next = 0;
  for (PushDirection& direction : plan.directions)
    note_push(first_push, figures[next++], direction);
  for (StandingGroup& group : groups)
    for (RunFigures& run : group.runs) run = figures[next++];
  search_pushes(spec, plan, series);
  if (!spec.reports()) return report;
  report.tables = {runs_table(groups, plan.directions), summary_table(groups),
                   pushes_table(plan.directions)};
  report.figures = {errors_figure(groups), pushes_figure(plan.directions)};
  const std::vector<RunFigures> of_presets(figures.begin() + static_cast<long>(pushes),
                                           figures.end());
  const auto falls = static_cast<int>(count_of(of_presets, fell));
  report.findings.push_back(std::to_string(falls) + " of " + std::to_string(of_presets.size()) +
                            " runs without a push fell.");
  note_pushes(plan, report);
  note_failures(spec, of_presets, report);
  return report;
}

}  // namespace burnish::polishing

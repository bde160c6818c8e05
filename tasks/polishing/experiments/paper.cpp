// Experiment paper: the task of the paper under disturbances, for MPC and for controllers without a
// plan.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/aims.hpp"
#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {
namespace {

/// Returns the aims that the worst seed should meet under these disturbances.
std::vector<Aim> aims_under(const std::string& disturbances) {
  const double force = disturbances == "none" ? 0.05 : disturbances == "mismatch" ? 0.15 : 0.4;
  const double path = disturbances == "none" ? 0.2 : disturbances == "mismatch" ? 0.7 : 1.5;
  return {{"force_rmse", force},
          {"position_rmse", path},
          {"without_contact", 0.0},
          {"impact_peak", 45.0},
          {"largest_command", 100.0}};
}

/// Runs that differ only in their seed.
struct FigureGroup {
  std::string surface, disturbances;
  ControllerKind controller;
  std::vector<int> runs = {};  ///< Indices of the runs.
};

std::vector<RunFigures> members(const FigureGroup& group, const std::vector<RunFigures>& runs) {
  std::vector<RunFigures> result;
  for (const int index : group.runs) result.push_back(runs[to_size(index)]);
  return result;
}

ResultTable runs_table(const std::vector<FigureGroup>& groups,
                       const std::vector<RunFigures>& runs) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"surface"}, {"disturbances"}, {"controller"}, {"seed", "", 0}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (const FigureGroup& group : groups)
    for (const RunFigures& run : members(group, runs)) {
      std::vector<ResultCell> row{group.surface, group.disturbances, name_of(group.controller),
                                  static_cast<double>(run.seed)};
      for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
      table.add(std::move(row));
    }
  return table;
}

ResultTable summary_table(const std::vector<FigureGroup>& groups,
                          const std::vector<RunFigures>& runs) {
  const std::vector<SummaryColumn> summary{
      {"force_rmse", mean_of},
      {"force_rmse", largest_of, "worst"},
      {"force_peak", mean_of},
      {"force_peak", largest_of, "worst"},
      {"position_rmse", mean_of},
      {"position_rmse", largest_of, "worst"},
      {"without_contact", largest_of, "without_contact, worst"},
      {"impact_peak", mean_of},
      {"impact_peak", largest_of, "worst"},
      {"run_torque_margin", smallest_of, "run_torque_margin, worst"}};
  ResultTable table{.name = "summary", .title = "Mean and worst over the seeds"};
  table.columns = {
      {"surface"}, {"disturbances"}, {"controller"}, {"seeds", "", 0}, {"polished", "", 0}};
  add_columns(summary, table);
  for (const FigureGroup& group : groups) {
    const std::vector<RunFigures> all = members(group, runs);
    const auto polished =
        std::count_if(all.begin(), all.end(), [](const RunFigures& run) { return run.succeeded; });
    std::vector<ResultCell> row{group.surface, group.disturbances, name_of(group.controller),
                                static_cast<double>(all.size()), static_cast<double>(polished)};
    add_cells(summary, all, row);
    table.add(std::move(row));
  }
  return table;
}

ResultTable aims_table(const std::vector<FigureGroup>& groups, const std::vector<RunFigures>& runs,
                       ExperimentReport& report) {
  ResultTable table{.name = "aims", .title = "MPC compared with the aims, by the worst seed"};
  table.columns = {{"surface"}, {"disturbances"}, {"figure"},       {"unit"},
                   {"worst"},   {"aim", "", 2},   {"room", "%", 0}, {"verdict"}};
  int met = 0, all = 0;
  for (const FigureGroup& group : groups) {
    if (group.controller != ControllerKind::Mpc) continue;
    for (const Aim& aim : aims_under(group.disturbances)) {
      const double worst = worst_shown(members(group, runs), aim.figure);
      const std::string words = verdict(worst, aim);
      met += words == "met" ? 1 : 0;
      ++all;
      table.add({group.surface, group.disturbances, aim.figure,
                 std::string(figure_named(aim.figure).unit.shown), worst, aim.limit,
                 room_below(worst, aim), words});
      if (words != "met")
        report.findings.push_back(group.surface + ", " + group.disturbances + ": " + aim.figure +
                                  " " + words + ".");
    }
  }
  report.findings.insert(report.findings.begin(),
                         std::to_string(met) + " of " + std::to_string(all) + " aims are met.");
  return table;
}

constexpr ControllerKind compared[] = {ControllerKind::Mpc, ControllerKind::Baseline,
                                       ControllerKind::Admittance};

/// Returns one curve for each controller, in the controller's colour. Curves with larger errors
/// come first, so that they are drawn below the others.
std::vector<Curve> overlaid(const RunCurves* runs, Curve RunCurves::*which) {
  std::vector<Curve> result;
  for (int i = static_cast<int>(std::size(compared)) - 1; i >= 0; --i) {
    result.push_back(runs[i].*which);
    result.back().color = i;
  }
  return result;
}

/// Returns the plot of force and path for all controllers, with a row of panels per surface.
Figure force_and_path(const std::vector<std::string>& surfaces,
                      const std::vector<RunCurves>& curves) {
  Figure figure{
      .name = "force_and_path",
      .plot = {.title = "MPC, baseline and admittance, preset mismatch, first seed", .columns = 3}};
  figure.plot.panel_width = 480;
  figure.plot.panel_height = 330;
  const char* time = "time since the start of the path [s]";
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const RunCurves* const runs = &curves[std::size(compared) * i];
    Panel force{.title = "Normal force, " + surfaces[i],
                .x_label = time,
                .y_label = "force, mean over 10 ms [N]",
                .curves = overlaid(runs, &RunCurves::force)};
    Panel path{.title = "Path, " + surfaces[i],
               .x_label = "along the first tangent [mm]",
               .y_label = "along the second tangent [mm]",
               .curves = overlaid(runs, &RunCurves::path),
               .equal_aspect = true};
    path.curves.push_back(runs[0].target);
    Panel distance{.title = "Distance from the path, " + surfaces[i],
                   .x_label = time,
                   .y_label = "distance [mm]",
                   .curves = overlaid(runs, &RunCurves::distance)};
    for (Panel* panel : {&force, &path, &distance}) figure.plot.panels.push_back(std::move(*panel));
  }
  return figure;
}

}  // namespace

ExperimentReport perform_paper(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "MPC, baseline and admittance on the paper's task"};
  const std::vector<std::string> surfaces =
      spec.surfaces.empty() ? std::vector<std::string>{"table", "board"} : spec.surfaces;
  const int seeds = seeds_of(spec, spec.quick ? 1 : 5);
  std::vector<FigureGroup> groups;
  std::vector<BatchRun> runs;
  for (const std::string& surface : surfaces)
    for (const char* disturbances : {"none", "mismatch", "joint_friction"})
      for (const ControllerKind controller : compared) {
        groups.push_back({surface, disturbances, controller});
        // Without disturbances, one seed is enough: all seeds give equal results.
        const int count = disturbances == std::string("none") ? 1 : seeds;
        for (int seed = spec.first_seed; seed < spec.first_seed + count; ++seed) {
          BatchRun run;
          run.name = surface + ", " + disturbances + ", " + name_of(controller) + ", seed " +
                     std::to_string(seed);
          run.spec.task = experiment_task(spec, surface, disturbances, 12.6);
          run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
          run.spec.controller = controller;
          run.spec.plant = spec.plant;
          if (disturbances == std::string("mismatch") && seed == spec.first_seed)
            run.curves = name_of(controller);
          groups.back().runs.push_back(static_cast<int>(runs.size()));
          runs.push_back(std::move(run));
        }
      }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  // Curves of every surface, in the order of the controllers in `compared`.
  std::vector<RunCurves> curves;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!runs[i].curves.empty()) curves.push_back(figures[i].curves.value_or(RunCurves{}));
  report.tables = {runs_table(groups, figures), summary_table(groups, figures)};
  report.tables.push_back(aims_table(groups, figures, report));
  report.figures = {force_and_path(surfaces, curves)};
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

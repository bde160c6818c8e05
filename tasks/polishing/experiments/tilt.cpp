// Experiment tilt: the surface is tilted by a few degrees, which the controller does not model.
// Runs with and without a torque loop are compared.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "polishing/experiments/aims.hpp"
#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {
namespace {

/// Returns the task of the experiment in Kleff et al., "Force Feedback in Model-Predictive
/// Control": 50 N at 3 rad/s, plans that are 5 ms late, joint friction, torque factors and offsets,
/// noise on states.
Task task_of(const ExperimentSpec& spec, const std::string& surface, double tilt, bool loop) {
  ExperimentSpec whole = spec;
  whole.overrides = {"force=50", "path.rate=3", "controller.update_rate=200",
                     "controller.solver_delay=0.005", "surface.stiffness=10000"};
  whole.overrides.insert(whole.overrides.end(), spec.overrides.begin(), spec.overrides.end());
  Task task = experiment_task(whole, surface, "none", 6.0);
  Disturbances d;
  d.torque_scale_range = 0.2;
  d.torque_bias_range = 2.0;
  d.torque_noise = 0.03;
  d.joint_coulomb = 1.0;
  d.joint_viscous = 0.5;
  d.position_noise = d.velocity_noise = 1e-3;
  d.surface_friction = 0.5;
  d.surface_tilt_deg = {tilt, 0.0};
  d.torque_loop = loop;
  task.disturbances = d;
  return task;
}

struct TiltGroup {
  bool loop;
  double tilt;  ///< Tilt of the surface [deg].
  std::vector<RunFigures> runs = {};
};

ResultTable runs_table(const std::vector<TiltGroup>& groups) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"torque loop"}, {"tilt", "deg", 0}, {"seed", "", 0}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (const TiltGroup& group : groups)
    for (const RunFigures& run : group.runs) {
      std::vector<ResultCell> row{std::string(group.loop ? "on" : "off"), group.tilt,
                                  static_cast<double>(run.seed)};
      for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
      table.add(std::move(row));
    }
  return table;
}

ResultTable summary_table(const std::vector<TiltGroup>& groups) {
  const std::vector<SummaryColumn> summary{
      {"force_rmse", mean_of},
      {"force_rmse", largest_of, "worst seed"},
      {"force_peak", largest_of, "force_peak, worst"},
      {"position_rmse", mean_of},
      {"position_rmse", largest_of, "worst seed"},
      {"normal_error", mean_of},
      {"without_contact", largest_of, "without_contact, worst"}};
  ResultTable table{.name = "summary", .title = "Mean and worst over the seeds"};
  table.columns = {{"torque loop"}, {"tilt", "deg", 0}, {"seeds", "", 0}, {"polished", "", 0}};
  add_columns(summary, table);
  for (const TiltGroup& group : groups) {
    const auto polished = std::count_if(group.runs.begin(), group.runs.end(),
                                        [](const RunFigures& run) { return run.succeeded; });
    std::vector<ResultCell> row{std::string(group.loop ? "on" : "off"), group.tilt,
                                static_cast<double>(group.runs.size()),
                                static_cast<double>(polished)};
    add_cells(summary, group.runs, row);
    table.add(std::move(row));
  }
  return table;
}

/// Returns a table of errors with their aims. Errors are averaged over the seeds. The table has the
/// mean and the worst error over the tilts, as in the paper by Kleff et al.
ResultTable aims_table(const std::vector<TiltGroup>& groups, ExperimentReport& report) {
  struct Criterion {
    const char* figure;
    bool mean;
    double limits[2];  ///< Largest acceptable error with and without the torque loop.
  };
  const Criterion all[] = {{"force_rmse", true, {0.4, 0.8}},
                           {"force_rmse", false, {0.6, 1.2}},
                           {"position_rmse", true, {0.3, 0.4}}};
  ResultTable table{.name = "aims", .title = "Comparison with the aims"};
  table.columns = {{"torque loop"}, {"figure"},     {"over the tilts"}, {"unit"},
                   {"value"},       {"aim", "", 2}, {"room", "%", 0},   {"verdict"}};
  int met = 0, count = 0;
  for (const bool loop : {true, false})
    for (const Criterion& held : all) {
      std::vector<double> means;
      for (const TiltGroup& group : groups) {
        if (group.loop != loop) continue;
        double sum = 0.0;
        for (const RunFigures& run : group.runs) sum += shown(held.figure, run[held.figure]);
        means.push_back(sum / static_cast<double>(group.runs.size()));
      }
      double value = 0.0;
      for (const double mean : means)
        value = held.mean ? value + mean / static_cast<double>(means.size())
                          : (std::isnan(value) || mean <= value ? value : mean);
      const Aim aim{held.figure, held.limits[loop ? 0 : 1]};
      const std::string words = verdict(value, aim);
      met += words == "met" ? 1 : 0;
      ++count;
      table.add({std::string(loop ? "on" : "off"), aim.figure,
                 std::string(held.mean ? "mean" : "worst"),
                 std::string(figure_named(aim.figure).unit.shown), value, aim.limit,
                 room_below(value, aim), words});
    }
  report.findings.push_back(std::to_string(met) + " of " + std::to_string(count) +
                            " aims are met.");
  return table;
}

Figure force_over_tilt(const std::vector<TiltGroup>& groups) {
  Figure figure{.name = "force_over_tilt",
                .plot = {.title = "Force error over the tilt", .columns = 1}};
  Panel panel{.x_label = "tilt [deg]", .y_label = "force, rms error, mean of the seeds [N]"};
  for (const bool loop : {true, false}) {
    std::vector<double> x, y;
    for (const TiltGroup& group : groups) {
      if (group.loop != loop) continue;
      x.push_back(group.tilt);
      y.push_back(mean_of(collect(group.runs, "force_rmse")));
    }
    const auto size = static_cast<Eigen::Index>(x.size());
    Curve curve{.name = loop ? "torque loop" : "without torque loop",
                .x = Eigen::Map<Eigen::VectorXd>(x.data(), size),
                .y = Eigen::Map<Eigen::VectorXd>(y.data(), size)};
    curve.color = loop ? 0 : 1;
    panel.curves.push_back(std::move(curve));
  }
  figure.plot.panels = {std::move(panel)};
  return figure;
}

}  // namespace

ExperimentReport perform_tilt(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "A tilted surface that the controller does not model"};
  const std::string surface = spec.surfaces.empty() ? "table" : spec.surfaces.front();
  const std::vector<double> tilts = spec.quick
                                        ? std::vector<double>{-6.0, 0.0}
                                        : std::vector<double>{-6.0, -4.0, -2.0, 0.0, 2.0, 4.0, 6.0};
  const int seeds = seeds_of(spec, spec.quick ? 1 : 10);
  std::vector<TiltGroup> groups;
  std::vector<BatchRun> runs;
  for (const bool loop : {true, false})
    for (const double tilt : tilts) {
      groups.push_back({loop, tilt});
      add_seeds(spec,
                std::string(loop ? "torque loop, " : "no torque loop, ") +
                    std::to_string(static_cast<int>(tilt)) + " degrees",
                task_of(spec, surface, tilt, loop), seeds, runs);
    }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  if (!spec.reports()) return report;
  for (std::size_t i = 0; i < figures.size(); ++i)
    groups[i / to_size(seeds)].runs.push_back(figures[i]);
  report.tables = {runs_table(groups), summary_table(groups)};
  report.tables.push_back(aims_table(groups, report));
  report.figures = {force_over_tilt(groups)};
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

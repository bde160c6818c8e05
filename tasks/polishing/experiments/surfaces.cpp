// Experiment surfaces: curved surfaces with accurate and inaccurate models, soft and stiff
// surfaces, and control without a force sensor.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "polishing/experiments/aims.hpp"
#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {
namespace {

using Overrides = std::vector<std::string>;

/// Surface and disturbances of a case, with the runs of the case.
struct SurfaceCase {
  std::string group, name;
  std::string disturbances;  ///< Name of a preset.
  Overrides overrides;
  double aim;  ///< Largest acceptable rms error of the force, for the worst seed [N].
  std::vector<RunFigures> runs = {};
};

struct NamedShape {
  std::string name;
  Overrides overrides;
};

/// Returns one shape of each kind except the ridge, which the experiment force_test covers.
std::vector<NamedShape> shapes() {
  const auto tube = [](const std::string& radius, const std::string& ring) {
    return Overrides{"shape.kind=torus", "shape.radius=" + radius, "shape.ring=" + ring};
  };
  const auto round = [](const std::string& kind, const std::string& radius) {
    return Overrides{"shape.kind=" + kind, "shape.radius=" + radius};
  };
  return {{"plane", {}},
          {"sphere, 0.2 m", round("sphere", "0.2")},
          {"sphere, 1 m", round("sphere", "1")},
          {"hollow sphere, 0.4 m", {"shape.kind=sphere", "shape.radius=0.4", "shape.hollow=true"}},
          {"cylinder, 0.2 m", round("cylinder", "0.2")},
          {"cone, 0.3 m", round("cone", "0.3")},
          {"torus, 0.2 m along 0.4 m", tube("0.2", "0.4")},
          {"ellipsoid of 0.4, 0.3 and 0.3 m", {"shape.kind=ellipsoid"}},
          {"saddle of 2 and -3 1/m", {"shape.kind=saddle", "shape.curvature=[2,-3]"}}};
}

std::vector<SurfaceCase> all_cases() {
  std::vector<SurfaceCase> cases;
  for (const NamedShape& shape : shapes())
    cases.push_back({"known", shape.name, "mismatch", shape.overrides, 0.2});
  for (const NamedShape& shape : shapes()) {
    SurfaceCase unknown{"6 degrees, 5 mm, 20 % off", shape.name, "mismatch", shape.overrides, 0.6};
    unknown.overrides.insert(unknown.overrides.end(), {"disturbances.surface_tilt_deg=[4.2,-4.2]",
                                                       "disturbances.surface_height=0.005",
                                                       "disturbances.surface_curvature=1.2"});
    cases.push_back(std::move(unknown));
  }
  for (const std::string stiffness : {"0.5", "2", "10", "100", "300", "1000"})
    cases.push_back({"stiffness",
                     stiffness + " kN/m",
                     "mismatch",
                     {"surface.stiffness=" + stiffness + "e3"},
                     0.13});
  for (const std::string preset : {"mismatch", "joint_friction"})
    cases.push_back({"no force sensor", preset, preset, {"controller.force_sensor=false"}, 1.5});
  return cases;
}

/// Returns the first case of each group. Skips the softest surface, because the tip needs seconds
/// to sink into it.
std::vector<SurfaceCase> quick_cases() {
  std::vector<SurfaceCase> some;
  for (const SurfaceCase& one : all_cases()) {
    const bool is_first = some.empty() || some.back().group != one.group;
    if (is_first && one.name != "0.5 kN/m") some.push_back(one);
  }
  return some;
}

Task task_of(const ExperimentSpec& spec, const std::string& surface, const SurfaceCase& of) {
  ExperimentSpec whole = spec;
  whole.overrides = of.overrides;
  whole.overrides.insert(whole.overrides.end(), spec.overrides.begin(), spec.overrides.end());
  return experiment_task(whole, surface, of.disturbances, 6.0);
}

ResultTable runs_table(const std::vector<SurfaceCase>& cases) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"group"}, {"surface"}, {"seed", "", 0}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (const SurfaceCase& of : cases)
    for (const RunFigures& run : of.runs) {
      std::vector<ResultCell> row{of.group, of.name, static_cast<double>(run.seed)};
      for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
      table.add(std::move(row));
    }
  return table;
}

/// Returns the force error of the worst seed; NaN if a run lacks a force error.
double worst_force(const SurfaceCase& of) {
  double worst = 0.0;
  for (const RunFigures& run : of.runs) {
    const double force = shown("force_rmse", run["force_rmse"]);
    worst = std::isnan(worst) || force <= worst ? worst : force;
  }
  return worst;
}

ResultTable aims_table(const std::vector<SurfaceCase>& cases, ExperimentReport& report) {
  const std::vector<SummaryColumn> summary{
      {"force_rmse", mean_of},
      {"force_peak", largest_of, "force_peak, worst"},
      {"position_rmse", largest_of, "position_rmse, worst"},
      {"normal_error", largest_of, "normal_error, worst"},
      {"without_contact", largest_of, "without_contact, worst"}};
  ResultTable table{.name = "aims", .title = "Comparison with the aims, by the worst seed"};
  table.columns = {{"group"}, {"surface"}, {"seeds", "", 0}, {"polished", "", 0}};
  add_columns(summary, table);
  for (const ResultColumn& column : std::vector<ResultColumn>{
           {"force_rmse, worst", "N", 3}, {"aim", "N", 2}, {"room", "%", 0}, {"verdict"}})
    table.columns.push_back(column);
  int met = 0;
  for (const SurfaceCase& of : cases) {
    const auto polished = std::count_if(of.runs.begin(), of.runs.end(),
                                        [](const RunFigures& run) { return run.succeeded; });
    std::vector<ResultCell> row{of.group, of.name, static_cast<double>(of.runs.size()),
                                static_cast<double>(polished)};
    add_cells(summary, of.runs, row);
    const double worst = worst_force(of);
    const Aim aim{"force_rmse", of.aim};
    const std::string words = verdict(worst, aim);
    met += words == "met" ? 1 : 0;
    row.insert(row.end(), {worst, aim.limit, room_below(worst, aim), words});
    table.add(std::move(row));
  }
  report.findings.push_back(std::to_string(met) + " of " + std::to_string(cases.size()) +
                            " aims are met.");
  return table;
}

Figure force_of_cases(const std::vector<SurfaceCase>& cases) {
  Figure figure{.name = "force_of_surfaces",
                .plot = {.title = "Force error on each surface", .columns = 1}};
  Panel panel{.x_label = "row of the table", .y_label = "force, rms error, every seed [N]"};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i == 0 || cases[i].group != cases[i - 1].group)
      panel.curves.push_back({.name = cases[i].group, .x = {}, .y = {}});
    Curve& curve = panel.curves.back();
    curve.color = static_cast<int>(panel.curves.size()) - 1;
    for (const RunFigures& run : cases[i].runs) {
      const Eigen::Index n = curve.x.size();
      curve.x.conservativeResize(n + 1);
      curve.y.conservativeResize(n + 1);
      curve.x[n] = static_cast<double>(i + 1);
      curve.y[n] = shown("force_rmse", run["force_rmse"]);
    }
  }
  figure.plot.panels = {std::move(panel)};
  return figure;
}

}  // namespace

ExperimentReport perform_surfaces(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Curved, inaccurate, soft and stiff surfaces"};
  const std::string surface = spec.surfaces.empty() ? "table" : spec.surfaces.front();
  std::vector<SurfaceCase> cases = spec.quick ? quick_cases() : all_cases();
  const int seeds = seeds_of(spec, spec.quick ? 1 : 5);
  std::vector<BatchRun> runs;
  for (const SurfaceCase& of : cases) {
    add_seeds(spec, of.group + ", " + of.name, task_of(spec, surface, of), seeds, runs);
  }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  if (!spec.reports()) return report;
  for (std::size_t i = 0; i < figures.size(); ++i)
    cases[i / to_size(seeds)].runs.push_back(figures[i]);
  report.tables = {runs_table(cases), aims_table(cases, report)};
  report.figures = {force_of_cases(cases)};
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

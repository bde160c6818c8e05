// Experiment frames: compares contact and force in axes of the tool with contact and force in axes
// of the surface. The two differ as soon as the tool is tilted.
#include <cmath>
#include <limits>

#include "base/to_size.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/plate.hpp"

namespace burnish::polishing {
namespace {

/// Preset of disturbances, and kind of the model-error estimate. No kind can correct wrong axes of
/// the force, because the measured force along the assumed normal counts as correct.
struct Circumstance {
  const char* name;
  const char* disturbances;
  ModelErrorKind model_error;
};

constexpr Circumstance circumstances[] = {{"ideal", "none", ModelErrorKind::None},
                                          {"mismatch", "mismatch", ModelErrorKind::Torque}};

/// Runs on one surface under one circumstance: for each rotation weight, one run with axes of the
/// surface and one with axes of the tool.
struct Sweep {
  std::string surface;
  const Circumstance* circumstance;
  std::vector<double> weights;
  std::vector<RunFigures> in_surface = {}, in_local = {};
};

std::vector<double> weights_of(bool quick) {
  if (quick) return {100.0, 0.0};
  return {1e3, 1e2, 1e1, 1.0, 1e-1, 1e-2, 1e-3, 0.0};
}

BatchRun run_of(const ExperimentSpec& spec, const Sweep& sweep, double weight, ForceAxes axes) {
  BatchRun run;
  char text[32];
  std::snprintf(text, sizeof text, "%g", weight);
  run.name = sweep.surface + ", " + sweep.circumstance->name + ", rotation " + text + ", " +
             (axes == ForceAxes::Local ? "local" : "surface");
  // 8.5 s is the duration of one turn of the circle.
  run.spec.task = experiment_task(spec, sweep.surface, sweep.circumstance->disturbances, 8.5);
  Task& task = run.spec.task;
  task.disturbances.seed = static_cast<std::uint64_t>(spec.first_seed);
  task.model_error.kind = sweep.circumstance->model_error;
  task.weights.rotation = weight;
  task.axes = axes;
  // Removes the force limits, because an almost rigid wrist hits the surface during the retreat.
  // With the limits, this would end the run.
  task.tool_limits.force = task.tool_limits.unexpected_force =
      std::numeric_limits<double>::infinity();
  // Disables the verdict, because runs with bad weights are part of the sweep.
  task.verdict = {.contact_share = 0.0,
                  .force_rmse = std::numeric_limits<double>::infinity(),
                  .path_share = 0.0};
  run.spec.plant = spec.plant;
  return run;
}

/// Results of the experiment: runs on fixed surfaces and, with MuJoCo, runs on a plate held by the
/// other hand.
struct Parts {
  std::vector<Sweep> sweeps;
  std::vector<PlateCase> plate;
};

Parts perform_parts(const ExperimentSpec& spec, std::vector<RunFigures>& figures) {
  const std::vector<std::string> surfaces =
      spec.surfaces.empty() ? std::vector<std::string>{"table", "board"} : spec.surfaces;
  std::vector<Sweep> sweeps;
  std::vector<BatchRun> runs;
  for (const std::string& surface : surfaces)
    for (const Circumstance& circumstance : circumstances) {
      sweeps.push_back({surface, &circumstance, weights_of(spec.quick)});
      for (const double weight : sweeps.back().weights)
        for (const ForceAxes axes : {ForceAxes::Surface, ForceAxes::Local})
          runs.push_back(run_of(spec, sweeps.back(), weight, axes));
    }
  std::vector<PlateCase> plate;
  if (spec.surfaces.empty() && spec.plant == PlantKind::Mujoco) plate = add_plate(spec, runs);
  figures = run_batch(spec, runs);
  std::size_t next = 0;
  for (Sweep& sweep : sweeps)
    for (std::size_t i = 0; i < sweep.weights.size(); ++i) {
      sweep.in_surface.push_back(figures[next++]);
      sweep.in_local.push_back(figures[next++]);
    }
  return {std::move(sweeps), std::move(plate)};
}

ResultTable runs_table(const Parts& parts, const std::vector<RunFigures>& figures) {
  ResultTable table{.name = "runs", .title = "Every run", .for_people = false};
  table.columns = {{"surface"}, {"circumstance"}, {"axes"}, {"rotation weight", "1/rad^2", 4}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (const Sweep& sweep : parts.sweeps)
    for (std::size_t i = 0; i < sweep.weights.size(); ++i)
      for (const bool local : {false, true}) {
        std::vector<ResultCell> row{sweep.surface, std::string(sweep.circumstance->name),
                                    std::string(local ? "local" : "surface"), sweep.weights[i]};
        for (ResultCell& cell : run_cells(local ? sweep.in_local[i] : sweep.in_surface[i]))
          row.push_back(std::move(cell));
        table.add(std::move(row));
      }
  for (const PlateCase& each : parts.plate)
    for (const std::size_t index : each.runs) {
      std::vector<ResultCell> row{figures[index].name, std::string("mismatch"),
                                  std::string(text_of(each.axes)), ResultCell()};
      for (ResultCell& cell : run_cells(figures[index])) row.push_back(std::move(cell));
      table.add(std::move(row));
    }
  return table;
}

ResultTable pairs_table(const std::vector<Sweep>& sweeps) {
  ResultTable table{.name = "axes", .title = "Axes of the surface and of the tool"};
  const std::vector<std::string> compared{"force_rmse", "force_error_mean", "position_rmse",
                                          "orientation_drift"};
  table.columns = {{"surface"}, {"circumstance"}, {"rotation weight", "1/rad^2", 3}};
  for (const std::string& figure : compared) {
    table.columns.push_back(figure_column(figure, figure + ", surface"));
    table.columns.push_back(figure_column(figure, "local"));
  }
  for (const Sweep& sweep : sweeps)
    for (std::size_t i = 0; i < sweep.weights.size(); ++i) {
      std::vector<ResultCell> row{sweep.surface, std::string(sweep.circumstance->name),
                                  sweep.weights[i]};
      for (const std::string& figure : compared)
        for (const RunFigures* run : {&sweep.in_surface[i], &sweep.in_local[i]})
          row.emplace_back(shown(figure, (*run)[figure]));
      table.add(std::move(row));
    }
  return table;
}

/// Returns the position of a weight on the logarithmic axis: its power of ten. Zero is drawn a
/// decade below the smallest other weight.
double place_of(double weight) { return weight > 0.0 ? std::log10(weight) : -4.0; }

Curve curve_of(const std::string& name, const Sweep& sweep, const std::vector<RunFigures>& runs,
               const char* figure, int color) {
  const auto size = static_cast<Eigen::Index>(runs.size());
  Curve curve{.name = name, .x = Eigen::VectorXd(size), .y = Eigen::VectorXd(size), .color = color};
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto at = to_size(i);
    curve.x[i] = place_of(sweep.weights[at]);
    curve.y[i] = shown(figure, runs[at][figure]);
  }
  return curve;
}

/// Returns the plot of force errors and tool rotations, with a column of panels per surface.
Figure error_figure(const std::vector<Sweep>& sweeps) {
  const char* axis = "rotation weight [power of ten; -4 means 0]";
  constexpr std::size_t rows = std::size(circumstances);
  const std::size_t surfaces = sweeps.size() / rows;
  Figure figure{.name = "errors", .plot = {.title = "Contact and force in two kinds of axes"}};
  figure.plot.columns = static_cast<int>(surfaces);
  figure.plot.panel_width = 560;
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t s = 0; s < surfaces; ++s) {
      const Sweep& sweep = sweeps[s * rows + std::min(row, rows - 1)];
      Panel panel{.x_label = axis};
      if (row < rows) {
        panel.title = "Force, " + sweep.surface + ", " + sweep.circumstance->name;
        panel.y_label = "rms error [N]";
        panel.log_y = true;
        panel.curves = {curve_of("local axes", sweep, sweep.in_local, "force_rmse", 1),
                        curve_of("surface axes", sweep, sweep.in_surface, "force_rmse", 0)};
      } else {
        panel.title = "Rotation of the tool, " + sweep.surface + ", " + sweep.circumstance->name;
        panel.y_label = "largest [deg]";
        panel.curves = {curve_of("local axes", sweep, sweep.in_local, "orientation_drift", 1),
                        curve_of("surface axes", sweep, sweep.in_surface, "orientation_drift", 0)};
      }
      figure.plot.panels.push_back(std::move(panel));
    }
  return figure;
}

}  // namespace

ExperimentReport perform_frames(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Effect of the contact frame"};
  std::vector<RunFigures> figures;
  const Parts parts = perform_parts(spec, figures);
  if (!spec.reports()) return report;
  const std::vector<Sweep>& sweeps = parts.sweeps;
  report.tables = {runs_table(parts, figures), pairs_table(sweeps)};
  report.figures = {error_figure(sweeps)};
  for (const Sweep& sweep : sweeps) {
    const auto worst = [](const std::vector<RunFigures>& runs) {
      return largest_of(collect(runs, "force_rmse"));
    };
    char text[200];
    std::snprintf(text, sizeof text,
                  "%s, %s: over all weights, the force error is at most %.2f N in "
                  "axes of the surface and %.2f N in axes of the tool.",
                  sweep.surface.c_str(), sweep.circumstance->name, worst(sweep.in_surface),
                  worst(sweep.in_local));
    report.findings.push_back(text);
  }
  if (!parts.plate.empty()) report.tables.push_back(plate_table(parts.plate, figures, report));
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

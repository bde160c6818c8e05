// Experiment seeds: all disturbances at once, over many seeds.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/to_size.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/aims.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/disturbance_ranges.hpp"

namespace burnish::polishing {
namespace {

// Limits of rms errors, chosen by hand. A run above a limit counts as diverged; so does a run that
// did not polish or whose trace is not finite.
constexpr double diverged_force = 5.0;      // rms error of the force [N]
constexpr double diverged_position = 0.02;  // rms error of the position [m]

bool diverged(const RunFigures& run) {
  if (!run.made) return false;
  return !run.succeeded || !run.finite || !(run["force_rmse"] <= diverged_force) ||
         !(run["position_rmse"] <= diverged_position);
}

std::vector<std::string> surfaces_of(const ExperimentSpec& spec) {
  return spec.surfaces.empty() ? std::vector<std::string>{"table", "board"} : spec.surfaces;
}

std::string surface_of(const ExperimentSpec& spec, int seed) {
  const std::vector<std::string> surfaces = surfaces_of(spec);
  return surfaces[to_size(seed) % surfaces.size()];
}

/// Returns the task of a seed. Drawn disturbances replace overrides of the same keys. `undrawn`:
/// cache of the tasks without drawn disturbances, by name of the surface.
Task task_of(const ExperimentSpec& spec, int seed, std::map<std::string, Task>& undrawn) {
  const std::string surface = surface_of(spec, seed);
  if (!undrawn.contains(surface))
    undrawn.emplace(surface, experiment_task(spec, surface, "none", 4.0));
  Task task = undrawn.at(surface);
  const NamedRanges& ranges = ranges_named(spec.ranges);
  draw_disturbances(ranges.ranges, static_cast<std::uint64_t>(seed), task);
  // Successive seeds cycle through the surfaces. The shape changes after each full cycle.
  const std::size_t turn = to_size(seed) / surfaces_of(spec).size();
  if (!ranges.shapes.empty()) task.shape = ranges.shapes[turn % ranges.shapes.size()];
  return task;
}

ResultTable runs_table(const ExperimentSpec& spec, const std::vector<BatchRun>& runs,
                       const std::vector<RunFigures>& figures) {
  ResultTable table{.name = "runs", .title = "Every seed", .for_people = false};
  table.columns = {{"seed", "", 0},
                   {"surface"},
                   {"diverged"},
                   {"finite"},
                   {"fault"},
                   {"torque scale range", "", 3},
                   {"torque bias range", "Nm"},
                   {"torque noise", "Nm"},
                   {"command delay", "ms"},
                   {"solver delay", "ms"},
                   {"joint coulomb", "Nm"},
                   {"joint viscous", "Nms/rad"},
                   {"encoder", "bit", 0},
                   {"velocity cutoff", "rad/s", 0},
                   {"mass scale", "", 3},
                   {"surface friction", "", 3},
                   {"tilt about the first tangent", "deg", 2},
                   {"about the second", "deg", 2},
                   {"surface height", "mm", 2},
                   {"push", "N", 2},
                   {"shape"},
                   {"surface curvature", "", 3}};
  for (const ResultColumn& column : run_columns()) table.columns.push_back(column);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Task& task = runs[i].spec.task;
    const Disturbances& d = task.disturbances;
    const RunFigures& run = figures[i];
    std::vector<ResultCell> row{static_cast<double>(d.seed),
                                surface_of(spec, static_cast<int>(d.seed)),
                                std::string(diverged(run) ? "yes" : "no"),
                                std::string(run.finite ? "yes" : "no"),
                                std::string(name_of(run.fault)),
                                d.torque_scale_range,
                                d.torque_bias_range,
                                d.torque_noise,
                                1e3 * d.command_delay,
                                1e3 * task.solver_delay,
                                d.joint_coulomb,
                                d.joint_viscous,
                                static_cast<double>(d.encoder_bits),
                                d.velocity_cutoff,
                                d.mass_scale,
                                d.surface_friction.value_or(0.0),
                                d.surface_tilt_deg[0],
                                d.surface_tilt_deg[1],
                                1e3 * d.surface_height,
                                d.pushes.front().force_world.norm(),
                                task.shape.text(),
                                d.surface_curvature};
    for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
    table.add(std::move(row));
  }
  return table;
}

ResultTable statistics_table(const std::vector<RunFigures>& figures) {
  ResultTable table{.name = "statistics", .title = "Over all seeds"};
  table.columns = {{"figure"}, {"median"}, {"95 %"}, {"worst"}};
  for (const std::string figure : {"force_rmse", "force_peak", "position_rmse", "without_contact",
                                   "impact_peak", "run_limited_torque"}) {
    const std::vector<double> values = collect(figures, figure);
    table.add({figure + " [" + figure_named(figure).unit.shown + "]",
               shown(figure, quantile_of(values, 0.5)), shown(figure, quantile_of(values, 0.95)),
               shown(figure, largest_of(values))});
  }
  return table;
}

ResultTable aims_table(const ExperimentSpec& spec, const std::vector<RunFigures>& figures,
                       ExperimentReport& report) {
  const NamedRanges& ranges = ranges_named(spec.ranges);
  ResultTable table{.name = "aims", .title = "Comparison with the aims"};
  table.columns = {{"figure"},     {"over the seeds"}, {"unit"},   {"value"},
                   {"aim", "", 2}, {"room", "%", 0},   {"verdict"}};
  const auto add = [&](const Aim& aim, const char* over, double value) {
    table.add({aim.figure, std::string(over), std::string(figure_named(aim.figure).unit.shown),
               value, aim.limit, room_below(value, aim), verdict(value, aim)});
  };
  add({"force_rmse", ranges.median_force}, "median",
      shown("force_rmse", quantile_of(collect(figures, "force_rmse"), 0.5)));
  add({"force_rmse", ranges.worst_force}, "worst", worst_shown(figures, "force_rmse"));
  add({"without_contact", 0.0}, "worst", worst_shown(figures, "without_contact"));
  const auto faults = std::count_if(figures.begin(), figures.end(), [](const RunFigures& run) {
    return run.made && run.fault != FaultKind::None;
  });
  report.findings.push_back(std::to_string(faults) +
                            " runs ended with a fault; the surfaces were " + ranges.summary + ".");
  return table;
}

ResultTable outcomes_table(const std::vector<RunFigures>& figures) {
  ResultTable table{.name = "outcomes", .title = "How the runs ended"};
  table.columns = {{"outcome"}, {"runs", "", 0}};
  double polished = 0.0, not_finite = 0.0, strayed = 0.0;
  std::map<std::string, double> faults, others;
  for (const RunFigures& run : figures) {
    if (!run.made) continue;
    polished += run.succeeded ? 1.0 : 0.0;
    not_finite += run.finite ? 0.0 : 1.0;
    strayed += diverged(run) ? 1.0 : 0.0;
    if (run.fault != FaultKind::None)
      faults["fault: " + std::string(name_of(run.fault))] += 1.0;
    else if (!run.succeeded)
      // Omits the details after the colon, because they differ between runs.
      others[run.outcome.substr(0, run.outcome.find(':'))] += 1.0;
  }
  table.add({std::string("polished"), polished});
  for (const auto& [name, count] : faults) table.add({name, count});
  for (const auto& [name, count] : others) table.add({name, count});
  table.add({std::string("NaN or infinity in the trace"), not_finite});
  table.add({std::string("diverged (not polished, or rms errors above 5 N or 20 mm)"), strayed});
  return table;
}

/// Returns the cumulative distribution [%] of the finite `values`, over values times `scale`.
Curve distribution(std::vector<double> values, double scale) {
  values.erase(std::remove_if(values.begin(), values.end(),
                              [](double value) { return !std::isfinite(value); }),
               values.end());
  std::sort(values.begin(), values.end());
  const auto size = static_cast<Eigen::Index>(values.size());
  Curve curve{.x = Eigen::VectorXd(size), .y = Eigen::VectorXd(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    curve.x[i] = scale * values[to_size(i)];
    curve.y[i] = 100.0 * static_cast<double>(i + 1) / static_cast<double>(size);
  }
  return curve;
}

/// Returns short horizontal lines of length `width` that mark the points (x, y) of all runs.
Curve marks(const std::vector<double>& x, const std::vector<double>& y, double width) {
  const auto size = static_cast<Eigen::Index>(x.size());
  Curve curve{.x = Eigen::VectorXd(3 * size), .y = Eigen::VectorXd(3 * size)};
  curve.y.setConstant(std::numeric_limits<double>::quiet_NaN());
  curve.x.setZero();
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto at = to_size(i);
    curve.x.segment<2>(3 * i) = Eigen::Vector2d(x[at] - 0.5 * width, x[at] + 0.5 * width);
    curve.y.segment<2>(3 * i).setConstant(y[at]);
  }
  return curve;
}

Figure distributions(const std::vector<BatchRun>& runs, const std::vector<RunFigures>& figures) {
  Figure figure{
      .name = "distributions",
      .plot = {.title = "Distributions of errors, and force error over the tilt of the surface",
               .columns = 2}};
  figure.plot.panel_width = 460;
  const auto add = [&](const char* title, const char* label, const char* value) {
    Panel panel{.title = title, .x_label = label, .y_label = "runs [%]"};
    panel.curves = {distribution(collect(figures, value), shown(value, 1.0))};
    figure.plot.panels.push_back(std::move(panel));
  };
  add("Force", "rms error [N]", "force_rmse");
  add("Path", "rms error [mm]", "position_rmse");
  add("Impact", "largest force [N]", "impact_peak");
  std::vector<double> tilts;
  for (const BatchRun& run : runs)
    tilts.push_back(run.spec.task.disturbances.surface_tilt_deg.norm());
  Panel tilt{.title = "Force over the tilt of the surface",
             .x_label = "tilt [deg]",
             .y_label = "rms error [N]"};
  tilt.curves = {marks(tilts, collect(figures, "force_rmse"), 0.06)};
  figure.plot.panels.push_back(std::move(tilt));
  return figure;
}

/// Returns the index of a run that diverged. If no run diverged, returns the index of the run with
/// the largest force error.
std::size_t worst_of(const std::vector<RunFigures>& figures) {
  const auto badness = [](const RunFigures& run) {
    if (!run.made) return -1.0;
    const double of_run = run["force_rmse"], error = std::isfinite(of_run) ? of_run : 1e3;
    return (diverged(run) ? 1e6 : 0.0) + error;
  };
  const auto worst =
      std::max_element(figures.begin(), figures.end(),
                       [&](const auto& a, const auto& b) { return badness(a) < badness(b); });
  return to_size(worst - figures.begin());
}

/// Adds a finding with the worst seed and the commands that repeat it.
void note_worst(const std::vector<RunFigures>& figures, const std::vector<BatchRun>& runs,
                ExperimentReport& report) {
  const std::size_t worst = worst_of(figures);
  const RunFigures& run = figures[worst];
  if (!run.made) return;
  char force[48] = "";
  if (run.metrics)
    std::snprintf(force, sizeof force, " with a force error of %.2f N", run.metrics->force_rmse);
  const std::string seed = std::to_string(run.seed);
  report.findings.push_back("The worst is seed " + seed + force +
                            "; `burnish polish worst_seed.yaml --controller mpc` repeats it, as "
                            "does this experiment with `--first-seed " +
                            seed + " --seeds 1`.");
  report.tasks = {{"worst_seed", runs[worst].spec.task}};
}

}  // namespace

ExperimentReport perform_seeds(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "All disturbances at once"};
  const int seeds = seeds_of(spec, spec.quick ? 4 : 200);
  std::vector<BatchRun> runs;
  std::map<std::string, Task> undrawn;
  for (int seed = spec.first_seed; seed < spec.first_seed + seeds; ++seed) {
    BatchRun run;
    run.name = "seed " + std::to_string(seed);
    // Runs of other shards need a name here, but no task.
    if (spec.shard.has(runs.size())) run.spec.task = task_of(spec, seed, undrawn);
    run.spec.plant = spec.plant;
    runs.push_back(std::move(run));
  }
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  if (!spec.reports()) return report;
  report.tables = {runs_table(spec, runs, figures), statistics_table(figures),
                   outcomes_table(figures)};
  report.figures = {distributions(runs, figures)};
  const auto strayed = std::count_if(figures.begin(), figures.end(), diverged);
  const auto made =
      std::count_if(figures.begin(), figures.end(), [](const RunFigures& run) { return run.made; });
  report.findings.push_back(std::to_string(strayed) + " of " + std::to_string(made) +
                            " runs diverged.");
  report.tables.push_back(aims_table(spec, figures, report));
  note_worst(figures, runs, report);
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing

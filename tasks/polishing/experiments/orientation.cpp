// Experiment orientation: the default task on surfaces of many orientations.
#include <cmath>
#include <limits>

#include "base/degrees.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {
namespace {

/// Aim (upper limit) of the error in every direction, as a multiple of the error on the table.
constexpr double allowed_ratio = 2.0;
constexpr int runs_wanted = 24;  ///< Aim for the number of directions that are within reach.

/// Direction of a surface's normal [deg]: tilt from vertical, and azimuth from the robot's front
/// (x) to its left (y).
struct Direction {
  int tilt, azimuth;
  Eigen::Vector3d normal() const {
    const double t = tilt / degrees_per_radian, a = azimuth / degrees_per_radian;
    return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
  }
  std::string name() const {
    return "tilt " + std::to_string(tilt) + ", azimuth " + std::to_string(azimuth);
  }
};

/// Returns directions that are spread approximately evenly over the hemisphere: the vertical, then
/// rings.
std::vector<Direction> directions(bool quick) {
  if (quick) return {{0, 0}, {60, 240}, {90, 180}};
  std::vector<Direction> all{{0, 0}};
  for (const auto& [tilt, count] : {std::pair{30, 6}, {60, 12}, {90, 12}})
    for (int i = 0; i < count; ++i) all.push_back({tilt, 360 / count * i});
  return all;
}

/// Direction of a surface, with the run on this surface.
struct Place {
  Direction direction;
  RunFigures run = {};
  bool out_of_reach() const { return run.refused; }  ///< run.outcome contains the reason.
};

Task task_for(const ExperimentSpec& spec, const Direction& direction) {
  Task task = experiment_task(spec, "table", "mismatch", 12.6);
  task.normal_base = direction.normal();
  task.point_base.reset();
  task.posture = searched_posture;
  task.disturbances.seed = static_cast<std::uint64_t>(spec.first_seed);
  return task;
}

/// Makes the runs: first on the table, then on a surface of each direction, with a start posture
/// found by search.
std::vector<Place> run_places(const ExperimentSpec& spec, RunFigures& table) {
  std::vector<Place> places;
  for (const Direction& direction : directions(spec.quick)) places.push_back({direction});
  std::vector<BatchRun> runs(1);
  runs[0].name = "table";
  runs[0].spec.task = experiment_task(spec, "table", "mismatch", 12.6);
  runs[0].spec.task.disturbances.seed = static_cast<std::uint64_t>(spec.first_seed);
  for (const Place& place : places)
    runs.push_back({place.direction.name(), {.task = task_for(spec, place.direction)}});
  for (BatchRun& run : runs) run.spec.plant = spec.plant;
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  table = figures[0];
  for (std::size_t i = 0; i < places.size(); ++i) places[i].run = figures[i + 1];
  return places;
}

std::string in_words(const Eigen::VectorXd& values) {
  std::string text;
  char number[32];
  for (const double value : values) {
    std::snprintf(number, sizeof number, "%s%.4f", text.empty() ? "" : " ", value);
    text += number;
  }
  return text;
}

double ratio(const RunFigures& run, const RunFigures& table, const char* figure) {
  return run[figure] / table[figure];
}

double worst_ratio(const Place& place, const RunFigures& table) {
  return std::max(ratio(place.run, table, "force_rmse"), ratio(place.run, table, "position_rmse"));
}

ResultTable runs_table(const std::vector<Place>& places, const RunFigures& table) {
  ResultTable result{.name = "runs", .title = "Every direction", .for_people = false};
  result.columns = {{"name"},         {"tilt", "deg", 0}, {"azimuth", "deg", 0},
                    {"out of reach"}, {"start", "rad"},   {"path origin x y z", "m"}};
  for (const ResultColumn& column : run_columns()) result.columns.push_back(column);
  const auto add = [&](std::vector<ResultCell> row, const RunFigures& run) {
    for (ResultCell& cell : run_cells(run)) row.push_back(std::move(cell));
    result.add(std::move(row));
  };
  add({std::string("table, named posture"), 0.0, 0.0, {}, {}, {}}, table);
  for (const Place& place : places)
    add({place.direction.name(), 1.0 * place.direction.tilt, 1.0 * place.direction.azimuth,
         place.out_of_reach() ? place.run.outcome : "", in_words(place.run.q_start),
         place.run.q_start.size() > 0 ? in_words(place.run.p_center) : ""},
        place.run);
  return result;
}

ResultTable normals_table(const std::vector<Place>& places, const RunFigures& table) {
  ResultTable result{.name = "normals",
                     .title = "Errors for every normal, compared with the table"};
  const std::vector<const char*> errors{"force_rmse", "position_rmse"},
      others{"without_contact", "run_torque_margin", "joint_margin", "tool_to_normal"};
  result.columns = {{"surface"}};
  for (const char* figure : errors) {
    result.columns.push_back(figure_column(figure));
    result.columns.push_back({"of the table's", "", 2});
  }
  for (const char* figure : others) result.columns.push_back(figure_column(figure));
  result.columns.push_back({"within twice the table's"});
  const auto add = [&](const std::string& name, const RunFigures& run, const std::string& verdict) {
    std::vector<ResultCell> row{name};
    for (const char* figure : errors) {
      row.emplace_back(shown(figure, run[figure]));
      row.emplace_back(ratio(run, table, figure));
    }
    for (const char* figure : others) row.emplace_back(shown(figure, run[figure]));
    row.emplace_back(verdict);
    result.add(std::move(row));
  };
  add("table, named posture", table, "-");
  for (const Place& place : places) {
    if (place.out_of_reach())
      add(place.direction.name(), place.run, "out of reach");
    else
      add(place.direction.name(), place.run,
          worst_ratio(place, table) <= allowed_ratio ? "yes" : "no");
  }
  return result;
}

ResultTable unreachable_table(const std::vector<Place>& places) {
  ResultTable result{.name = "out_of_reach", .title = "Directions out of reach"};
  result.columns = {{"surface"}, {"why"}};
  for (const Place& place : places)
    if (place.out_of_reach()) result.add({place.direction.name(), place.run.outcome});
  return result;
}

/// Returns a panel of a figure over the azimuth, with a curve per tilt. A tilt with a single
/// direction is drawn as a short horizontal line.
Panel panel_over_azimuth(const std::vector<Place>& places, const RunFigures& table,
                         const std::string& title, const std::string& label, const char* figure) {
  Panel panel{.title = title, .x_label = "azimuth of the normal [deg]", .y_label = label};
  int color = 0;
  for (std::size_t i = 0; i < places.size();) {
    const int tilt = places[i].direction.tilt;
    std::vector<double> x, y;
    for (; i < places.size() && places[i].direction.tilt == tilt; ++i) {
      x.push_back(places[i].direction.azimuth);
      y.push_back(shown(figure, places[i].run[figure]));
    }
    if (x.size() == 1) {
      x = {0.0, 330.0};
      y.push_back(y.front());
    }
    const auto size = static_cast<Eigen::Index>(x.size());
    panel.curves.push_back({.name = "tilt " + std::to_string(tilt),
                            .x = Eigen::Map<Eigen::VectorXd>(x.data(), size),
                            .y = Eigen::Map<Eigen::VectorXd>(y.data(), size),
                            .color = color++});
  }
  const double limit = allowed_ratio * shown(figure, table[figure]);
  panel.curves.push_back({.name = "twice the error of the run on the table",
                          .x = Eigen::Vector2d(0.0, 330.0),
                          .y = Eigen::Vector2d(limit, limit),
                          .color = 6,
                          .dashed = true});
  return panel;
}

Figure error_figure(const std::vector<Place>& places, const RunFigures& table) {
  Figure figure{.name = "errors",
                .plot = {.title = "Errors over the direction of the surface's normal"}};
  figure.plot.panel_width = 760;
  figure.plot.panels = {
      panel_over_azimuth(places, table, "Force", "rms error [N]", "force_rmse"),
      panel_over_azimuth(places, table, "Path", "rms error [mm]", "position_rmse")};
  return figure;
}

}  // namespace

ExperimentReport perform_orientation(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Surfaces of any orientation"};
  RunFigures table;
  const std::vector<Place> places = run_places(spec, table);
  report.tables = {runs_table(places, table), normals_table(places, table)};
  std::vector<RunFigures> made{table};
  int within = 0;
  const Place* worst = nullptr;
  for (const Place& place : places) {
    if (place.out_of_reach()) continue;
    made.push_back(place.run);
    within += worst_ratio(place, table) <= allowed_ratio ? 1 : 0;
    if (worst == nullptr || !(worst_ratio(place, table) <= worst_ratio(*worst, table)))
      worst = &place;
  }
  const auto reached = static_cast<int>(made.size()) - 1;
  const auto count = static_cast<int>(places.size());
  if (reached < count) report.tables.push_back(unreachable_table(places));
  report.findings.push_back(std::to_string(reached) + " of " + std::to_string(count) +
                            " directions are within reach" +
                            (spec.quick || reached >= runs_wanted
                                 ? "."
                                 : "; the aim is at least " + std::to_string(runs_wanted) + "."));
  report.findings.push_back(
      std::to_string(within) +
      " of the directions within reach have at most twice the force and path errors of the run on "
      "the table.");
  if (worst != nullptr) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "The worst is %s, with %.2f times the force error and %.2f times the path error "
                  "of the table.",
                  worst->direction.name().c_str(), ratio(worst->run, table, "force_rmse"),
                  ratio(worst->run, table, "position_rmse"));
    report.findings.push_back(text);
  }
  report.figures = {error_figure(places, table)};
  note_failures(spec, made, report);
  return report;
}

}  // namespace burnish::polishing

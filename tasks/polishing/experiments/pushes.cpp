#include "polishing/experiments/pushes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/to_size.hpp"
#include "burnish/sim/closed_loop.hpp"

namespace burnish::polishing {
namespace {

constexpr double push_duration = 0.3;  // duration of a push [s]; chosen by hand

/// Returns the planned start of the path [s].
double planned_path_begin(const Task& task) {
  return task.standing.settle + task.reach_duration + task.clearance / task.approach_speed +
         task.ramp_duration;
}

/// Measures errors between the start of the push and the end of the path.
std::vector<MeasuredFigure> measure_push(const RunResult& result, double begin) {
  Trace buffer;
  const Metrics metrics =
      measure(seen_from_surface(result.trace, buffer), result.setting.robot.model,
              {.start = begin, .end = result.metrics ? result.metrics->end : begin + 1.0});
  return {{"push", "force_rmse", metrics.force_rmse},
          {"push", "force_peak", metrics.force_peak},
          {"push", "position_rmse", metrics.position_rmse}};
}

/// Returns a measurement of measure_push(), in the display unit of the figure.
double of_push(const RunFigures& run, const std::string& figure) {
  for (const MeasuredFigure& measured : run.measured)
    if (measured.figure == figure) return shown(figure, measured.value);
  return RunFigures::none;
}

std::string what_came_of(const PushDirection::Trial& tried) {
  if (tried.survived) return "survived";
  const std::string fault =
      tried.run.fault == FaultKind::None ? "" : std::string(name_of(tried.run.fault));
  if (!fell(tried.run)) return fault.empty() ? tried.run.outcome : fault + ", stands";
  return fault.empty() ? "fell" : fault + ", fell";
}

}  // namespace

double PushDirection::largest_survived() const {
  double largest = 0.0;
  for (const Trial& each : tried)
    if (each.survived) largest = std::max(largest, each.force);
  return largest;
}

double PushDirection::smallest_lost() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Trial& each : tried)
    if (!each.survived) smallest = std::min(smallest, each.force);
  return smallest;
}

std::vector<PushDirection> push_directions(int count) {
  std::vector<PushDirection> directions;
  for (int i = 0; i < count; ++i) directions.push_back({.angle = 360.0 * i / count});
  return directions;
}

std::optional<double> next_push(const PushDirection& direction, double step) {
  if (direction.tried.empty()) return first_push;
  if (!direction.tried.back().run.made) return std::nullopt;
  const double survived = direction.largest_survived(), lost = direction.smallest_lost();
  if (std::isinf(lost))
    return survived < largest_push ? std::optional(std::min(largest_push, 2.0 * survived))
                                   : std::nullopt;
  if (lost - survived <= step * (1.0 + 1e-9)) return std::nullopt;
  return survived + step * std::max(1.0, std::floor(0.5 * (lost - survived) / step + 1e-9));
}

BatchRun push_run(const ExperimentSpec& spec, const Task& task, const std::string& frame,
                  double angle, double force) {
  char name[80];
  std::snprintf(name, sizeof name, "push of %.0f N towards %.0f degrees", force, angle);
  BatchRun run;
  run.name = name;
  run.spec.task = task;
  run.spec.plant = spec.plant;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  run.spec.task.verdict = {.contact_share = 0.0, .force_rmse = infinite, .path_share = 0.0};
  const double begin = planned_path_begin(task) + task.polish_duration / 3.0;
  const double direction = angle * std::numbers::pi / 180.0;
  const Eigen::Vector3d force_world(force * std::cos(direction), force * std::sin(direction), 0.0);
  run.spec.task.disturbances.seed = static_cast<std::uint64_t>(spec.first_seed);
  run.spec.task.disturbances.pushes = {{begin, push_duration, force_world, frame}};
  run.measure = [begin](const RunResult& result) { return measure_push(result, begin); };
  return run;
}

void note_push(double force, const RunFigures& run, PushDirection& direction) {
  direction.tried.push_back({force, run, run.made && run.succeeded && !fell(run)});
}

ResultTable pushes_table(const std::vector<PushDirection>& directions) {
  ResultTable table{.name = "pushes", .title = "Pushes at the torso for 0.3 s during polishing"};
  table.columns = {
      {"towards", "deg", 0},        {"push", "N", 0},
      {"what came of it"},          figure_column("force_rmse", "force_rmse from the push on"),
      figure_column("force_peak"),  figure_column("position_rmse"),
      {"largest survived", "N", 0}, {"not survived", "N", 0},
      {"what came of that"}};
  for (const PushDirection& direction : directions) {
    if (direction.tried.empty() || !direction.tried.front().run.made) continue;
    const PushDirection::Trial& first = direction.tried.front();
    std::vector<ResultCell> row{direction.angle, first.force, what_came_of(first)};
    for (const char* figure : {"force_rmse", "force_peak", "position_rmse"})
      row.emplace_back(of_push(first.run, figure));
    const double lost = direction.smallest_lost();
    row.emplace_back(direction.largest_survived());
    row.emplace_back(lost);
    const auto at = std::find_if(direction.tried.begin(), direction.tried.end(),
                                 [&](const auto& each) { return each.force == lost; });
    row.push_back(at == direction.tried.end() ? ResultCell() : ResultCell(what_came_of(*at)));
    table.add(std::move(row));
  }
  return table;
}

Figure pushes_figure(const std::vector<PushDirection>& directions) {
  Figure figure{.name = "pushes", .plot = {.title = "Pushes at the torso for 0.3 s", .columns = 1}};
  figure.plot.panel_width = 560;
  figure.plot.panel_height = 460;
  const auto size = static_cast<Eigen::Index>(directions.size());
  Curve survived{
      .name = "largest survived", .x = Eigen::VectorXd(size + 1), .y = Eigen::VectorXd(size + 1)};
  Curve first{.name = "first tried", .x = survived.x, .y = survived.y, .dashed = true};
  for (Eigen::Index i = 0; i <= size; ++i) {
    const PushDirection& direction = directions[to_size(i % size)];
    const double angle = direction.angle * std::numbers::pi / 180.0;
    // In the plot, straight ahead of the robot is up, and its left side is on the left.
    const Eigen::Vector2d unit(-std::sin(angle), std::cos(angle));
    survived.x[i] = direction.largest_survived() * unit.x();
    survived.y[i] = direction.largest_survived() * unit.y();
    first.x[i] = first_push * unit.x();
    first.y[i] = first_push * unit.y();
  }
  figure.plot.panels = {{.title = "Force by direction, from above; the robot looks up",
                         .x_label = "to the right [N]",
                         .y_label = "forward [N]",
                         .curves = {std::move(survived), std::move(first)},
                         .equal_aspect = true}};
  return figure;
}

}  // namespace burnish::polishing

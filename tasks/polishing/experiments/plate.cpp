#include "polishing/experiments/plate.hpp"

#include <limits>
#include <numbers>

#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/shipped_tasks.hpp"

namespace burnish::polishing {
namespace {

constexpr ForceAxes compared_axes[] = {ForceAxes::Surface, ForceAxes::World, ForceAxes::Local};

Task plate_task(const ExperimentSpec& spec, double turn, ForceAxes axes) {
  Task task = shipped_task("two_arms");
  if (spec.quick) {
    task.polish_duration = 1.0;
    task.path.start_up = 0.4;
    task.reach_duration = 0.2;
  }
  override_task(task, spec.overrides);
  task.waving.turn_world = {0.0, 0.0, turn * std::numbers::pi / 180.0};
  task.axes = axes;
  // Disables the verdict, because the runs are only compared with each other.
  task.verdict = {.contact_share = 0.0,
                  .force_rmse = std::numeric_limits<double>::infinity(),
                  .path_share = 0.0};
  return task;
}

double worst_of(const PlateCase& of, const std::vector<RunFigures>& figures, const char* figure) {
  std::vector<double> values;
  for (const std::size_t index : of.runs) values.push_back(figures[index][figure]);
  return shown(figure, largest_of(values));
}

}  // namespace

const char* text_of(ForceAxes axes) {
  return axes == ForceAxes::Surface ? "surface" : axes == ForceAxes::World ? "world" : "local";
}

std::vector<PlateCase> add_plate(const ExperimentSpec& spec, std::vector<BatchRun>& runs) {
  const std::vector<double> turns =
      spec.quick ? std::vector<double>{20.0} : std::vector<double>{0.0, 10.0, 20.0};
  std::vector<PlateCase> cases;
  for (const double turn : turns)
    for (const ForceAxes axes : compared_axes) {
      cases.push_back({turn, axes});
      char name[64];
      std::snprintf(name, sizeof name, "plate, turned by %.0f degrees, %s", turn, text_of(axes));
      const std::size_t before = runs.size();
      add_seeds(spec, name, plate_task(spec, turn, axes), seeds_of(spec, spec.quick ? 1 : 2), runs);
      for (std::size_t i = before; i < runs.size(); ++i) cases.back().runs.push_back(i);
    }
  return cases;
}

ResultTable plate_table(const std::vector<PlateCase>& cases, const std::vector<RunFigures>& figures,
                        ExperimentReport& report) {
  ResultTable table{
      .name = "plate",
      .title = "A plate in the other hand: axes of the plate, the world and the tool"};
  table.columns = {{"plate turned", "deg", 0}};
  for (const char* figure : {"force_rmse", "position_rmse"})
    for (const ForceAxes axes : compared_axes)
      table.columns.push_back(figure_column(figure, std::string(figure) + ", " + text_of(axes)));
  constexpr std::size_t axes = std::size(compared_axes);
  for (std::size_t i = 0; i + axes <= cases.size(); i += axes) {
    std::vector<ResultCell> row{cases[i].turn};
    for (const char* figure : {"force_rmse", "position_rmse"})
      for (std::size_t k = 0; k < axes; ++k)
        row.emplace_back(worst_of(cases[i + k], figures, figure));
    table.add(std::move(row));
  }
  const std::size_t last = cases.size() - axes;
  char text[200];
  std::snprintf(text, sizeof text,
                "On a plate that turns by %.0f degrees, the force error is %.2f N in axes of the "
                "plate, %.2f N in axes of the world and %.2f N in axes of the tool.",
                cases[last].turn, worst_of(cases[last], figures, "force_rmse"),
                worst_of(cases[last + 1], figures, "force_rmse"),
                worst_of(cases[last + 2], figures, "force_rmse"));
  report.findings.push_back(text);
  return table;
}

}  // namespace burnish::polishing

#include "pressing/record.hpp"

#include "burnish/dynamics/reference.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/figures.hpp"
#include "record/figures_json.hpp"

namespace burnish::pressing {

Json ticks_json(const TaskRun& run) {
  Json json;
  each_tick_figure([&](const FigureEntry& entry, auto member) {
    json[entry.key()] = figure_json(run.ticks.*member);
  });
  json["first_s"] = run.first_tick;
  return json;
}

Json standing_json(const TaskRun& run) {
  if (!run.standing) return nullptr;
  Json json;
  each_standing_figure([&](const FigureEntry& entry, auto member) {
    json[entry.key()] = figure_json(*run.standing.*member);
  });
  return json;
}

std::vector<std::string> run_file_names() {
  return {"trace.csv", "metrics.json", "task.yaml", "fault.txt", "last_second.csv", "run.json",
          "run.html",  "run.mcap",     "force.svg", "path.svg",  "torques.svg",     "solver.svg"};
}

void add_run(RunPage& page, const TaskRun& run, const SceneSpec& scene, const SurfaceSpec& surface,
             const Disturbances& disturbances, int record_every) {
  page.outcome = run.outcome;
  page.fault = page_fault(run.fault);
  const SurfaceSpec plant = plant_surface(surface, disturbances);
  if (scene.tool_index() >= 0) {
    page.tool_frame = scene.tool().frame;
    page.tip_radius = scene.tool().radius;
  }
  page.surface = {.point = surface.point,
                  .axes = Reference::surface_with_normal(surface.normal).rotation,
                  .true_point = plant.point,
                  .true_axes = Reference::surface_with_normal(plant.normal).rotation,
                  .friction = plant.friction,
                  .extent = plant.extent};
  if (!surface.shape.is_flat()) page.surface.nominal = surface_of(surface);
  if (!plant.shape.is_flat()) add_curved_surface(page, surface_of(plant));
  page.supports = scene.supports();
  if (!page.supports.empty()) page.plant_model = plant_model(page.robot.model, disturbances);
  page.pushes = with_frames(disturbances.pushes, page.robot.model, scene);
  if (run.standing)
    for (PageMetric& figure : page_metrics(*run.standing))
      page.metrics.push_back(std::move(figure));
  if (!run.plans.time.empty()) page.plans = run.plans;
  add_trace(page, run.trace, record_every);
}

}  // namespace burnish::pressing

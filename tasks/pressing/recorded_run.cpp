#include "pressing/recorded_run.hpp"

#include <cmath>

#include "dynamics/instruction_set.hpp"

namespace burnish::pressing {

Json run_json(const RecordedRun& r) {
  Json json{{"name", r.name}, {"task", r.task}};
  json.update(r.facts_json);
  json.update({{"plant", name_of(r.plant)},
               {"kernels", instruction_set()},
               {"seed", r.disturbances.seed},
               {"succeeded", r.run.succeeded},
               {"outcome", r.run.outcome},
               {"fault", fault_json(r.run.fault)}});
  if (r.scene.tool_index() >= 0)
    json["metrics"] = r.metrics ? metrics_json(*r.metrics) : Json(nullptr);
  if (!r.figures.section.empty()) {
    json["figures"] = r.figures.section;  // section with the figures of this task
    json[r.figures.section] = r.figures.json;
  }
  json.update(r.more);
  if (r.run.standing) json["standing"] = standing_json(r.run);
  json["ticks"] = ticks_json(r.run);
  json["wall_time_s"] = r.run.wall_time;
  return json;
}

RunPage make_run_page(const RecordedRun& r, int record_every) {
  RunPage page{.name = r.name,
               .facts = r.facts,
               .command = r.command.empty() ? "burnish run task.yaml --plant " + name_of(r.plant)
                                            : r.command,
               .succeeded = r.run.succeeded,
               .metrics = r.metrics ? page_metrics(r.metrics) : std::vector<PageMetric>(),
               .task_file = r.task_file,
               .robot = drawing_of(r.robot, r.robot_name, r.q_start)};
  page.metrics.insert(page.metrics.end(), r.figures.page.begin(), r.figures.page.end());
  for (const auto& [name, q] : r.postures) page.robot.postures[name] = q;
  if (r.metrics) page.window = {r.metrics->start, r.metrics->end};
  page.phase_names = r.phase_names;
  page.path_origin_world = r.origin_world;
  page.path_u = r.path_u;
  page.path_w = r.path_w;
  add_run(page, r.run, r.scene, r.surface, r.disturbances, record_every);
  page.surface.frame = r.surface_frame;
  if (!r.plans) return page;
  page.solver = PageSolver{.period_ms = 1e3 * r.update_period};
  if (std::isfinite(r.deadline)) page.solver->deadline_ms = 1e3 * r.deadline;
  return page;
}

std::vector<std::string> write_run(const RecordedRun& r, const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages) {
  return write_run_files({.trace = r.run.trace,
                          .fault = r.run.fault,
                          .figures = run_json(r),
                          .task_file = r.task_file,
                          .plots = run_plots({.name = r.name,
                                              .run = r.run,
                                              .model = r.robot.model,
                                              .surface_axes = r.surface_axes,
                                              .origin_world = r.origin_world,
                                              .phase = r.phase,
                                              .phase_title = r.phase_title,
                                              .update_period = r.update_period,
                                              .has_estimate = r.plans}),
                          .page = [&] { return make_run_page(r, options.record_every); }},
                         options, folder, pages);
}

}  // namespace burnish::pressing

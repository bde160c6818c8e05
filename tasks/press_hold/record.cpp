#include "press_hold/record.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/instruction_set.hpp"
#include "press_hold/figures.hpp"
#include "pressing/record.hpp"
#include "record/figures_json.hpp"

namespace burnish::press_hold {

Json run_json(const RunName& run, const RunResult& result) {
  Json json{{"name", run.name},
            {"task", "press_hold"},
            {"plant", name_of(run.spec.plant)},
            {"kernels", instruction_set()},
            {"seed", run.spec.task.disturbances.seed},
            {"done", result.done},
            {"outcome", result.outcome},
            {"fault", fault_json(result.fault)},
            {"metrics", result.metrics ? metrics_json(*result.metrics) : Json(nullptr)},
            {"hold", nullptr},
            {"ticks", pressing::ticks_json(result)},
            {"wall_time_s", result.wall_time}};
  if (result.standing) json["standing"] = pressing::standing_json(result);
  if (result.hold)
    each_hold_figure([&](const FigureEntry& entry, auto member) {
      json["hold"][entry.key()] = figure_json(*result.hold.*member);
    });
  return json;
}

RunPage make_run_page(const RunName& run, const RunResult& result, int record_every) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  RunPage page{.name = run.name,
               .facts = {{"task", "press_hold"},
                         {"robot", task.robot},
                         {"force", fmt::format("{:g} N", task.force)},
                         {"plant", name_of(run.spec.plant)},
                         {"seed", std::to_string(task.disturbances.seed)}},
               .command = run.command.empty()
                              ? "burnish run task.yaml --plant " + name_of(run.spec.plant)
                              : run.command,
               .polished = result.done,
               .metrics = page_metrics(result.metrics),
               .task_file = task_text(task),
               .robot = drawing_of(setting.robot, task.robot, setting.q_start)};
  if (result.hold)
    each_hold_figure([&](const FigureEntry& entry, auto member) {
      page.metrics.push_back(page_metric({entry, entry.name, entry.meaning, *result.hold.*member}));
    });
  page.robot.postures["aside"] = setting.q_aside;
  if (result.metrics) page.window = {result.metrics->start, result.metrics->end};
  page.phase_names = phase_names();
  page.path_origin_world = setting.p_hold;
  page.path_u = page.path_w = Eigen::VectorXd::Zero(2);
  pressing::add_run(page, result, setting.scene, task.disturbances, record_every);
  page.solver = PageSolver{.period_ms = 1e3 / task.tick_rate};
  if (std::isfinite(task.limits.deadline)) page.solver->deadline_ms = 1e3 * task.limits.deadline;
  return page;
}

std::vector<std::string> write_run(const RunName& run, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages) {
  const Setting& setting = result.setting;
  return write_run_files(
      {.trace = result.trace,
       .fault = result.fault,
       .figures = run_json(run, result),
       .task_file = task_text(run.spec.task),
       .plots = pressing::run_plots({.name = run.name,
                                     .run = result,
                                     .model = setting.robot.model,
                                     .surface_axes = setting.surface_axes,
                                     .origin_world = setting.p_hold,
                                     .phase = 2,  // aside, of phase_names()
                                     .phase_title = "while it moves aside",
                                     .update_period = 1.0 / run.spec.task.tick_rate}),
       .page = [&] { return make_run_page(run, result, options.record_every); }},
      options, folder, pages);
}

}  // namespace burnish::press_hold

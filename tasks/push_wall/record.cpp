#include "push_wall/record.hpp"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/instruction_set.hpp"
#include "pressing/record.hpp"
#include "push_wall/figures.hpp"
#include "push_wall/pushing.hpp"
#include "record/figures_json.hpp"

namespace burnish::push_wall {

Json run_json(const RunName& run, const RunResult& result) {
  Json json{{"name", run.name},
            {"task", "push_wall"},
            {"plant", name_of(run.spec.plant)},
            {"kernels", instruction_set()},
            {"seed", run.spec.task.disturbances.seed},
            {"done", result.done},
            {"outcome", result.outcome},
            {"limit", name_of(result.limit)},
            {"limited_by", result.limited_by},
            {"fault", fault_json(result.fault)},
            {"push", nullptr},
            {"ticks", pressing::ticks_json(result)},
            {"wall_time_s", result.wall_time}};
  if (result.push)
    each_push_figure([&](const FigureEntry& entry, auto member) {
      json["push"][entry.key()] = figure_json(*result.push.*member);
    });
  return json;
}

RunPage make_run_page(const RunName& run, const RunResult& result, int record_every) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  RunPage page{.name = run.name,
               .facts = {{"task", "push_wall"},
                         {"robot", task.robot},
                         {"force", fmt::format("{:g} N of each hand", task.force)},
                         {"plant", name_of(run.spec.plant)},
                         {"seed", std::to_string(task.disturbances.seed)}},
               .command = run.command.empty()
                              ? "burnish run task.yaml --plant " + name_of(run.spec.plant)
                              : run.command,
               .polished = result.done,
               .task_file = task_text(task),
               .robot = drawing_of(setting.robot, task.robot, setting.q_start)};
  if (result.push)
    each_push_figure([&](const FigureEntry& entry, auto member) {
      page.metrics.push_back(page_metric({entry, entry.name, entry.meaning, *result.push.*member}));
    });
  page.phase_names = phase_names();
  page.path_origin_world = setting.p_hands.col(1);
  page.path_u = page.path_w = Eigen::VectorXd::Zero(2);
  pressing::add_run(page, result, setting.scene, task.disturbances, record_every);
  page.solver = PageSolver{.period_ms = 1e3 / task.update_rate};
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
                                     .surface_axes = setting.wall_axes,
                                     .origin_world = setting.p_hands.col(1),
                                     .phase = hold,
                                     .phase_title = "while it holds",
                                     .update_period = 1.0 / run.spec.task.update_rate,
                                     .has_estimate = false}),
       .page = [&] { return make_run_page(run, result, options.record_every); }},
      options, folder, pages);
}

}  // namespace burnish::push_wall

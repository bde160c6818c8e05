#include "press_hold/record.hpp"

#include <fmt/format.h>

#include "record/json_text.hpp"
#include "record/mesh_file.hpp"
#include "record/run_folder.hpp"

namespace burnish::press_hold {

std::vector<std::string> record_names() {
  return {"trace.csv", "metrics.json", "task.yaml", "last_second.csv",
          "run.json",  "run.html",     "run.mcap"};
}

nlohmann::ordered_json run_json(const RunName& run, const Task& task, const RunResult& result) {
  nlohmann::ordered_json json{
      {"name", run.name},    {"task", "press_hold"},      {"plant", name_of(run.plant)},
      {"done", result.done}, {"outcome", result.outcome}, {"fault", nullptr},
      {"metrics", nullptr}};
  if (result.fault.kind != FaultKind::None)
    json["fault"] = {{"kind", name_of(result.fault.kind)},
                     {"quantity", result.fault.quantity},
                     {"time_s", result.fault.time},
                     {"value", number_json(result.fault.value)},
                     {"limit", number_json(result.fault.limit)}};
  if (result.metrics)
    json["metrics"] = {{"force_N", task.force},
                       {"force_rmse_N", result.metrics->force_rmse},
                       {"force_peak_N", result.metrics->force_peak},
                       {"without_contact", result.metrics->without_contact},
                       {"moved_aside", result.moved},
                       {"slip_m", result.slip}};
  return json;
}

RunPage make_run_page(const RunName& run, const Task& task, const RunResult& result) {
  const Setting& setting = result.setting;
  const Robot& robot = setting.robot;
  RunPage page{.name = run.name,
               .facts = {{"task", "press_hold"},
                         {"robot", task.robot},
                         {"force", fmt::format("{:g} N", task.force)},
                         {"plant", name_of(run.plant)}},
               .command = "burnish run task.yaml --plant " + name_of(run.plant),
               .outcome = result.outcome,
               .polished = result.done,
               .metrics = page_metrics(result.metrics),
               .task_file = task_text(task),
               .robot = {.model = robot.model, .q = setting.q_start}};
  for (const auto& [name, posture] : robot.postures)
    page.robot.postures[name] = configuration(robot.model, posture);
  page.robot.postures["aside"] = setting.q_aside;
  page.robot.meshes = load_meshes(robot.model, robot_folder(task.robot));
  if (result.fault.kind != FaultKind::None)
    page.fault =
        PageFault{std::string(name_of(result.fault.kind)), result.fault.time, result.fault.text()};
  if (result.metrics) page.window = {result.metrics->start, result.metrics->end};
  page.phase_names = phase_names();
  page.tool_frame = setting.scene.tip.frame;
  page.tip_radius = setting.scene.tip.radius;
  const SurfaceSpec& surface = setting.scene.surface;
  page.surface = {.point = surface.point,
                  .axes = setting.surface_axes,
                  .true_point = surface.point + task.surface_height * surface.normal,
                  .true_axes = setting.surface_axes,
                  .friction = task.friction,
                  .extent = surface.extent};
  page.path_origin_world = setting.p_hold;
  page.path_u = page.path_w = Eigen::VectorXd::Zero(2);
  page.solver = PageSolver{.period_ms = 1e3 / task.tick_rate};
  add_trace(page, result.trace, run.record_every);
  return page;
}

std::vector<std::string> write_run(const RunName& run, const Task& task, const RunResult& result,
                                   const std::filesystem::path& folder, PageWriter& pages) {
  make_folder(folder);
  std::vector<std::string> names{"trace.csv", "metrics.json", "task.yaml"};
  result.trace.write_csv(folder / "trace.csv");
  write_text(folder / "metrics.json", json_text(run_json(run, task, result)));
  write_text(folder / "task.yaml", task_text(task));
  if (result.fault.kind != FaultKind::None) {
    result.fault.last_second.write_csv(folder / "last_second.csv");
    names.emplace_back("last_second.csv");
  }
  const auto page = [&] { return make_run_page(run, task, result); };
  for (std::string& name : pages.write(folder, page)) names.push_back(std::move(name));
  return names;
}

}  // namespace burnish::press_hold

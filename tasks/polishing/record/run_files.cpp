#include "polishing/record/run_files.hpp"

#include "burnish/tasks/polishing/task_file.hpp"
#include "dynamics/instruction_set.hpp"
#include "polishing/figures.hpp"
#include "pressing/record.hpp"
#include "record/figures_json.hpp"

namespace burnish::polishing {
namespace {

/// Returns the metrics of the verdict with their limits. The force error is written twice: in N,
/// and as a fraction of the force.
Json verdict_json(const Task& task, const VerdictFigures& figures) {
  Json json;
  each_verdict_figure([&](const FigureEntry& entry, auto member, auto wanted, bool at_least) {
    const double value = figures.*member, limit = task.verdict.*wanted;
    const bool is_fraction = !*entry.unit.unit;
    Json& of = json[entry.name];
    of["value"] = number_json(is_fraction ? value : value / task.force);
    of[at_least ? "at_least" : "at_most"] = number_json(limit);
    if (!is_fraction) of[std::string("value_") + entry.unit.unit] = number_json(value);
  });
  return json;
}

Json rest_json(const RestFigures& figures) {
  Json json;
  each_rest_figure([&](const FigureEntry& entry, auto member) {
    json[entry.key()] = figure_json(figures.*member);
  });
  return json;
}

}  // namespace

Json run_json(const PolishJob& job, const RunResult& result) {
  Json json{{"name", job.name},
            {"controller", name_of(job.spec.controller)},
            {"plant", name_of(job.spec.plant)},
            {"kernels", instruction_set()},
            {"seed", job.spec.task.disturbances.seed},
            {"succeeded", result.succeeded},
            {"outcome", result.outcome},
            {"fault", fault_json(result.fault)}};
  json["verdict"] = result.verdict ? verdict_json(job.spec.task, *result.verdict) : Json(nullptr);
  json["metrics"] = result.metrics ? metrics_json(*result.metrics) : Json(nullptr);
  if (result.rest) json["rest"] = rest_json(*result.rest);
  if (result.standing) json["standing"] = pressing::standing_json(result);
  json["ticks"] = pressing::ticks_json(result);
  json["reach"] = {{"points", result.reach.points},
                   {"path_length_m", result.reach.path_length},
                   {"joint_margin_rad", number_json(result.reach.joint_margin)},
                   {"tightest_joint", result.reach.tightest_joint},
                   {"torque_share", result.reach.torque_share},
                   {"tightest_torque", result.reach.tightest_torque},
                   {"force_per_torque_1_per_m", result.reach.force_per_torque},
                   {"force_joint", result.reach.force_joint}};
  if (!result.setting.assumed_rotors.empty())
    json["assumed_rotors_kg_m2"] = result.setting.assumed_rotors;
  if (result.setting.home)
    json["home"] = {{"duration_s", result.setting.home->duration()},
                    {"farthest_joint", result.setting.home->farthest_joint},
                    {"farthest_rad", result.setting.home->farthest}};
  json["wall_time_s"] = result.wall_time;
  return json;
}

std::vector<std::string> write_run(const PolishJob& job, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages) {
  const Setting& setting = result.setting;
  return write_run_files(
      {.trace = result.trace,
       .fault = result.fault,
       .figures = run_json(job, result),
       .task_file = task_text(job.spec.task),
       .plots = pressing::run_plots({.name = job.name,
                                     .run = result,
                                     .model = setting.robot.model,
                                     .surface_axes = setting.surface_axes,
                                     .origin_world = setting.p_center,
                                     .phase = number_of(Phase::Track),
                                     .phase_title = "on the path",
                                     .update_period = 1.0 / job.spec.task.update_rate,
                                     .has_estimate = job.spec.controller == ControllerKind::Mpc}),
       .page = [&] { return make_run_page(job, result, options.record_every); }},
      options, folder, pages);
}

}  // namespace burnish::polishing

#include "polishing/record/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/figures.hpp"
#include "polishing/rotors.hpp"
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

/// Returns the entries of metrics.json that only polishing has.
Json more_json(const Task& task, const RunResult& result) {
  Json json{{"verdict", result.verdict ? verdict_json(task, *result.verdict) : Json(nullptr)}};
  if (result.rest) json["rest"] = rest_json(*result.rest);
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
  return json;
}

std::string vector_text(const Eigen::Vector3d& v) {
  const auto plain = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", plain(v.x()), plain(v.y()), plain(v.z()));
}

std::vector<std::pair<std::string, std::string>> facts_of(const PolishJob& job,
                                                          const RunResult& result) {
  const Task& task = job.spec.task;
  std::vector<std::pair<std::string, std::string>> facts{
      {"task", job.place},
      {"robot", task.robot},
      {"surface", "normal " + vector_text(result.setting.scene.tool().surface.normal)},
      {"force", fmt::format("{:g} N", task.force)},
      {"path", fmt::format("{}, {:g} s", name_of(task.path.kind), task.polish_duration)},
      {"controller", name_of(job.spec.controller)}};
  if (job.spec.controller == ControllerKind::Mpc)
    facts.emplace_back("plans", fmt::format("{:g} Hz, horizon {:g} s in steps of {:g} s",
                                            task.update_rate, task.horizon, task.step));
  facts.emplace_back("plant", name_of(job.spec.plant));
  if (!result.setting.assumed_rotors.empty())
    facts.emplace_back("assumed rotors", assumed_rotors_text(result.setting));
  facts.emplace_back("seed", std::to_string(task.disturbances.seed));
  return facts;
}

void add_path(const Task& task, pressing::RecordedRun& record) {
  const Path path(task.path);
  constexpr int max_points = 4000;
  const int points = std::clamp(static_cast<int>(task.polish_duration / 0.01), 2, max_points);
  record.path_u.resize(points);
  record.path_w.resize(points);
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector2d p = path.at(task.polish_duration * i / (points - 1)).p;
    record.path_u[i] = p.x();
    record.path_w[i] = p.y();
  }
}

/// Returns the command that repeats the run, to be called in the folder of the run.
std::string command_of(const RunSpec& spec) {
  return "burnish polish task.yaml --controller " + name_of(spec.controller) + " --plant " +
         name_of(spec.plant) + (spec.check_reach ? "" : " --unchecked");
}

}  // namespace

pressing::RecordedRun recorded(const PolishJob& job, const RunResult& result) {
  const Task& task = job.spec.task;
  const Setting& setting = result.setting;
  pressing::RecordedRun record = pressing::record_of("polishing", job, result);
  if (record.command.empty()) record.command = command_of(job.spec);
  record.facts = facts_of(job, result);
  record.facts_json["controller"] = name_of(job.spec.controller);
  // A surface that a frame carries is drawn at its initial placement.
  const SurfaceSpec& surface = setting.scene.tool().surface;
  const Eigen::Isometry3d placement =
      surface_placement(setting.robot.model, setting.q_start, surface);
  record.surface = in_world(surface, placement);
  record.surface_frame = surface.frame;
  record.surface_axes = setting.surface_axes;
  record.origin_world = placement * setting.p_center;
  add_path(task, record);
  record.phase_names = phase_names();
  record.phase = number_of(Phase::Track);
  record.phase_title = "on the path";
  record.update_period = 1.0 / task.update_rate;
  record.plans = job.spec.controller == ControllerKind::Mpc;
  record.metrics = result.metrics;
  record.more = more_json(task, result);
  return record;
}

}  // namespace burnish::polishing

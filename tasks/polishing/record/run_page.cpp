// HTML page of a polishing run: facts, scene, path, plans and the curves of its trace.
#include <fmt/format.h>

#include <cmath>

#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/record/run_files.hpp"
#include "polishing/rotors.hpp"
#include "pressing/record.hpp"

namespace burnish::polishing {
namespace {

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

void add_path(RunPage& page, const Task& task, const Setting& setting) {
  page.path_origin_world =
      surface_placement(setting.robot.model, setting.q_start, setting.scene.tool().surface) *
      setting.p_center;
  const Path path(task.path);
  constexpr int max_points = 4000;
  const int points = std::clamp(static_cast<int>(task.polish_duration / 0.01), 2, max_points);
  page.path_u.resize(points);
  page.path_w.resize(points);
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector2d p = path.at(task.polish_duration * i / (points - 1)).p;
    page.path_u[i] = p.x();
    page.path_w[i] = p.y();
  }
}

/// Returns the command that repeats the run, to be called in the folder of the run.
std::string command_of(const RunSpec& spec) {
  return "burnish polish task.yaml --controller " + name_of(spec.controller) + " --plant " +
         name_of(spec.plant) + (spec.check_reach ? "" : " --unchecked");
}

}  // namespace

RunPage make_run_page(const PolishJob& job, const RunResult& result, int record_every) {
  const Task& task = job.spec.task;
  RunPage page{.name = job.name,
               .facts = facts_of(job, result),
               .command = job.command.empty() ? command_of(job.spec) : job.command,
               .succeeded = result.succeeded,
               .metrics = page_metrics(result.metrics),
               .task_file = task_text(task),
               .robot = drawing_of(result.setting.robot, task.robot, result.setting.q_start)};
  if (result.metrics) page.window = {result.metrics->start, result.metrics->end};
  page.phase_names = phase_names();
  add_path(page, task, result.setting);
  if (job.spec.controller == ControllerKind::Mpc) {
    page.solver = PageSolver{.period_ms = 1e3 / task.update_rate};
    if (std::isfinite(task.limits.deadline)) page.solver->deadline_ms = 1e3 * task.limits.deadline;
  }
  // A surface that a frame carries is drawn at its initial placement.
  const SceneSpec& scene = result.setting.scene;
  const SurfaceSpec& surface = scene.tool().surface;
  const SurfaceSpec drawn = in_world(
      surface, surface_placement(result.setting.robot.model, result.setting.q_start, surface));
  pressing::add_run(page, result, scene, drawn, task.disturbances, record_every);
  page.surface.frame = surface.frame;
  return page;
}

}  // namespace burnish::polishing

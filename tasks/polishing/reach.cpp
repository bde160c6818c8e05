#include "burnish/tasks/polishing/reach.hpp"

#include <cmath>
#include <numbers>

#include "pressing/arm.hpp"
#include "pressing/posture_search.hpp"
#include "pressing/reach_walk.hpp"
#include "pressing/tool_direction.hpp"

namespace burnish::polishing {
namespace {

/// s until the path is over or repeats itself.
double time_on_path(const Task& task, const Path& path) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const PathSpec& spec = task.path;
  double time = std::min(task.polish_duration, path.duration());
  if (spec.kind == PathKind::Circle && spec.rate != 0.0)
    time = std::min(time, spec.start_up + turn / std::abs(spec.rate));
  if (spec.kind == PathKind::Spiral)  // out and back
    time = std::min(time, spec.start_up + 2.0 * turn * spec.radius / (spec.pitch * spec.rate));
  return time;
}

void visit_path(pressing::ReachWalk& walk, const Task& task, const Setting& setting,
                const ReachOptions& options) {
  const Path path(task.path);
  const double end = time_on_path(task, path), dt = 0.01;
  double& s = walk.report().path_length;
  Eigen::Vector2d before = path.at(0.0).p;
  double visited = -options.spacing;
  const long steps = std::lround(std::ceil(end / dt));
  for (long i = 0; i <= steps; ++i) {
    const Eigen::Vector2d here = path.at(std::min(end, static_cast<double>(i) * dt)).p;
    // A quick path takes more than one stop within dt.
    const double length = (here - before).norm(), s_before = s;
    s += length;
    while (visited + options.spacing <= s || (i == steps && visited < s)) {
      visited = std::min(s, visited + options.spacing);
      const double share = length > 0.0 ? (visited - s_before) / length : 1.0;
      const Eigen::Vector2d point = before + std::max(0.0, share) * (here - before);
      if (!walk.visit({point_on(task, setting, {.p = point}).p_world, visited,
                       task.force_profile.most(task.force)}))
        return;
    }
    before = here;
  }
}

}  // namespace

ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options) {
  // The walk knows surfaces that stand still while the arm moves.
  if (!task.surface_frame.empty()) return {};
  pressing::ReachWalk walk(setting.robot.model, setting.scene, setting.q_start, options);
  const Eigen::Vector3d p_above = setting.p_center + task.clearance * setting.scene.surface.normal;
  const bool there = walk.visit_line(setting.p_start, p_above, -task.clearance) &&
                     walk.visit_line(p_above, setting.p_center, 0.0);
  if (there) visit_path(walk, task, setting, options);
  return walk.report();
}

PostureOptions posture_options(const Task& task) { return pressing::posture_options_of(task); }

Eigen::Vector3d pressing_direction(const Task& task, const Model& model) {
  return pressing::tool_direction(task.tool, task.tool_axis, model).axis;
}

FoundPosture find_posture(const Task& task, const Robot& robot, const PostureOptions& options) {
  const pressing::PressingPlace place{task.tool,
                                      task.tool_axis,
                                      task.normal_world,
                                      task.point_world,
                                      task.tip_radius,
                                      task.clearance,
                                      task.force_profile.most(task.force)};
  return pressing::search_posture(
      place, robot.model, pressing::known_postures(robot), options, [&](const Eigen::VectorXd& q) {
        return check_reach(task, make_setting(task, robot, q), options.reach);
      });
}

}  // namespace burnish::polishing

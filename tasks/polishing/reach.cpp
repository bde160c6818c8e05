#include "burnish/tasks/polishing/reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/sentence.hpp"
#include "pressing/arm.hpp"
#include "pressing/home_move.hpp"
#include "pressing/posture_search.hpp"
#include "pressing/reach_walk.hpp"
#include "pressing/tool_direction.hpp"

namespace burnish::polishing {
namespace {

/// Returns the time until the path ends or repeats itself [s].
double time_on_path(const Task& task, const Path& path) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const PathSpec& spec = task.path;
  double time = std::min(task.polish_duration, path.duration());
  if (spec.kind == PathKind::Circle && spec.rate != 0.0)
    time = std::min(time, spec.start_up + turn / std::abs(spec.rate));
  if (spec.kind == PathKind::Spiral)  // from the centre to the radius and back
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
    // Visits points options.spacing apart: on a fast path, several points within dt.
    const double length = (here - before).norm(), s_before = s;
    s += length;
    while (visited + options.spacing <= s || (i == steps && visited < s)) {
      visited = std::min(s, visited + options.spacing);
      const double fraction = length > 0.0 ? (visited - s_before) / length : 1.0;
      const Eigen::Vector2d point = before + std::max(0.0, fraction) * (here - before);
      if (!walk.visit({point_on(task, setting, {.p = point}).p_world, visited,
                       task.force_profile.max_force(task.force)}))
        return;
    }
    before = here;
  }
}

}  // namespace

ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options) {
  // ReachWalk supports only surfaces that are fixed in the world.
  if (!task.surface_frame.empty()) return {};
  pressing::ReachWalk walk(setting.robot.model, setting.scene, setting.q_start, options);
  if (task.rest.is_stated())
    walk.load(task.rest.frame, task.rest.force * task.rest.normal_world.normalized());
  const Eigen::Vector3d p_above =
      setting.p_center + task.clearance * setting.scene.tool().surface.normal;
  const bool reaches_center = walk.visit_line(setting.p_start, p_above, -task.clearance) &&
                              walk.visit_line(p_above, setting.p_center, 0.0);
  if (reaches_center) visit_path(walk, task, setting, options);
  return walk.report();
}

namespace {

ReachReport check_home_move(const HomeMove& move, const Setting& setting,
                            const ReachOptions& options) {
  return pressing::check_home_move(move, setting.robot.model, setting.scene, options);
}

}  // namespace

std::vector<FreeHome> free_homes(const Task& task, const Setting& setting,
                                 const ReachOptions& options) {
  constexpr double min_distance = 0.01;  // smallest listed move of a joint [rad or m]
  std::vector<FreeHome> found;
  if (task.standing.stands() || !task.surface_frame.empty()) return found;
  for (const auto& [name, posture] : setting.robot.postures) {
    try {
      const auto move =
          pressing::home_move({.posture = name}, setting.robot, setting.q_start, setting.scene);
      if (move->farthest > min_distance && check_home_move(*move, setting, options).ok())
        found.push_back({name, move->duration()});
    } catch (const Error&) {
      continue;  // the posture violates limits, or names joints that the robot lacks
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const FreeHome& a, const FreeHome& b) { return a.duration < b.duration; });
  return found;
}

ReachReport check_home(const Task& task, const Setting& setting, const ReachOptions& options) {
  if (!setting.home) return {};
  ReachReport report = check_home_move(*setting.home, setting, options);
  if (report.ok()) return report;
  const std::vector<FreeHome> others = free_homes(task, setting, options);
  report.text += others.empty()
                     ? "; wanted another home, such as a posture on the near side of the surface "
                       "(home.posture, home.joints)"
                     : "; wanted another home: the motion from the posture " +
                           in_quotes(others[0].posture) + " is free of collisions";
  return report;
}

PostureOptions posture_options(const Task& task) { return pressing::posture_options_of(task); }

Eigen::Vector3d pressing_direction(const Task& task, const Model& model) {
  return pressing::tool_direction(task.tool, task.tool_axis, model).axis;
}

FoundPosture find_posture(const Task& task, const Robot& robot, const PostureOptions& options) {
  const pressing::PressingPlace place{task.tool,
                                      task.tool_axis,
                                      task.normal_base,
                                      task.point_base,
                                      task.tip_radius,
                                      task.clearance,
                                      task.force_profile.max_force(task.force)};
  return pressing::search_posture(
      place, robot.model, pressing::known_postures(robot), options, [&](const Eigen::VectorXd& q) {
        const Setting setting = make_setting(task, robot, q);
        ReachReport report = check_reach(task, setting, options.reach);
        if (!report.ok() || !setting.home) return report;
        const ReachReport move = check_home_move(*setting.home, setting, options.reach);
        if (move.ok()) return report;
        report.problem = move.problem;
        report.text = move.text + "; wanted another home";
        return report;
      });
}

}  // namespace burnish::polishing

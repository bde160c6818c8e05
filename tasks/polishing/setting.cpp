// Setting of a polishing task: robot, start posture, scene and times.
#include <algorithm>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "polishing/resting_hand.hpp"
#include "polishing/rotors.hpp"
#include "pressing/arm.hpp"
#include "pressing/home_move.hpp"
#include "pressing/standing_terms.hpp"
#include "pressing/tool_direction.hpp"

namespace burnish::polishing {

Robot load_task_robot(const Task& task) {
  Robot robot = pressing::load_arm(task.robot, task.tool, task.standing.stands());
  if (searches_posture(task, robot))
    pressing::note_tool_direction(task.tool, task.tool_axis, robot.model, robot.notes);
  return robot;
}

bool searches_posture(const Task& task, const Robot& robot) {
  if (task.posture.empty()) return robot.default_posture.empty();
  if (robot.postures.contains(task.posture)) return false;
  if (task.posture == searched_posture) return true;
  const auto& surfaces = named_surfaces();
  return std::any_of(surfaces.begin(), surfaces.end(),
                     [&](const NamedSurface& surface) { return surface.posture == task.posture; });
}

Setting make_setting(const Task& task) { return make_setting(task, load_task_robot(task)); }

namespace {
LightJointOptions light_options(const Task& task) {
  const double period = 1.0 / task.tick_rate;
  return {plant_step(period), period, task.limits.joint_speed_ratio};
}

/// Throws Error if the path leaves a curved surface, seen along the normal at the origin of the
/// path. Also throws Error if the surface is steeper than 70 degrees somewhere on the path.
void check_path_on(const Setting& setting, const Task& task) {
  if (task.shape.is_flat()) return;
  if (task.axes != ForceAxes::Surface)
    throw EntryError("axes",
                     std::string(task.axes == ForceAxes::Local ? "the tool's" : "the world's") +
                         " axes do not turn with the normal of a " + task.shape.text() +
                         "; wanted surface");
  // Cosine of the largest slope angle, about 70 degrees; chosen by hand.
  constexpr double min_cosine = 0.35;
  constexpr int count = 400;  // number of points checked along the path
  const Surface surface = surface_of(setting.scene.tool().surface);
  const Path path(task.path);
  const double end = std::min(task.polish_duration, path.duration());
  for (int i = 0; i <= count; ++i) {
    const Eigen::Vector2d p = path.at(end * i / count).p;
    const Eigen::Vector3d on = surface.along_normal(setting.scene.tool().surface.point +
                                                    setting.surface_axes.leftCols<2>() * p);
    const SurfaceDistance at = surface.at(on);
    if (std::abs(at.distance) < 1e-9 && at.normal.dot(setting.surface_axes.col(2)) > min_cosine)
      continue;
    throw EntryError("path", "the path leaves the " + task.shape.text() + ": at [" + number(p.x()) +
                                 ", " + number(p.y()) +
                                 "] m from the path's origin, the surface ends or is steeper than "
                                 "70 degrees; wanted a smaller path or a larger shape");
  }
}

void check_home(const Task& task) {
  if (!task.home.is_stated()) return;
  const auto refuse = [](const std::string& what) {
    throw EntryError("home", "the motion from home " + what + "; wanted no key 'home'");
  };
  if (task.standing.stands()) refuse("does not keep the balance of a robot that stands");
  if (!task.surface_frame.empty())
    refuse("cannot be checked for collisions with a surface that the robot carries (frame " +
           in_quotes(task.surface_frame) + ")");
}

void check_carrier(const Task& task, const Model& model) {
  if (task.surface_frame.empty()) return;
  std::vector<std::string> frames;
  for (const Frame& frame : model.frames) frames.push_back(frame.name);
  if (!model.has_frame(task.surface_frame))
    throw EntryError("surface.frame", "robot " + in_quotes(model.name) + " has no frame " +
                                          in_quotes(task.surface_frame) +
                                          did_you_mean(task.surface_frame, frames));
}
}  // namespace

namespace {
/// Returns `setting` if the pressing direction Task::tool_axis is valid at the start. Throws
/// EntryError if it is not.
Setting checked_axis(const Task& task, Setting setting) {
  if (!task.tool_axis) return setting;
  const Model& model = setting.robot.model;
  const SurfaceSpec& surface = setting.scene.tool().surface;
  const Eigen::Matrix3d R_tool =
      surface_placement(model, setting.q_start, surface).linear().transpose() *
      frame_placement(model, setting.q_start, task.tool).linear();
  pressing::check_tool_axis(R_tool * task.tool_axis->normalized(), surface.normal,
                            task.search.tilt);
  return setting;
}
}  // namespace

Setting make_setting(const Task& task, const Robot& robot) {
  const bool searched = searches_posture(task, robot);
  if (searched && !task.surface_frame.empty())
    throw EntryError("posture",
                     "the search does not support a surface that the robot carries; wanted a "
                     "posture of the robot's settings");
  if (searched && task.standing.stands()) {
    if (task.posture == searched_posture)
      throw EntryError("posture",
                       "the search does not support a robot that stands; wanted a posture of the "
                       "robot's settings, with the tool in front of the surface");
    return checked_axis(task, make_setting(task, robot, robot.reference_configuration()));
  }
  if (!searched)
    return checked_axis(
        task, make_setting(task, robot, pressing::start_posture(robot, task.posture, nullptr)));
  return make_setting(task, robot, pressing::start_posture(robot, searched_posture, [&] {
                        return find_posture(task, robot, posture_options(task)).q;
                      }));
}

std::vector<LightJoint> light_joints(const Task& task, const Setting& setting) {
  return burnish::light_joints(setting.robot.model, setting.q_start, task.disturbances,
                               light_options(task));
}

std::string assumed_rotors_text(const Setting& setting) {
  std::string text;
  for (const auto& [joint, armature] : setting.assumed_rotors)
    text += (text.empty() ? "joint " : ", joint ") + in_quotes(joint) + " " + number(armature) +
            " kg m^2";
  return text;
}

Setting make_setting(const Task& task, const Robot& robot, const Eigen::VectorXd& q_start) {
  pressing::check_standing(robot.model, task.standing);
  check_home(task);
  check_carrier(task, robot.model);
  check_rest(task, robot.model);
  Setting s;
  s.robot = robot;
  s.q_start = q_start;
  if (task.assume_rotors)
    s.assumed_rotors =
        pressing::assume_rotors(s.robot.model, q_start, task.disturbances, light_options(task));
  TouchSpec tool{.frame = task.tool,
                 .radius = task.tip_radius,
                 .surface = {.frame = task.surface_frame,
                             .normal = task.normal_base,
                             .shape = task.shape,
                             .friction = task.friction,
                             .stiffness = task.stiffness,
                             .damping = task.damping}};
  if (task.point_base)
    tool.surface.point = *task.point_base;
  else
    tool = with_surface_at(s.robot.model, s.q_start, task.normal_base, tool, task.clearance);
  s.scene.touches = pressing::supports_at(robot.model, task.standing, q_start);
  s.scene.touches.insert(s.scene.touches.begin(), tool);
  if (task.rest.is_stated())
    s.scene.touches.push_back(resting_support(task.rest, robot.model, q_start));
  s.scene = checked_scene(s.robot.model, s.scene);
  SurfaceSpec& surface = s.scene.tool().surface;
  const Eigen::Vector3d n = surface.normal;
  s.surface_axes = Reference::surface_with_normal(n).rotation;
  s.p_start = surface_placement(s.robot.model, s.q_start, surface).inverse() *
              frame_placement(s.robot.model, s.q_start, task.tool).translation();
  const double above = gap(s.scene.tool(), s.p_start);
  s.p_center = s.p_start - above * n;
  if (above <= 0.0) throw Error("the tool starts " + number(-above) + " m inside the surface");
  if (std::isfinite(task.extent)) {
    surface.point = s.p_center - task.tip_radius * n;
    surface.extent = Path(task.path).reach() + task.extent;
  }
  check_path_on(s, task);
  refuse_weak_rest(task, s);
  s.home = pressing::home_move(task.home, s.robot, q_start, s.scene);
  s.reach_end = task.reach_duration;
  s.touch = s.reach_end + task.clearance / task.approach_speed;
  s.ramp_end = s.touch + task.ramp_duration;
  s.track_end = s.ramp_end + task.polish_duration;
  return s;
}

}  // namespace burnish::polishing

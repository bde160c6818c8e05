#include "pressing/arm.hpp"

#include <algorithm>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/words_in.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "model/mass_check.hpp"

namespace burnish::pressing {
namespace {

bool is_of_loop(const Model& model, const std::string& frame) {
  return std::any_of(model.loops.begin(), model.loops.end(),
                     [&](const Loop& loop) { return loop.first == frame || loop.second == frame; });
}

/// Returns a score of how well a name fits a tool frame; 0 means that the name does not fit.
int likeness(const std::string& name) {
  int rank = 6;
  for (const char* word : {"tcp", "tool", "flange", "grasp", "_ee", "end_effector"}) {
    if (has_one_of(name, {word})) return rank;
    --rank;
  }
  return 0;
}

/// Returns "; frames named like a tool: a; other frames: b, c; end links: d". Empty lists are left
/// out.
std::string frames_of(const Model& model, bool of_tool) {
  const auto listed = [](const std::string& what, const std::vector<std::string>& names) {
    constexpr std::size_t max_names = 8;
    std::string text = names.empty() ? "" : "; " + what + ": ";
    for (std::size_t i = 0; i < std::min(max_names, names.size()); ++i)
      text += (i == 0 ? "" : ", ") + names[i];
    return text;
  };
  std::vector<std::string> likely, links, frames, before_ends;
  for (const Frame& frame : model.frames) {
    if (frame.kind == FrameKind::Joint || frame.body < 0) continue;
    if (of_tool && likeness(frame.name) > 0 && !is_of_loop(model, frame.name)) {
      likely.push_back(frame.name);
      continue;
    }
    const bool is_end = std::none_of(model.joints.begin(), model.joints.end(),
                                     [&](const Joint& j) { return j.parent == frame.body; });
    if (frame.kind == FrameKind::Link) {
      if (is_end) links.push_back(frame.name);
    } else if (!is_of_loop(model, frame.name)) {
      (is_end ? frames : before_ends).push_back(frame.name);
    }
  }
  frames.insert(frames.end(), before_ends.begin(), before_ends.end());
  std::stable_sort(likely.begin(), likely.end(), [](const std::string& a, const std::string& b) {
    return likeness(a) > likeness(b);
  });
  return listed("frames named like a tool", likely) +
         listed(likely.empty() ? "frames" : "other frames", frames) + listed("end links", links);
}

}  // namespace

std::string none_of(const Model& model, const std::string& frame, bool of_tool) {
  std::vector<std::string> names;
  for (const Frame& existing : model.frames) names.push_back(existing.name);
  const std::string near = did_you_mean(frame, names);
  return in_quotes(frame) + " does not exist on robot " + in_quotes(model.name) +
         (near.empty() ? frames_of(model, of_tool) : near);
}

namespace {

/// Returns `robot` unchanged. Throws EntryError for "robot" if the robot has no mass or if a joint
/// moves no mass.
Robot simulable(Robot robot) {
  about("robot", [&] { require_simulable(robot.model); });
  return robot;
}

}  // namespace

Robot load_floating(const std::string& robot, const std::vector<std::string>& locked) {
  RobotOverrides overrides;
  overrides.locked = locked;
  Robot loaded = about("robot", [&] { return load_robot(robot, overrides); });
  // An MJCF file itself can contain a floating base.
  if (!loaded.model.joints.empty() && loaded.model.joints.front().kind == JointKind::FreeFlyer)
    return simulable(std::move(loaded));
  overrides.base = Base::FreeFlyer;
  return simulable(about("robot", [&] { return load_robot(robot, overrides); }));
}

Robot load_arm(const std::string& robot, const std::string& tool, bool stands) {
  RobotOverrides overrides;
  overrides.carrying = tool;
  Robot loaded = stands ? load_floating(robot)
                        : simulable(about("robot", [&] { return load_robot(robot, overrides); }));
  if (!loaded.model.has_frame(tool))
    throw EntryError("tool.frame",
                     "the tool's frame " + none_of(loaded.model, tool, true) +
                         "; wanted a frame of the robot in tool.frame or --tool FRAME");
  return loaded;
}

void refuse_floating_base(const Model& model) {
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::FreeFlyer)
      throw EntryError("robot", "the base of robot " + in_quotes(model.name) +
                                    " floats free, and this task has no feet that hold it; wanted "
                                    "a fixed base, such as a variant in the robot's settings");
}

Eigen::VectorXd start_posture(const Robot& robot, const std::string& posture,
                              const std::function<Eigen::VectorXd()>& search) {
  return about("posture", [&]() -> Eigen::VectorXd {
    if (posture.empty() ? robot.default_posture.empty()
                        : posture == searched_posture && !robot.postures.contains(posture))
      return search();
    return posture.empty() ? robot.reference_configuration() : robot.posture(posture);
  });
}

void check_tool_axis(const Eigen::Vector3d& axis, const Eigen::Vector3d& normal, double max_angle) {
  const double angle = std::atan2(axis.cross(normal).norm(), -axis.dot(normal));
  if (angle <= max_angle) return;
  throw EntryError(
      "tool.axis",
      "in the start posture, the angle between the axis and the direction into the surface is " +
          number(angle) + " rad; wanted at most " + number(max_angle) +
          " rad (search.tilt): another axis, or another start posture");
}

std::map<std::string, double> assume_rotors(Model& model, const Eigen::VectorXd& q,
                                            const Disturbances& disturbances,
                                            const LightJointOptions& options) {
  // Factor by which the limit is widened once one joint is light, because the description then
  // probably states no rotor inertias at all. Chosen by hand.
  constexpr double nearly_light = 1.25;
  std::map<std::string, double> added;
  if (light_joints(model, q, disturbances, options).empty()) return added;
  LightJointOptions wide = options;
  wide.joint_speed_ratio /= nearly_light;
  for (const LightJoint& light : light_joints(model, q, disturbances, wide)) {
    if (!std::isfinite(light.armature)) continue;
    model.armature[light.v] += light.armature;
    added[light.joint] = light.armature;
  }
  return added;
}

std::vector<Eigen::VectorXd> known_postures(const Robot& robot) {
  std::vector<Eigen::VectorXd> postures;
  for (const auto& [name, posture] : robot.postures) {
    Eigen::VectorXd q = robot.posture(name);
    if (q.size() == robot.model.nq) postures.push_back(std::move(q));
  }
  return postures;
}

}  // namespace burnish::pressing

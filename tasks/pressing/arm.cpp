#include "pressing/arm.hpp"

#include <algorithm>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {
namespace {

/// Says which links are at the ends of the robot.
[[noreturn]] void refuse_tool(const std::string& tool, const Model& model) {
  std::vector<std::string> names, ends;
  for (const Frame& frame : model.frames) {
    names.push_back(frame.name);
    if (frame.kind != FrameKind::Link || frame.body < 0) continue;
    const bool carries =
        std::any_of(model.joints.begin(), model.joints.end(),
                    [&](const Joint& joint) { return joint.parent == frame.body; });
    if (!carries) ends.push_back(frame.name);
  }
  std::string near = did_you_mean(tool, names);
  constexpr std::size_t most = 6;
  if (near.empty() && !ends.empty()) {
    near = "; links at its ends are ";
    for (std::size_t i = 0; i < std::min(most, ends.size()); ++i)
      near += (i == 0 ? "" : ", ") + ends[i];
  }
  throw EntryError("tool.frame", "the tool's frame " + in_quotes(tool) + " is none of robot " +
                                     in_quotes(model.name) + near);
}

}  // namespace

Robot load_arm(const std::string& robot, const std::string& tool, bool stands) {
  RobotOverrides overrides;
  if (stands) overrides.base = Base::FreeFlyer;
  if (!stands) overrides.carrying = tool;
  Robot loaded = about("robot", [&] { return load_robot(robot, overrides); });
  if (!loaded.model.has_frame(tool)) refuse_tool(tool, loaded.model);
  return loaded;
}

void refuse_floating_base(const Model& model) {
  for (const Joint& joint : model.joints)
    if (joint.kind == JointKind::FreeFlyer)
      throw EntryError("robot", "the base of robot " + in_quotes(model.name) +
                                    " floats free, and nothing would hold it while it presses; "
                                    "wanted a fixed base, as a variant of its settings may have");
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

std::vector<Eigen::VectorXd> known_postures(const Robot& robot) {
  std::vector<Eigen::VectorXd> known;
  for (const auto& [name, posture] : robot.postures) {
    Eigen::VectorXd q = robot.posture(name);
    if (q.size() == robot.model.nq) known.push_back(std::move(q));
  }
  return known;
}

}  // namespace burnish::pressing

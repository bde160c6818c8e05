#include "pressing/arm.hpp"

#include <algorithm>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {
namespace {

/// "; links at its ends are a, b, c", of many the first, or nothing where there is none.
std::string listed(const std::string& what, const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  std::string text = names.empty() ? "" : "; " + what + " are ";
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + names[i];
  return text;
}

bool is_of_loop(const Model& model, const std::string& frame) {
  return std::any_of(model.loops.begin(), model.loops.end(),
                     [&](const Loop& loop) { return loop.first == frame || loop.second == frame; });
}

/// Says which frames its files name, sites among them, and which links are at the ends of the
/// robot.
[[noreturn]] void refuse_tool(const std::string& tool, const Model& model) {
  std::vector<std::string> names, links, frames, before_ends;
  for (const Frame& frame : model.frames) {
    names.push_back(frame.name);
    if (frame.kind == FrameKind::Joint || frame.body < 0) continue;
    const bool is_end = std::none_of(model.joints.begin(), model.joints.end(),
                                     [&](const Joint& j) { return j.parent == frame.body; });
    if (frame.kind == FrameKind::Link) {
      if (is_end) links.push_back(frame.name);
    } else if (!is_of_loop(model, frame.name)) {
      (is_end ? frames : before_ends).push_back(frame.name);
    }
  }
  frames.insert(frames.end(), before_ends.begin(), before_ends.end());
  std::string near = did_you_mean(tool, names);
  if (near.empty()) near = listed("its own frames", frames) + listed("links at its ends", links);
  throw EntryError("tool.frame", "the tool's frame " + in_quotes(tool) + " is none of robot " +
                                     in_quotes(model.name) + near);
}

}  // namespace

Robot load_arm(const std::string& robot, const std::string& tool, bool stands) {
  RobotOverrides overrides;
  if (!stands) overrides.carrying = tool;
  Robot loaded = about("robot", [&] { return load_robot(robot, overrides); });
  // A description may have a floating base of its own, as those in MJCF do.
  if (stands && loaded.model.joints.front().kind != JointKind::FreeFlyer) {
    overrides.base = Base::FreeFlyer;
    loaded = about("robot", [&] { return load_robot(robot, overrides); });
  }
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

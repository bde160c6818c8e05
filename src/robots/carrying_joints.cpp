#include "robots/carrying_joints.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "robots/grippers.hpp"

namespace burnish {
namespace {

/// Returns the names of the joints that move the link, joint or frame `name`. A mimic joint counts
/// as its leader. Empty if `name` does not exist.
std::vector<std::string> carrying_joints(const TreeSpec& tree, std::string name) {
  const auto frame = std::find_if(tree.frames.begin(), tree.frames.end(),
                                  [&](const FrameSpec& spec) { return spec.name == name; });
  if (frame != tree.frames.end()) name = frame->parent;
  std::map<std::string, const JointSpec*> by_child, by_name;
  for (const JointSpec& joint : tree.joints) {
    by_child.emplace(joint.child_link, &joint);
    by_name.emplace(joint.name, &joint);
  }
  const auto among = [](const auto& joints, const std::string& key) {
    const auto found = joints.find(key);
    return found == joints.end() ? nullptr : found->second;
  };
  const bool is_link = std::any_of(tree.links.begin(), tree.links.end(),
                                   [&](const LinkSpec& link) { return link.name == name; });
  std::set<std::string> names;
  const JointSpec* joint = among(is_link ? by_child : by_name, name);
  // The two nested loops have a limited number of iterations, so that they end for a cycle of
  // joints. build_model() rejects cycles later.
  for (std::size_t i = 0; joint != nullptr && i < tree.joints.size(); ++i) {
    const JointSpec* moving = joint;
    for (std::size_t k = 0; moving != nullptr && moving->mimic && k < tree.joints.size(); ++k)
      moving = among(by_name, moving->mimic->leader);
    if (moving != nullptr && moving->type != JointType::Fixed) names.insert(moving->name);
    joint = among(by_child, joint->parent_link);
  }
  return {names.begin(), names.end()};
}

}  // namespace

std::vector<std::string> arm_joints(const TreeSpec& tree, const std::string& name,
                                    std::vector<std::string>& held) {
  const std::vector<std::string> carrying = carrying_joints(tree, name);
  const std::set<std::string> fingers = finger_joints(tree);
  std::vector<std::string> moving;
  for (const std::string& joint : carrying)
    (fingers.contains(joint) ? held : moving).push_back(joint);
  if (!moving.empty()) return moving;
  held.clear();
  return carrying;
}

}  // namespace burnish

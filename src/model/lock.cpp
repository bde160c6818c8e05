#include "model/lock.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "model/posture.hpp"
#include "model/sentence.hpp"

namespace burnish {
namespace {

/// What one call needs at hand.
struct Locking {
  const TreeSpec& tree;
  const ModelOptions& options;
  std::unordered_map<std::string, const JointSpec*> joint_by_name;
  std::set<std::string> locked;
};

bool moves(const JointSpec& joint) { return joint.type != JointType::Fixed; }

std::vector<std::string> joint_names(const TreeSpec& tree) {
  std::vector<std::string> names;
  for (const JointSpec& joint : tree.joints) names.push_back(joint.name);
  return names;
}

const JointSpec& find_joint(const Locking& locking, const std::string& name,
                            const std::string& what) {
  const auto found = locking.joint_by_name.find(name);
  if (found != locking.joint_by_name.end()) return *found->second;
  refuse(locking.tree, what + " " + in_quotes(name) + " does not exist" +
                           did_you_mean(name, joint_names(locking.tree)));
}

void choose_locked(Locking& locking) {
  const bool free_base = locking.options.base == Base::FreeFlyer;
  for (const std::string& name : locking.options.locked) {
    if (free_base && name == root_joint_name) {
      refuse(locking.tree,
             "joint 'root_joint' of a free-flying base cannot be locked; choose a "
             "fixed base instead");
    }
    if (moves(find_joint(locking, name, "joint to lock"))) locking.locked.insert(name);
  }
  if (locking.options.free.empty()) return;
  std::set<std::string> free;
  for (const std::string& name : locking.options.free) {
    if (free_base && name == root_joint_name) continue;
    if (!moves(find_joint(locking, name, "joint to leave free"))) {
      refuse(locking.tree, "joint to leave free " + in_quotes(name) +
                               " is fixed in the description; name a moving joint");
    }
    if (locking.locked.contains(name)) {
      refuse(locking.tree,
             "joint " + in_quotes(name) + " is listed both as locked and as free; name it once");
    }
    free.insert(name);
  }
  for (const JointSpec& joint : locking.tree.joints) {
    if (moves(joint) && !free.contains(joint.name)) locking.locked.insert(joint.name);
  }
}

void check_posture(const Locking& locking) {
  for (const auto& [name, values] : locking.options.posture) {
    if (name == root_joint_name && !locking.joint_by_name.contains(name)) {
      check_posture_values(origin_of(locking.tree), name, values, 7);
      continue;
    }
    const JointSpec& joint = find_joint(locking, name, "joint of the posture");
    if (!moves(joint)) {
      refuse(locking.tree, "joint of the posture " + in_quotes(name) +
                               " is fixed in the description and has no value");
    }
    check_posture_values(origin_of(locking.tree), name, values, posture_size(joint.type));
  }
}

const JointSpec& leader_of(const Locking& locking, const JointSpec& joint) {
  const JointSpec& leader = find_joint(locking, joint.mimic->leader,
                                       "mimic joint " + in_quotes(joint.name) + ": its leader");
  if (posture_size(leader.type) != 1) {
    refuse(locking.tree, "joint " + in_quotes(joint.name) + " copies joint " +
                             in_quotes(leader.name) +
                             ", which has not one coordinate; only revolute, continuous and "
                             "prismatic joints can be copied");
  }
  return leader;
}

void check_mimics(const Locking& locking) {
  for (const JointSpec& joint : locking.tree.joints) {
    if (!joint.mimic) continue;
    if (posture_size(joint.type) != 1) {
      refuse(locking.tree, "joint " + in_quotes(joint.name) +
                               " has not one coordinate but copies another joint; only revolute, "
                               "continuous and prismatic joints can");
    }
    leader_of(locking, joint);
    if (!locking.locked.contains(joint.name)) {
      refuse(locking.tree, "joint " + in_quotes(joint.name) + " copies joint " +
                               in_quotes(joint.mimic->leader) +
                               " and mimic joints are not simulated; lock it");
    }
  }
}

/// Follows leaders until one has a value of its own, then comes back through the chain.
double mimic_value(const Locking& locking, const JointSpec& first) {
  double scale = 1.0;
  double shift = 0.0;
  const JointSpec* joint = &first;
  for (std::size_t steps = 0; steps <= locking.tree.joints.size(); ++steps) {
    const auto stated = locking.options.posture.find(joint->name);
    if (stated != locking.options.posture.end()) return scale * stated->second[0] + shift;
    if (!joint->mimic) return shift;
    const JointSpec& leader = leader_of(locking, *joint);
    if (!locking.locked.contains(leader.name)) {
      refuse(locking.tree, "joint " + in_quotes(joint->name) + " is locked but copies joint " +
                               in_quotes(leader.name) + ", which moves; lock " +
                               in_quotes(leader.name) + " too or give " + in_quotes(joint->name) +
                               " a value in the posture");
    }
    shift += scale * joint->mimic->offset;
    scale *= joint->mimic->multiplier;
    joint = &leader;
  }
  refuse(locking.tree, "joint " + in_quotes(first.name) +
                           " copies itself through its leaders; one of them must not copy");
}

std::vector<double> locked_value(const Locking& locking, const JointSpec& joint) {
  const auto stated = locking.options.posture.find(joint.name);
  if (stated != locking.options.posture.end()) return stated->second;
  if (joint.mimic) return {mimic_value(locking, joint)};
  std::vector<double> zero(posture_size(joint.type), 0.0);
  if (joint.type == JointType::Floating) zero.back() = 1.0;
  return zero;
}

}  // namespace

LockedTree lock_joints(const TreeSpec& tree, const ModelOptions& options) {
  Locking locking{tree, options, {}, {}};
  for (const JointSpec& joint : tree.joints) locking.joint_by_name.emplace(joint.name, &joint);
  choose_locked(locking);
  check_posture(locking);
  check_mimics(locking);
  LockedTree result{tree, {}};
  for (JointSpec& joint : result.tree.joints) {
    if (!locking.locked.contains(joint.name)) continue;
    joint.placement = joint.placement * displacement(joint, locked_value(locking, joint));
    joint.type = JointType::Fixed;
    joint.mimic.reset();
    result.locked.push_back(joint.name);
  }
  return result;
}

}  // namespace burnish

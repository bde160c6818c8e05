#include "model/lock.hpp"

#include <set>

#include "model/mimic.hpp"
#include "model/posture.hpp"
#include "model/tendons.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

/// Arguments and results of one call of lock_joints().
struct Locking {
  const TreeSpec& tree;
  const ModelOptions& options;
  JointByName joint_by_name;
  std::set<std::string> locked;
};

bool moves(const JointSpec& joint) { return joint.type != JointType::Fixed; }

const JointSpec& find_joint(const Locking& locking, const std::string& name,
                            const std::string& what) {
  return find_joint(locking.tree, locking.joint_by_name, name, what);
}

/// Returns true if the joint follows one of `leaders`, directly or through other followers.
bool follows_one_of(const Locking& locking, const JointSpec& joint,
                    const std::set<std::string>& leaders) {
  const JointSpec* at = &joint;
  // Limits the number of steps, because followers may form a cycle. Courses later rejects cycles.
  for (std::size_t steps = 0; steps < locking.tree.joints.size(); ++steps) {
    if (!moves(*at) || !at->mimic) return false;
    at = &named_leader(locking.tree, locking.joint_by_name, *at);
    if (leaders.contains(at->name)) return true;
  }
  return false;
}

void choose_locked(Locking& locking) {
  const bool free_base = locking.options.base == Base::FreeFlyer;
  for (const std::string& name : locking.options.locked) {
    if (free_base && name == root_joint_name) {
      refuse(locking.tree,
             "joint 'root_joint' of a free-flying base cannot be locked; wanted a fixed base");
    }
    if (moves(find_joint(locking, name, "lock: joint"))) locking.locked.insert(name);
  }
  if (locking.options.free.empty()) return;
  std::set<std::string> free;
  for (const std::string& name : locking.options.free) {
    if (free_base && name == root_joint_name) continue;
    if (!moves(find_joint(locking, name, "free: joint"))) {
      refuse(locking.tree, "free: joint " + in_quotes(name) +
                               " is fixed in the description; wanted a moving joint");
    }
    if (locking.locked.contains(name)) {
      refuse(locking.tree,
             "joint " + in_quotes(name) +
                 " is listed both as locked and as free; wanted the joint in only one list");
    }
    free.insert(name);
  }
  for (const JointSpec& joint : locking.tree.joints) {
    if (!moves(joint)) continue;
    const bool follows = follows_one_of(locking, joint, free);
    if (free.contains(joint.name) && joint.mimic && !follows) {
      refuse(locking.tree, "free: joint " + in_quotes(joint.name) + " follows joint " +
                               in_quotes(joint.mimic->leader) + ", which is locked; wanted " +
                               in_quotes(joint.mimic->leader) + " free too");
    }
    if (!free.contains(joint.name) && !follows) locking.locked.insert(joint.name);
  }
}

void check_posture(const Locking& locking) {
  for (const auto& [name, values] : locking.options.posture) {
    if (name == root_joint_name && !locking.joint_by_name.contains(name)) {
      check_posture_values(origin_of(locking.tree), name, values, 7);
      continue;
    }
    const JointSpec& joint = find_joint(locking, name, "posture: joint");
    if (!moves(joint)) {
      refuse(locking.tree, "posture: joint " + in_quotes(name) +
                               " is fixed in the description; wanted a moving joint");
    }
    check_posture_values(origin_of(locking.tree), name, values, posture_size(joint.type));
  }
}

/// Returns the coordinates at which a joint is locked.
std::vector<double> locked_value(const Locking& locking, const JointSpec& joint, Courses& courses) {
  if (posture_size(joint.type) == 1) return {courses.of(joint).offset};
  const auto stated = locking.options.posture.find(joint.name);
  if (stated != locking.options.posture.end()) return stated->second;
  std::vector<double> zero(posture_size(joint.type), 0.0);
  if (joint.type == JointType::Floating || joint.type == JointType::Ball) zero.back() = 1.0;
  return zero;
}

}  // namespace

LockedTree lock_joints(const TreeSpec& stated_tree, const ModelOptions& options) {
  const TreeSpec tree = with_held_tendons(stated_tree, options);
  Locking locking{tree, options, {}, {}};
  for (const JointSpec& joint : tree.joints) locking.joint_by_name.emplace(joint.name, &joint);
  choose_locked(locking);
  check_posture(locking);
  Courses courses(tree, locking.joint_by_name, locking.locked, options.posture);
  LockedTree result{tree, {}, {}};
  for (std::size_t i = 0; i < tree.joints.size(); ++i) {
    const JointSpec& stated = tree.joints[i];
    JointSpec& joint = result.tree.joints[i];
    joint.mimic.reset();
    if (!stated.held.empty())
      result.held[stated.name] = {stated.name, JointKind::Revolute, -1, stated.held};
    if (!moves(stated)) continue;
    bool is_locked = locking.locked.contains(stated.name);
    if (stated.mimic && !is_locked) {
      const Course course = courses.of(stated);
      is_locked = course.leader == nullptr;
      if (!is_locked)
        joint.mimic = MimicSpec{course.leader->name, course.multiplier, course.offset};
    }
    if (!is_locked) continue;
    const std::vector<double> value = locked_value(locking, stated, courses);
    joint.placement = joint.placement * displacement(joint, value);
    result.held[stated.name] = {stated.name, kind_of(stated.type), -1, value};
    joint.type = JointType::Fixed;
    result.locked.push_back(joint.name);
  }
  result.tree.tendons = reduced_tendons(tree, locking.joint_by_name, courses);
  return result;
}

}  // namespace burnish

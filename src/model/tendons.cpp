#include "model/tendons.hpp"

#include <algorithm>

#include "model/posture.hpp"
#include "model/tree_sentence.hpp"

namespace burnish {
namespace {

using Parts = std::vector<TendonSpec::Part>;

std::string label_of(const TendonSpec& tendon) {
  return (tendon.line > 0 ? "line " + std::to_string(tendon.line) + ": " : "") + "tendon " +
         in_quotes(tendon.name);
}

/// Adds a joint to `parts`, or adds to the coefficient of a joint that is already there.
void add_part(const std::string& joint, double coefficient, Parts& parts) {
  const auto same = std::find_if(parts.begin(), parts.end(),
                                 [&](const auto& part) { return part.joint == joint; });
  if (same == parts.end())
    parts.push_back({joint, coefficient});
  else
    same->coefficient += coefficient;
}

const JointSpec& joint_of(const TreeSpec& tree, const JointByName& joints, const TendonSpec& tendon,
                          const std::string& name) {
  const JointSpec& joint = find_joint(tree, joints, name, label_of(tendon) + ": joint");
  if (posture_size(joint.type) > 1) {
    refuse(tree,
           label_of(tendon) + ": joint " + in_quotes(name) +
               " has more than one coordinate; wanted a revolute, continuous or prismatic joint");
  }
  return joint;
}

/// Held tendon and its moving joints.
struct HeldTendon {
  const TreeSpec& tree;
  const ModelOptions& options;
  const JointByName& joints;
  const TendonSpec& tendon;
  Parts parts = {};
  double rest = 0.0;

  static bool is_listed(const std::vector<std::string>& names, const std::string& joint) {
    return std::find(names.begin(), names.end(), joint) != names.end();
  }
  bool is_free(const std::string& joint) const {
    return options.free.empty() || is_listed(options.free, joint);
  }

  /// Collects the moving joints with nonzero coefficients.
  void gather() {
    rest = tendon.rest;
    for (const TendonSpec::Part& part : tendon.parts) {
      if (joint_of(tree, joints, tendon, part.joint).type != JointType::Fixed)
        add_part(part.joint, part.coefficient, parts);
    }
    std::erase_if(parts, [](const auto& part) { return part.coefficient == 0.0; });
  }

  /// Removes locked joints without a leader, and subtracts their lengths from `rest`.
  void remove_locked() {
    std::erase_if(parts, [&](const TendonSpec::Part& part) {
      const bool locked = is_listed(options.locked, part.joint) || !is_free(part.joint);
      if (!locked || joints.at(part.joint)->mimic) return false;
      const auto stated = options.posture.find(part.joint);
      if (stated != options.posture.end() && stated->second.size() == 1)
        rest -= part.coefficient * stated->second[0];
      return true;
    });
  }

  bool can_follow(const std::string& follower, const std::string& leader) const {
    const bool locked_alone =
        is_listed(options.locked, follower) && !is_listed(options.locked, leader);
    return !joints.at(follower)->mimic && !locked_alone && !(is_free(follower) && !is_free(leader));
  }

  std::string listed_parts() const {
    std::vector<std::string> names;
    for (const TendonSpec::Part& part : parts) names.push_back(part.joint);
    return listed("joint", names);
  }
};

}  // namespace

TreeSpec with_held_tendons(const TreeSpec& tree, const ModelOptions& options) {
  TreeSpec result = tree;
  std::erase_if(result.tendons, [](const TendonSpec& tendon) { return tendon.held; });
  if (result.tendons.size() == tree.tendons.size()) return result;
  std::unordered_map<std::string, JointSpec*> changed;
  JointByName joints;
  for (JointSpec& joint : result.joints) {
    changed.emplace(joint.name, &joint);
    joints.emplace(joint.name, &joint);
  }
  for (const TendonSpec& tendon : tree.tendons) {
    if (!tendon.held) continue;
    HeldTendon held{tree, options, joints, tendon};
    held.gather();
    if (held.parts.size() > 2) held.remove_locked();
    Parts& parts = held.parts;
    if (parts.empty()) continue;
    if (parts.size() == 1) {
      refuse(tree, label_of(tendon) + " has a constant length and acts on " + held.listed_parts() +
                       " alone; wanted two joints, or this joint locked");
    }
    if (parts.size() > 2) {
      refuse(tree,
             label_of(tendon) + " has a constant length and acts on " + held.listed_parts() +
                 "; wanted at most two moving joints, because one length can couple only two; "
                 "lock the others");
    }
    if (!held.can_follow(parts[1].joint, parts[0].joint)) std::swap(parts[0], parts[1]);
    if (!held.can_follow(parts[1].joint, parts[0].joint)) {
      refuse(tree, label_of(tendon) + " has a constant length and acts on " + held.listed_parts() +
                       ", but neither joint can follow the other; wanted at least one joint "
                       "that follows no joint, and both joints locked or both free");
    }
    // The tendon keeps its length: c_0 q_0 + c_1 q_1 = rest.
    changed.at(parts[1].joint)->mimic =
        MimicSpec{parts[0].joint, -parts[0].coefficient / parts[1].coefficient,
                  held.rest / parts[1].coefficient};
  }
  return result;
}

std::vector<TendonSpec> reduced_tendons(const TreeSpec& tree, const JointByName& joints,
                                        Courses& courses) {
  std::vector<TendonSpec> result;
  for (const TendonSpec& stated : tree.tendons) {
    TendonSpec tendon = stated;
    tendon.parts.clear();
    for (const TendonSpec::Part& part : stated.parts) {
      const Course course = courses.of(joint_of(tree, joints, stated, part.joint));
      tendon.rest -= part.coefficient * course.offset;
      if (course.leader == nullptr) continue;
      add_part(course.leader->name, part.coefficient * course.multiplier, tendon.parts);
    }
    std::erase_if(tendon.parts, [](const auto& part) { return part.coefficient == 0.0; });
    if (tendon.parts.empty() || (tendon.stiffness == 0.0 && tendon.damping == 0.0)) continue;
    for (const TendonSpec::Part& part : tendon.parts) {
      if (tendon.stiffness == 0.0 || joints.at(part.joint)->type != JointType::Continuous) continue;
      refuse(tree, label_of(stated) + " has a spring along joint " + in_quotes(part.joint) +
                       ", which is continuous; wanted a revolute joint, because whole turns of a "
                       "continuous joint are not counted");
    }
    result.push_back(std::move(tendon));
  }
  return result;
}

std::vector<Tendon> compile_tendons(const TreeSpec& reduced, const Model& model) {
  std::vector<Tendon> result;
  for (const TendonSpec& stated : reduced.tendons) {
    Tendon tendon{stated.name, {}, stated.rest, stated.stiffness, stated.damping};
    for (const Joint& joint : model.joints)
      for (const TendonSpec::Part& part : stated.parts)
        if (part.joint == joint.name)
          tendon.parts.push_back({joint.q_index, joint.v_index, part.coefficient});
    result.push_back(std::move(tendon));
  }
  return result;
}

}  // namespace burnish

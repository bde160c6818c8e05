#include "robots/joint_settings.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/findings.hpp"
#include "base/sentence.hpp"
#include "robots/description.hpp"

namespace burnish {
namespace {

/// Returns the moving joint `name`. Error messages use `key`, the key of the settings.
JointSpec& moving_joint(TreeSpec& tree, const std::string& name, const std::string& key,
                        const std::string& origin) {
  const auto joint = std::find_if(tree.joints.begin(), tree.joints.end(),
                                  [&](const JointSpec& spec) { return spec.name == name; });
  if (joint == tree.joints.end()) {
    std::vector<std::string> existing;
    for (const JointSpec& spec : tree.joints) existing.push_back(spec.name);
    refuse(origin, key + " does not exist" + did_you_mean(name, existing));
  }
  if (joint->type == JointType::Fixed) refuse(origin, key + " is fixed; wanted a moving joint");
  return *joint;
}

/// Removes the warning about a limit of 0 in the description, which the settings replace.
void drop_warning(TreeSpec& tree, const std::string& joint, const char* limit) {
  const std::string words = "joint " + in_quotes(joint) + ": <limit> has '" + limit + "' = 0";
  std::erase_if(tree.warnings, [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

}  // namespace

void set_limits(TreeSpec& tree, const std::string& name, const JointLimits& limits,
                const std::string& origin) {
  const std::string key = "limits: joint " + in_quotes(name);
  JointSpec& joint = moving_joint(tree, name, key, origin);
  const bool has_range = joint.type == JointType::Revolute || joint.type == JointType::Prismatic;
  if ((limits.lower || limits.upper) && !has_range) {
    refuse(origin, key + " cannot have 'lower' or 'upper'; wanted a revolute or prismatic joint");
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (limits.lower == infinity || limits.upper == -infinity)
    refuse(origin, key + " has no position between " + number(limits.lower.value_or(joint.lower)) +
                       " and " + number(limits.upper.value_or(joint.upper)));
  joint.lower = limits.lower.value_or(joint.lower);
  joint.upper = limits.upper.value_or(joint.upper);
  joint.velocity_limit = limits.velocity.value_or(joint.velocity_limit);
  joint.effort_limit = limits.effort.value_or(joint.effort_limit);
  if (limits.velocity) drop_warning(tree, name, "velocity");
  if (limits.effort) drop_warning(tree, name, "effort");
}

void set_figures(TreeSpec& tree, const std::string& name, const JointFigures& figures,
                 const std::string& origin) {
  JointSpec& joint = moving_joint(tree, name, "joints: joint " + in_quotes(name), origin);
  joint.armature = figures.armature.value_or(joint.armature);
  joint.damping = figures.damping.value_or(joint.damping);
  joint.friction = figures.friction.value_or(joint.friction);
  joint.stiffness = figures.stiffness.value_or(joint.stiffness);
  joint.rest = figures.rest.value_or(joint.rest);
  const double ratio = figures.gear_ratio.value_or(1.0);
  joint.armature += ratio * ratio * figures.rotor_inertia.value_or(0.0);
}

}  // namespace burnish

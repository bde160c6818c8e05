// What a robot's settings say of single joints, written over its description.
#pragma once

#include <string>

#include "burnish/model/tree_spec.hpp"
#include "robots/robot_settings.hpp"

namespace burnish {

/// Writes the limits over those of the joint `name`. Throws Error, with `origin` in front, for a
/// joint that does not exist or is fixed, and for a range of one that has none.
void set_limits(TreeSpec& tree, const std::string& name, const JointLimits& limits,
                const std::string& origin);
/// Writes armature, damping, friction and spring over those of the joint `name`. Throws Error, with
/// `origin` in front, for a joint that does not exist or is fixed.
void set_figures(TreeSpec& tree, const std::string& name, const JointFigures& figures,
                 const std::string& origin);

}  // namespace burnish

// Settings of single joints, which replace values of a robot's description.
#pragma once

#include <string>

#include "burnish/model/tree_spec.hpp"
#include "robots/robot_settings.hpp"

namespace burnish {

/// Replaces limits of the joint `name`. Throws Error for joints that do not exist or are fixed, and
/// for position limits of joints that cannot have any. Messages begin with `origin`.
void set_limits(TreeSpec& tree, const std::string& name, const JointLimits& limits,
                const std::string& origin);
/// Replaces armature, damping, friction and spring of the joint `name`. Throws Error for joints
/// that do not exist or are fixed. Messages begin with `origin`.
void set_figures(TreeSpec& tree, const std::string& name, const JointFigures& figures,
                 const std::string& origin);

}  // namespace burnish

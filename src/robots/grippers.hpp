// Detection of the finger joints of grippers and hands.
#pragma once

#include <set>
#include <string>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Returns the names of moving joints that are fingers. A hand is a link that at least two joints
/// carry, with two or more branches. Each branch has at most five joints in series, and at most
/// half the path length from the root to the hand. All joints of its branches are fingers.
///
/// A joint at the tip of any other branch is a finger if its name or the name of its link suggests
/// a finger or a jaw. A joint's name may also suggest a gripper.
std::set<std::string> finger_joints(const TreeSpec& tree);

}  // namespace burnish

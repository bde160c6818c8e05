// Fingers of grippers and hands, told from the joints of an arm.
#pragma once

#include <set>
#include <string>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Names of the moving joints that are fingers: they hold things and place no tool. Below a link
/// that at least two joints carry, these are all joints of two or more branches, each of at most
/// five joints in a row and at most half as long as the way from the root to that link. Where there
/// is one branch, it is its last joint if it or its link is named like a finger or a jaw, or the
/// joint like a gripper.
std::set<std::string> finger_joints(const TreeSpec& tree);

}  // namespace burnish

// Joints of a description that carry a tool.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Returns the names of the joints that move the link, joint or frame `name`. A mimic joint counts
/// as its leader. Empty if `name` does not exist.
///
/// Finger joints are not returned but added to `held`, because a gripper may move under load. If
/// only finger joints move `name`, the function returns them.
std::vector<std::string> arm_joints(const TreeSpec& tree, const std::string& name,
                                    std::vector<std::string>& held);

}  // namespace burnish

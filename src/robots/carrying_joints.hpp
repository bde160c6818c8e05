// Joints of a description that carry a tool.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Names of the joints that move `name`, a link, a joint or a frame, and of those that joints on
/// the way mimic; empty if there is no such thing. Fingers are left out and added to `held`:
/// nothing says that they hold still while they press. Where nothing but fingers carries it, they
/// are taken.
std::vector<std::string> arm_joints(const TreeSpec& tree, const std::string& name,
                                    std::vector<std::string>& held);

}  // namespace burnish

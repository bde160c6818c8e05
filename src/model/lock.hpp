// Locking of joints before a tree is compiled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Tree in which locked joints are fixed. A joint that still mimics another has a leader that moves
/// by itself.
struct LockedTree {
  TreeSpec tree;
  std::vector<std::string> locked;        ///< Names of locked joints, in the order of the tree
  std::map<std::string, FileJoint> held;  ///< Locked joints, and joints that the file holds
};

/// Locks the joints that the options select, and their followers. The tree must have passed
/// check_topology() and check_values().
LockedTree lock_joints(const TreeSpec& tree, const ModelOptions& options);

}  // namespace burnish

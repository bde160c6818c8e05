// Turning joints into fixed ones before a tree is compiled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// A tree in which the locked joints are fixed, and their names in the order of the tree; a joint
/// that still mimics another names one that mimics none.
struct LockedTree {
  TreeSpec tree;
  std::vector<std::string> locked;
  std::map<std::string, StatedJoint> held;  ///< by name: those locked and those that the tree holds
};

/// Locks what the options ask for, and what follows it. Assumes that the tree passed its checks.
LockedTree lock_joints(const TreeSpec& tree, const ModelOptions& options);

}  // namespace burnish

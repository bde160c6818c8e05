// Turning joints into fixed ones before a tree is compiled.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// A tree in which the locked joints are fixed, and their names in the order of the tree.
struct LockedTree {
  TreeSpec tree;
  std::vector<std::string> locked;
};

/// Locks what the options ask for. Assumes that the tree passed its checks. A mimic joint must end
/// up locked: at the posture's value, or else at the one that its locked leader gives.
LockedTree lock_joints(const TreeSpec& tree, const ModelOptions& options);

}  // namespace burnish

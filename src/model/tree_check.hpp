// Whether a TreeSpec is a tree, and whether what it carries is physical.
#pragma once

#include "burnish/model/tree_spec.hpp"

namespace burnish {

inline constexpr std::size_t max_links = 2000;  ///< of one tree
inline constexpr int max_depth = 500;           ///< links from the root to a tip

/// Published inertias are rounded: principal moments may break the triangle inequality
/// I_1 + I_2 >= I_3 by this fraction of the largest one before they are refused.
inline constexpr double inertia_tolerance = 0.05;

/// Names are unique and known, each link but one has one parent, there is no cycle, and the tree
/// has at most max_links links and is at most max_depth deep. Looks at names only.
void check_topology(const TreeSpec& tree);

/// Every number is finite (limits may be infinite), masses and inertias are physical, moving
/// joints have an axis, limits are in order. Assumes nothing about the topology.
void check_values(const TreeSpec& tree);

}  // namespace burnish

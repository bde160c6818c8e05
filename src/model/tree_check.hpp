// Whether a TreeSpec is a tree, and whether what it carries is physical.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

inline constexpr std::size_t max_links = 2000;  ///< of one tree
inline constexpr int max_depth = 500;           ///< links from the root to a tip

/// Published inertias are rounded: principal moments may break the triangle inequality
/// I_1 + I_2 >= I_3 by this fraction of the largest one before they are odd.
inline constexpr double inertia_tolerance = 0.05;

/// Notes as problems: names that are missing, used twice or unknown; links with two parents; more
/// than one root; cycles; more than max_links links, more than max_depth of them one behind the
/// other; loops without a name, directions or known links, or of a link with itself. Looks at names
/// only.
void check_topology(const TreeSpec& tree, Findings& findings);

/// Notes as problems: numbers that are not finite (limits may be infinite) or have a sign that
/// cannot be meant, moving joints without an axis, limits that are not in order. Notes as warnings:
/// inertias that no solid has. Assumes nothing about the topology.
void check_values(const TreeSpec& tree, Findings& findings);

}  // namespace burnish

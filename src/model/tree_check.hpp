// Checks of a TreeSpec: it is a tree, and its values are physical.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

inline constexpr std::size_t max_links = 2000;  ///< Largest number of links, chosen by hand
inline constexpr int max_depth = 500;  ///< Largest number of links from root to tip, chosen by hand

/// Largest violation of the triangle inequality I_1 + I_2 >= I_3 of principal moments, as a
/// fraction of the largest moment. Allows for rounding of published inertias; chosen by hand.
inline constexpr double inertia_tolerance = 0.05;

/// Reports these problems:
///  - names that are missing, used twice or unknown;
///  - links with two parents, more than one root, cycles;
///  - more than max_links links, or a depth of more than max_depth links;
///  - invalid loops (check_loops()).
void check_topology(const TreeSpec& tree, Findings& findings);

/// Reports as problems: numbers that are not finite (limits may be infinite), numbers with a wrong
/// sign, moving joints without an axis, lower limits above upper limits. Warns of inertias that no
/// solid has. Does not require a valid topology.
void check_values(const TreeSpec& tree, Findings& findings);

}  // namespace burnish

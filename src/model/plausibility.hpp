// Whether the numbers of a description can be meant: units of limits, masses, lengths and inertias.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Warns of figures that compute but that no robot has: limits in degrees, masses in g, lengths in
/// mm, inertias of no such size, and others that docs/robots.md lists. Assumes that the tree passed
/// check_topology and check_values.
void check_plausibility(const TreeSpec& tree, const ModelOptions& options, Findings& findings);

}  // namespace burnish

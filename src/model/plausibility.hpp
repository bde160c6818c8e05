// Plausibility checks of a description: units of limits, masses, lengths and inertias.
#pragma once

#include "base/findings.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Warns of valid but implausible numbers: limits in degrees, masses in g, lengths in mm, inertias
/// of a wrong size, and others that docs/robots.md lists. The tree must have passed
/// check_topology() and check_values().
void check_plausibility(const TreeSpec& tree, const ModelOptions& options, Findings& findings);

}  // namespace burnish

// Expands the segments of a horizon into knots.
#pragma once

#include <vector>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// Stages and steps of all knots except the terminal one.
struct HorizonKnots {
  std::vector<int> stages;        ///< Index of each knot's stage
  std::vector<double> own_steps;  ///< Step of each knot [s]; 0: the step of its stage
};

/// Throws Error for an unknown stage, and for invalid numbers of knots and invalid steps.
HorizonKnots knots_of(const ProblemSpec& spec);

}  // namespace burnish::ocp

// The knots that the segments of a horizon make.
#pragma once

#include <vector>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// Without the terminal one.
struct HorizonKnots {
  std::vector<int> stages;        ///< index of each knot's stage
  std::vector<double> own_steps;  ///< s, of the knot's own; 0: its stage's
};

/// Throws Error for an unknown stage, numbers of knots and steps that cannot be.
HorizonKnots knots_of(const ProblemSpec& spec);

}  // namespace burnish::ocp

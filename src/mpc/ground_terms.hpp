// Terms of a problem that limit the force on a support through friction cones and pressure limits.
#pragma once

#include <vector>

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Constraint or cost with the coefficient of friction under a support as its target.
struct GroundTerm {
  int term;         ///< Index of the term in its stage; costs come first.
  int support;      ///< Index of the support in supports_of().
  double friction;  ///< Coefficient of friction in the specification.
};

/// Returns the ground terms of each stage of the problem.
std::vector<std::vector<GroundTerm>> ground_terms(const MpcSpec& spec);

/// Friction and sole size of a support in plans. Each figure is from the first term of the problem
/// that defines it.
struct GroundFigures {
  double friction;        ///< Coefficient of the friction cone; infinite: no cone.
  double half_x, half_y;  ///< Half sides of the sole [m]; 0: no pressure limit with friction.
};
GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact);

}  // namespace burnish

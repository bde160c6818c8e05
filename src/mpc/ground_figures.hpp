// Friction and sole size of supports, from the friction cones and pressure limits in plans.
#pragma once

#include <string>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish {

/// Returns the friction coefficient of a residual that limits the force of this contact by
/// friction, such as a friction cone; 0 for any other residual.
double friction_of(const Residual& residual, const std::string& contact);

/// Friction and sole size of a support in plans. Each value is taken from the first term of the
/// problem that defines it.
struct GroundFigures {
  double friction;        ///< Coefficient of the friction cone; infinite: no cone.
  double half_x, half_y;  ///< Half sides of the sole [m]; 0: no pressure limit with friction.
};
GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact);

}  // namespace burnish

#include "mpc/ground_figures.hpp"

#include <cmath>
#include <limits>

namespace burnish {

double friction_of(const Residual& residual, const std::string& contact) {
  if (const auto* cone = std::get_if<residual::FrictionCone>(&residual))
    return cone->contact == contact ? cone->friction : 0.0;
  if (const auto* pressure = std::get_if<residual::CenterOfPressure>(&residual))
    return pressure->contact == contact ? pressure->friction : 0.0;
  return 0.0;
}

GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact) {
  GroundFigures figures{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const auto see = [&](const Residual& residual) {
    if (const auto* cone = std::get_if<residual::FrictionCone>(&residual);
        cone != nullptr && cone->contact == contact && std::isinf(figures.friction))
      figures.friction = cone->friction;
    const auto* pressure = std::get_if<residual::CenterOfPressure>(&residual);
    if (pressure == nullptr || pressure->contact != contact || pressure->friction == 0.0) return;
    figures.half_x = pressure->half_x;
    figures.half_y = pressure->half_y;
  };
  for (const Stage& stage : problem.stages) {
    for (const CostTerm& cost : stage.costs) see(cost.residual);
    for (const Constraint& constraint : stage.constraints) see(constraint.residual);
  }
  return figures;
}

}  // namespace burnish

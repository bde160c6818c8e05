#include "mpc/ground_figures.hpp"

#include <cmath>
#include <limits>

namespace burnish {

double friction_of(const Residual& residual, const std::string& contact) {
  return std::visit(
      [&](const auto& of) {
        if constexpr (requires { of.contact, of.friction; })
          if (of.contact == contact) return of.friction;
        return 0.0;
      },
      residual);
}

GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact) {
  GroundFigures figures{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const auto see = [&](const Residual& residual) {
    const double friction = friction_of(residual, contact);
    if (friction == 0.0) return;
    std::visit(
        [&](const auto& of) {
          if constexpr (requires { of.half_x, of.half_y; }) {
            figures.half_x = of.half_x;
            figures.half_y = of.half_y;
          } else if (std::isinf(figures.friction)) {
            figures.friction = friction;
          }
        },
        residual);
  };
  for (const Stage& stage : problem.stages) {
    for (const CostTerm& cost : stage.costs) see(cost.residual);
    for (const Constraint& constraint : stage.constraints) see(constraint.residual);
  }
  return figures;
}

}  // namespace burnish

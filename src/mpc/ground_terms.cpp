#include "mpc/ground_terms.hpp"

#include <cmath>
#include <limits>

#include "mpc/closed_dynamics.hpp"

namespace burnish {
namespace {

/// Returns the friction coefficient in a friction cone or pressure limit of this contact; 0 for any
/// other residual.
double friction_of(const Residual& residual, const std::string& contact) {
  if (const auto* cone = std::get_if<residual::FrictionCone>(&residual))
    return cone->contact == contact ? cone->friction : 0.0;
  if (const auto* pressure = std::get_if<residual::CenterOfPressure>(&residual))
    return pressure->contact == contact ? pressure->friction : 0.0;
  return 0.0;
}

template <class See>
void each_term(const Stage& stage, const See& see) {
  int term = 0;
  for (const CostTerm& cost : stage.costs) see(term++, cost.residual);
  for (const Constraint& constraint : stage.constraints) see(term++, constraint.residual);
}

}  // namespace

std::vector<std::vector<GroundTerm>> ground_terms(const MpcSpec& spec) {
  const std::vector<ContactSpec> supports = supports_of(spec);
  std::vector<std::vector<GroundTerm>> result;
  for (const Stage& stage : spec.problem.stages) {
    std::vector<GroundTerm>& terms = result.emplace_back();
    each_term(stage, [&](int term, const Residual& residual) {
      for (std::size_t i = 0; i < supports.size(); ++i)
        if (const double friction = friction_of(residual, supports[i].name); friction > 0.0)
          terms.push_back({term, static_cast<int>(i), friction});
    });
  }
  return result;
}

GroundFigures ground_figures(const ProblemSpec& problem, const std::string& contact) {
  GroundFigures figures{std::numeric_limits<double>::infinity(), 0.0, 0.0};
  for (const Stage& stage : problem.stages)
    each_term(stage, [&](int /*term*/, const Residual& residual) {
      if (const auto* cone = std::get_if<residual::FrictionCone>(&residual);
          cone != nullptr && cone->contact == contact && std::isinf(figures.friction))
        figures.friction = cone->friction;
      const auto* pressure = std::get_if<residual::CenterOfPressure>(&residual);
      if (pressure == nullptr || pressure->contact != contact || pressure->friction == 0.0) return;
      figures.half_x = pressure->half_x;
      figures.half_y = pressure->half_y;
    });
  return figures;
}

}  // namespace burnish

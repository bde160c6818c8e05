#include "ocp/row_weights.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"

namespace burnish::ocp {
namespace {

/// Returns a typical magnitude of a row. This is the robot's limit of the row's quantity, the
/// robot's weight for a force, the limit of the row for a distance, or half the width of a support
/// polygon. Returns 0 for other quantities.
double derived_scale(const Residual& residual, const CompiledTerm& term,
                     const CompiledProblem& problem, std::size_t row) {
  const Model& model = problem.model;
  const double weight = model.total_mass() * model.gravity.norm();
  if (std::holds_alternative<residual::ContactForce>(residual) ||
      std::holds_alternative<residual::FrictionCone>(residual))
    return weight;
  if (const auto* pressure = std::get_if<residual::CenterOfPressure>(&residual))
    return weight * std::min(pressure->half_x, pressure->half_y);
  if (std::holds_alternative<FrameDistance>(term.residual))
    return std::isfinite(term.upper[row]) ? term.upper[row] : term.lower[row];
  if (const auto* rate = std::get_if<TorqueRate>(&term.residual))
    return rate->per_second *
           model.effort_limit[problem.layout.actuated[to_size(rate->entries[row])]];
  if (const auto* rate = std::get_if<ForceRate>(&term.residual)) return rate->per_second * weight;
  if (const auto* margin = std::get_if<SupportMargin>(&term.residual))
    return margin->edges[row].half_width;
  const auto* selected = std::get_if<Selection>(&term.residual);
  if (selected == nullptr) return 0.0;
  const int entry = selected->entries[row];
  switch (selected->source) {
    case Selection::Source::Q:
      return 0.5 * (model.q_upper[entry] - model.q_lower[entry]);
    case Selection::Source::V:
      return model.velocity_limit[entry];
    case Selection::Source::TorqueState:
    case Selection::Source::U:
      return model.effort_limit[problem.layout.actuated[to_size(entry)]];
  }
  return 0.0;
}

/// Returns the scale of a row: half the distance between its limits, or derived_scale() if this
/// distance is zero or infinite.
double scale_of(const Residual& residual, const CompiledTerm& term, const CompiledProblem& problem,
                const std::string& where, std::size_t row) {
  const auto is_valid = [](double scale) { return scale > 0.0 && std::isfinite(scale); };
  if (std::isinf(term.lower[row]) && std::isinf(term.upper[row])) return 1.0;  // no limits
  const double half = 0.5 * (term.upper[row] - term.lower[row]);
  if (is_valid(half)) return half;
  const double derived = derived_scale(residual, term, problem, row);
  if (!is_valid(derived))
    throw Error(where + ": row " + in_quotes(term.row_names[row]) +
                " needs a scale, because the distance between its limits is 0 or infinite and the "
                "robot has no limit for it; wanted a scale: a typical magnitude of the row, in the "
                "row's unit");
  return derived;
}

void check_weights(const Constraint& constraint, const std::string& where) {
  const double l1_weight = constraint.l1_weight, quadratic_weight = constraint.quadratic_weight;
  if (!(l1_weight >= 0.0))
    throw Error(where + ": l1_weight is " + number(l1_weight) + "; wanted at least 0");
  if (!(quadratic_weight >= 0.0) || !std::isfinite(quadratic_weight))
    throw Error(where + ": quadratic_weight is " + number(quadratic_weight) +
                "; wanted a number of at least 0");
  if (l1_weight == 0.0 && quadratic_weight == 0.0)
    throw Error(where +
                ": l1_weight and quadratic_weight are 0, so a violation costs nothing; wanted "
                "at least one of the two weights above 0");
  if (std::isinf(l1_weight) && quadratic_weight > 0.0)
    throw Error(where + ": l1_weight is infinite, so a quadratic_weight of " +
                number(quadratic_weight) +
                " has no effect; wanted a finite l1_weight, such as 0, or quadratic_weight 0");
}

}  // namespace

void add_row_weights(const Constraint& constraint, const Residual& residual,
                     const CompiledTerm& term, const CompiledProblem& problem,
                     const std::string& where, CompiledStage& stage) {
  check_weights(constraint, where);
  const Eigen::VectorXd& scale = constraint.scale;
  if (scale.size() > 1 && scale.size() != term.rows)
    throw Error(where + ": scale has " + std::to_string(scale.size()) + " entries; wanted 1 or " +
                std::to_string(term.rows));
  for (int i = 0; i < term.rows; ++i) {
    const double given = scale.size() == 0 ? scale_of(residual, term, problem, where, to_size(i))
                                           : scale[scale.size() == 1 ? 0 : i];
    if (!(given > 0.0) || !std::isfinite(given))
      throw Error(where + ": scale is " + number(given) + "; wanted a positive number");
    stage.row_scale.push_back(given);
    stage.row_l1_weight.push_back(constraint.l1_weight);
    stage.row_quadratic_weight.push_back(constraint.quadratic_weight);
  }
}

}  // namespace burnish::ocp

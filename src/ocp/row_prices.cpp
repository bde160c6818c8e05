#include "ocp/row_prices.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish::ocp {
namespace {

/// The robot's own limit of what the row is, its weight where that is a force, the limit itself of
/// a distance, half the width of a support polygon; 0 where nothing is known.
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
           model
               .effort_limit[problem.layout.actuated[static_cast<std::size_t>(rate->entries[row])]];
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
      return model.effort_limit[problem.layout.actuated[static_cast<std::size_t>(entry)]];
  }
  return 0.0;
}

/// What counts as much of a row: half the distance of its limits, or what is derived where they
/// have none.
double scale_of(const Residual& residual, const CompiledTerm& term, const CompiledProblem& problem,
                const std::string& where, std::size_t row) {
  const auto counts = [](double scale) { return scale > 0.0 && std::isfinite(scale); };
  if (std::isinf(term.lower[row]) && std::isinf(term.upper[row])) return 1.0;  // nothing to violate
  const double half = 0.5 * (term.upper[row] - term.lower[row]);
  if (counts(half)) return half;
  const double derived = derived_scale(residual, term, problem, row);
  if (!counts(derived))
    throw Error(
        where + ": row " + in_quotes(term.row_names[row]) +
        " has no range, nor a limit of the robot, to scale by; wanted scale: what counts as "
        "much of it, in its unit");
  return derived;
}

void check_prices(const Constraint& constraint, const std::string& where) {
  const double price = constraint.price, square = constraint.square;
  if (!(price >= 0.0))
    throw Error(where + ": its price is " + number(price) + "; wanted at least 0");
  if (!(square >= 0.0) || !std::isfinite(square))
    throw Error(where + ": its square is " + number(square) + "; wanted a number of at least 0");
  if (price == 0.0 && square == 0.0)
    throw Error(where +
                ": its price and square are 0, so that it is nothing to break it; wanted one of "
                "them");
  if (std::isinf(price) && square > 0.0)
    throw Error(where + ": it is hard, so that its square of " + number(square) +
                " would never count; wanted a price beside it, or 0 for the square alone");
}

}  // namespace

void add_row_prices(const Constraint& constraint, const Residual& residual,
                    const CompiledTerm& term, const CompiledProblem& problem,
                    const std::string& where, CompiledStage& stage) {
  check_prices(constraint, where);
  const Eigen::VectorXd& scale = constraint.scale;
  if (scale.size() > 1 && scale.size() != term.rows)
    throw Error(where + ": its scale has " + std::to_string(scale.size()) +
                " entries; wanted 1 or " + std::to_string(term.rows));
  for (int i = 0; i < term.rows; ++i) {
    const double given = scale.size() == 0
                             ? scale_of(residual, term, problem, where, static_cast<std::size_t>(i))
                             : scale[scale.size() == 1 ? 0 : i];
    if (!(given > 0.0) || !std::isfinite(given))
      throw Error(where + ": its scale is " + number(given) + "; wanted a positive number");
    stage.row_scale.push_back(given);
    stage.row_price.push_back(constraint.price);
    stage.row_square.push_back(constraint.square);
  }
}

}  // namespace burnish::ocp

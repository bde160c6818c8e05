// Compiles costs and constraints: penalties, limits and weights.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "ocp/residual_rows.hpp"
#include "ocp/row_weights.hpp"
#include "ocp/term_builder.hpp"

namespace burnish::ocp {

bool TermBuilder::is_margin() const {
  return std::holds_alternative<residual::FrictionCone>(residual) ||
         std::holds_alternative<residual::CenterOfPressure>(residual) ||
         std::holds_alternative<residual::SupportMargin>(residual);
}

void TermBuilder::finish_penalty(const CostTerm& cost) {
  const Penalty penalty =
      cost.penalty.value_or(is_margin() ? Penalty::at_least(0.0) : Penalty::quadratic());
  term.penalty = penalty.kind;
  term.width = penalty.width;
  if (!(penalty.width > 0.0) || !std::isfinite(penalty.width))
    refuse("the penalty's width is " + number(penalty.width) + "; wanted a positive number");
  finish_limits(penalty.lower, penalty.upper, "the penalty's ");
}

void TermBuilder::finish_limits(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                                const std::string& of) {
  const auto rows = to_size(term.rows);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto limits = [&](const Eigen::VectorXd& given, double none, const char* name) {
    if (given.size() > 1 && given.size() != term.rows)
      refuse(of + std::string(name) + " limit has " + std::to_string(given.size()) +
             " entries; wanted 1 or " + std::to_string(term.rows));
    std::vector<double> result(rows, given.size() == 1 ? given[0] : none);
    if (given.size() == term.rows) result.assign(given.begin(), given.end());
    if (std::any_of(result.begin(), result.end(), [](double x) { return std::isnan(x); }))
      refuse(of + std::string(name) + " limit holds a NaN");
    return result;
  };
  const auto row = [&](std::size_t i) {
    return term.row_names.empty() ? std::to_string(i) : in_quotes(term.row_names[i]);
  };
  term.lower = limits(lower, -infinity, "lower");
  term.upper = limits(upper, infinity, "upper");
  for (std::size_t i = 0; i < rows; ++i) {
    if (term.lower[i] == infinity || term.upper[i] == -infinity)
      refuse(of + "limits of row " + row(i) +
             " exclude every number; wanted a lower limit below infinity and an upper limit above "
             "-infinity");
    if (term.lower[i] > term.upper[i])
      refuse(of + "lower limit " + number(term.lower[i]) + " is above the upper limit " +
             number(term.upper[i]));
  }
}

void TermBuilder::finish_constraint(const Constraint& constraint) {
  Eigen::VectorXd lower = constraint.lower;
  if (lower.size() == 0 && constraint.upper.size() == 0) {
    if (!is_margin()) refuse("it has no limits; wanted a lower or an upper limit");
    lower = Eigen::VectorXd::Zero(1);
  }
  finish_limits(lower, constraint.upper, "the ");
  term.first_row = stage.rows();
  stage.row_lower.insert(stage.row_lower.end(), term.lower.begin(), term.lower.end());
  stage.row_upper.insert(stage.row_upper.end(), term.upper.begin(), term.upper.end());
  find_entries();
  find_curvatures();
  add_row_weights(constraint, residual, term, problem, where, stage);
}

void TermBuilder::find_entries() {
  std::vector<int> entries(to_size(term.rows), -1);
  const auto* selected = std::get_if<Selection>(&term.residual);
  const bool is_bounded = spec.control_lower.size() > 0 || spec.control_upper.size() > 0;
  bool alone = selected != nullptr && !(selected->source == Selection::Source::U && is_bounded);
  for (int i = 0; alone && i < term.rows; ++i) {
    const int entry = term.blocks[0].columns[to_size(i)] - layout().nu + stage.nu;
    const auto taken = [&](const std::vector<int>& all) {
      return std::find(all.begin(), all.end(), entry) != all.end();
    };
    alone = !taken(stage.row_entry) && !taken(entries);
    entries[to_size(i)] = entry;
  }
  if (!alone) std::fill(entries.begin(), entries.end(), -1);
  stage.row_entry.insert(stage.row_entry.end(), entries.begin(), entries.end());
  term.first_coefficients = alone ? -1 : stage.coefficient_rows;
  if (!alone) stage.coefficient_rows += term.rows;
}

/// Adds the curvature of a row if this curvature can enlarge the Hessian. Convex rows (sign 1) can
/// enlarge the Hessian at an upper limit, concave rows (sign -1) at a lower limit.
void TermBuilder::find_curvatures() {
  std::visit(
      [&](const auto& compiled) {
        if constexpr (requires { compiled.curvature_rows(); }) {
          const int count = compiled.curvature_rows();
          const double sign = compiled.curvature_sign;
          if (count == 0 || !std::isfinite(sign > 0.0 ? term.upper[0] : term.lower[0])) return;
          term.first_curvature = stage.curvature_rows;
          stage.curvatures.push_back({term.first_row, stage.curvature_rows, count, sign});
          stage.curvature_rows += term.curvature_rows = count;
        }
      },
      term.residual);
}

void TermBuilder::finish_weights(const CostTerm& cost) {
  if (!(cost.weight >= 0.0) || !std::isfinite(cost.weight))
    refuse("the weight is " + number(cost.weight) + "; wanted a number of at least 0");
  if (cost.weights.size() != 0 && cost.weights.size() != term.rows)
    refuse("it has " + std::to_string(cost.weights.size()) + " row weights; wanted " +
           std::to_string(term.rows));
  term.weight = cost.weight;
  for (int i = 0; i < term.rows; ++i) {
    const double w = cost.weights.size() == 0 ? 1.0 : cost.weights[i];
    if (!(w >= 0.0) || !std::isfinite(w))
      refuse("row weight " + std::to_string(i) + " is " + number(w) +
             "; wanted a number of at least 0");
    term.weights.push_back(w);
  }
}

void compile_terms(const ProblemSpec& spec, const CompiledProblem& problem,
                   const std::vector<CostTerm>& costs, const std::vector<Constraint>& constraints,
                   const std::string& place, CompiledStage& stage) {
  const auto add = [&](const auto& given, const char* kind, const auto& finish) {
    std::string name = given.name.empty() ? name_of(given.residual) : given.name;
    TermBuilder builder{spec,  problem, given.residual,
                        stage, {},      place + ", " + kind + " " + in_quotes(name)};
    for (const CompiledTerm& other : stage.terms)
      if (other.name == name) builder.refuse("the name is used twice in this stage");
    builder.term.name = std::move(name);
    compile_residual(builder);
    builder.term.row_names = row_names(spec.model, residual_rows(spec, given.residual).groups);
    finish(builder);
    CompiledTerm& term = builder.term;
    for (const JacobianBlock& block : term.blocks) term.jacobian_size += block.size();
    term.target = stage.targets;
    stage.targets += term.target_size;
    try {
      problem.inputs.use(given, term, builder.surface(), stage);
    } catch (const Error& error) {
      builder.refuse(error.what());
    }
    stage.terms.push_back(std::move(term));
  };
  for (const CostTerm& cost : costs)
    add(cost, "term", [&](TermBuilder& builder) {
      builder.finish_penalty(cost);
      builder.finish_weights(cost);
    });
  stage.costs = stage.terms.size();
  for (const Constraint& constraint : constraints)
    add(constraint, "constraint",
        [&](TermBuilder& builder) { builder.finish_constraint(constraint); });
}

}  // namespace burnish::ocp

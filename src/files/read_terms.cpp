#include "files/read_terms.hpp"

#include <limits>

#include "base/sentence.hpp"
#include "files/read_inputs.hpp"
#include "files/read_penalty.hpp"
#include "files/read_residual.hpp"
#include "files/residual_target.hpp"

namespace burnish::files {
namespace {

CostTerm read_cost(const ProblemScope& scope, const std::vector<std::string>& contacts,
                   const std::string& name, const Reader& reader) {
  CostTerm term{
      .name = name,
      .residual = read_residual(scope, contacts, reader,
                                with_input_keys({"type", "weight", "weights", "penalty"}))};
  const bool is_state = std::holds_alternative<residual::State>(term.residual);
  const ocp::ResidualRows rows = ocp::residual_rows(scope.spec, term.residual);
  if (const auto weight = reader.find("weight")) term.weight = weight->not_negative();
  if (const auto weights = reader.find("weights"))
    term.weights =
        is_state ? read_state_weights(scope, *weights) : read_rows(*weights, rows.groups, 1.0);
  else if (is_state)
    term.weights = default_state_weights(scope);
  if (const auto penalty = reader.find("penalty")) term.penalty = read_penalty(rows, *penalty);
  read_term_inputs(reader, scope.spec, term);
  return term;
}

Constraint read_constraint(const ProblemScope& scope, const std::vector<std::string>& contacts,
                           const std::string& name, const Reader& reader) {
  if (reader["type"].is("state"))
    reader["type"].refuse(
        "the residual 'state' cannot be a constraint; wanted 'joint_position', 'joint_velocity' or "
        "'joint_torque'");
  Constraint constraint{
      .name = name,
      .residual = read_residual(scope, contacts, reader,
                                with_input_keys({"type", "lower", "upper", "limits", "scale",
                                                 "l1_weight", "quadratic_weight"}))};
  const ocp::ResidualRows rows = ocp::residual_rows(scope.spec, constraint.residual);
  const RowLimits limits = read_limits(rows, reader);
  constraint.lower = limits.lower;
  constraint.upper = limits.upper;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (const auto scale = reader.find("scale"))
    constraint.scale = read_rows(*scale, rows.groups, infinity);
  if (const auto l1_weight = reader.find("l1_weight"); l1_weight && !l1_weight->is("hard"))
    constraint.l1_weight = l1_weight->not_negative();
  if (const auto weight = reader.find("quadratic_weight"))
    constraint.quadratic_weight = weight->not_negative();
  read_term_inputs(reader, scope.spec, constraint);
  return constraint;
}

}  // namespace

std::vector<Constraint> read_constraints(const ProblemScope& scope,
                                         const std::vector<std::string>& contacts,
                                         const Reader& reader) {
  std::vector<Constraint> constraints;
  for (const auto& [name, value] : reader.items())
    constraints.push_back(read_constraint(scope, contacts, name, value));
  return constraints;
}

void check_shared(const Reader& shared) {
  for (const auto& [name, term] : shared.items()) check_residual_type(term["type"]);
}

std::vector<CostTerm> read_costs(const ProblemScope& scope, const std::optional<Reader>& shared,
                                 const std::vector<std::string>& contacts, const Reader& reader) {
  std::vector<std::string> known;
  if (shared)
    for (const auto& [name, term] : shared->items()) known.push_back(name);
  std::vector<CostTerm> terms;
  for (const auto& [name, value] : reader.items()) {
    if (value.is_map() && value.has("type")) {
      terms.push_back(read_cost(scope, contacts, name, value));
      continue;
    }
    const auto base = shared ? shared->find(name) : std::nullopt;
    if (!base)
      value.refuse(known.empty() ? "it has no 'type', and the file has no costs in 'terms'; "
                                   "wanted a 'type'"
                                 : "it has no 'type', and 'terms' has no cost of this name; "
                                   "wanted a 'type', or the name of a cost in 'terms'" +
                                       did_you_mean(name, known));
    if (value.is_map()) {
      terms.push_back(read_cost(scope, contacts, name, base->changed_by(value)));
    } else {
      const double weight = value.not_negative();
      terms.push_back(read_cost(scope, contacts, name, *base));
      terms.back().weight = weight;
    }
  }
  return terms;
}

}  // namespace burnish::files

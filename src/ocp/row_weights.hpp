// Scales and penalty weights of constraint rows.
#pragma once

#include <string>

#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// Adds the scale, the L1 weight and the quadratic weight of each row of a compiled constraint to
/// the stage. Throws Error for invalid weights, and for a row whose scale is neither given nor
/// derived from limits. The message begins with `where`.
void add_row_weights(const Constraint& constraint, const Residual& residual,
                     const CompiledTerm& term, const CompiledProblem& problem,
                     const std::string& where, CompiledStage& stage);

}  // namespace burnish::ocp

// What breaking a constraint's rows costs, and what counts as much of each.
#pragma once

#include <string>

#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

/// Adds scale, price and square of each row of a compiled constraint to the stage. `where` begins
/// the sentence of an Error: for prices that mean nothing, and for rows without anything to scale
/// by.
void add_row_prices(const Constraint& constraint, const Residual& residual,
                    const CompiledTerm& term, const CompiledProblem& problem,
                    const std::string& where, CompiledStage& stage);

}  // namespace burnish::ocp

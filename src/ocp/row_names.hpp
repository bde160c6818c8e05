// What the rows of a residual are called.
#pragma once

#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"
#include "ocp/compiled_problem.hpp"

namespace burnish::ocp {

std::vector<std::string> row_names(const Problem& problem, const CompiledTerm& term);

}  // namespace burnish::ocp

// What a cost or a constraint measures, as files state it: the keys that its description has.
#pragma once

#include "files/problem_scope.hpp"

namespace burnish::files {

/// Refuses a type that is none.
void check_residual_type(const Reader& type);

/// Reads `type` and what it has; `also`: keys that the caller reads. `contacts` hold.
Residual read_residual(const ProblemScope& scope, const std::vector<std::string>& contacts,
                       const Reader& reader, std::vector<std::string> also);

}  // namespace burnish::files

// Reads the residual of a cost or a constraint by its description.
#pragma once

#include "files/problem_scope.hpp"

namespace burnish::files {

/// Throws Error with the place and the nearest known type if `type` names no residual.
void check_residual_type(const Reader& type);

/// Reads the key `type` and the keys of that type. `contacts` are the active contacts of the stage.
/// `also` are further allowed keys, which the caller reads. Throws Error with the place.
Residual read_residual(const ProblemScope& scope, const std::vector<std::string>& contacts,
                       const Reader& reader, std::vector<std::string> also);

}  // namespace burnish::files

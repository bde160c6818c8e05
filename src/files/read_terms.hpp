// Reads the costs and constraints of a problem file.
#pragma once

#include "files/read_target.hpp"

namespace burnish::files {

/// Reads the costs of a stage, a map from names to
///  - the weight of a shared term,
///  - changes of a shared term,
///  - or a new term {type: ..., ...}.
/// `shared` is the optional key `terms` of the file. `contacts` are active in the stage.
std::vector<CostTerm> read_costs(const ProblemScope& scope, const std::optional<Reader>& shared,
                                 const std::vector<std::string>& contacts, const Reader& reader);

/// Reads the constraints of a stage: {name: {type: ..., lower: ..., upper: ..., limits: fraction of
/// the robot's limits}, ...}. `contacts` are active in the stage.
std::vector<Constraint> read_constraints(const ProblemScope& scope,
                                         const std::vector<std::string>& contacts,
                                         const Reader& reader);

/// Checks the types of all shared terms, even of terms that no stage uses. Throws Error with the
/// place.
void check_shared(const Reader& shared);

}  // namespace burnish::files

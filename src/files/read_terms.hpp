// Costs and constraints of a problem file.
#pragma once

#include "files/read_target.hpp"

namespace burnish::files {

/// Reads `costs` of a stage: {name: weight of a shared term, or {type: ..., ...}, or changes of a
/// shared term}. `shared` is the file's key `terms`, where there is one. `contacts` hold.
std::vector<CostTerm> read_costs(const ProblemScope& scope, const std::optional<Reader>& shared,
                                 const std::vector<std::string>& contacts, const Reader& reader);

/// Reads `constraints` of a stage: {name: {type: ..., lower: ..., upper: ..., limits: fraction of
/// the robot's limits}, ...}. `contacts` are active.
std::vector<Constraint> read_constraints(const ProblemScope& scope,
                                         const std::vector<std::string>& contacts,
                                         const Reader& reader);

/// Refuses shared terms that are badly formed even where no stage uses them.
void check_shared(const Reader& shared);

}  // namespace burnish::files

// Reads targets of residuals: numbers, values at the start, torques and forces at rest, and paths.
#pragma once

#include "files/read_target.hpp"

namespace burnish::files {

/// Value of a key `target`, with the problem and the stage that it may refer to.
struct TargetText {
  const ProblemScope& scope;
  const std::vector<std::string>& contacts;  ///< Active contacts of the stage, by name
  const Reader& reader;
};

/// Reads the target of a residual whose other keys have been read. Throws Error with the place if
/// the target does not fit the residual.
Signal read_target_of(const Residual& residual, const TargetText& text);

/// Reads the row weights of a residual State: a list, {q: ..., v: ..., tau: ...} with values for
/// read_rows(), or one number that scales default_state_weights().
Eigen::VectorXd read_state_weights(const ProblemScope& scope, const Reader& reader);
/// Returns the default row weights of a residual State: 0 for torques and forces that the state
/// keeps from the previous step, 1 for all other rows. Empty if all weights are 1.
Eigen::VectorXd default_state_weights(const ProblemScope& scope);

}  // namespace burnish::files

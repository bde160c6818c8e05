// Targets of residuals in files: where things are at the start, what holds the robot, and paths.
#pragma once

#include "files/read_target.hpp"

namespace burnish::files {

/// The value of a key `target` and what it may refer to.
struct TargetText {
  const ProblemScope& scope;
  const std::vector<std::string>& contacts;  ///< that hold
  const Reader& reader;
};

/// Reads the target of a residual, all else of which has been read.
Signal read_target_of(const Residual& residual, const TargetText& text);

/// {q: ..., v: ..., tau: ...} of a difference of states, each one number for all rows or as
/// read_rows() has it; or one number for what moves; or a list.
Eigen::VectorXd read_state_weights(const ProblemScope& scope, const Reader& reader);
/// Where none are said: what is remembered is no motion, it costs where it is said to. Empty: one
/// for all.
Eigen::VectorXd default_state_weights(const ProblemScope& scope);

}  // namespace burnish::files

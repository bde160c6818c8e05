// Reads penalties and limits of residuals in a problem file.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

/// Limits of the rows of a residual.
struct RowLimits {
  Eigen::VectorXd lower = {}, upper = {};  ///< One limit for each row; empty: no limits
};

/// Reads the keys lower, upper and limits of a map. `limits` is a fraction of the robot's limits.
RowLimits read_limits(const ocp::ResidualRows& rows, const Reader& reader);

/// Reads quadratic, {barrier: limits}, {barrier: {lower, upper, limits}}, {smooth_absolute: width}
/// or {log_barrier: {lower, upper, limits, width}}.
Penalty read_penalty(const ocp::ResidualRows& rows, const Reader& reader);

}  // namespace burnish::files

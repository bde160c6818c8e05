// What a residual costs and where its limits are, in a problem file.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

struct RowLimits {
  Eigen::VectorXd lower = {}, upper = {};  ///< per row, or empty: none
};

/// Reads the keys lower, upper and limits of a map: the last a share of the robot's.
RowLimits read_limits(const ocp::ResidualRows& rows, const Reader& reader);

/// Reads square, {barrier: limits}, {barrier: {lower, upper, limits}}, {smooth_absolute: width} or
/// {log_barrier: {lower, upper, limits, width}}.
Penalty read_penalty(const ocp::ResidualRows& rows, const Reader& reader);

}  // namespace burnish::files

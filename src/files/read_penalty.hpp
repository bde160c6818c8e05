// What a residual costs, in a problem file.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

/// Rows of a residual and their limits on the robot, where there are any.
struct PenaltyRows {
  std::vector<RowGroup> rows = {};
  Eigen::VectorXd lower = {}, upper = {};  ///< of the robot, or empty
};

/// Reads square, {barrier: limits}, {barrier: {lower, upper, limits}}, {smooth_absolute: width} or
/// {log_barrier: {lower, upper, limits, width}}.
Penalty read_penalty(const PenaltyRows& rows, const YamlReader& reader);

}  // namespace burnish::files

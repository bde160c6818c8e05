// Names of the rows of a residual, in files and tables, and the robot's limits of these rows.
#pragma once

#include <string>
#include <vector>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// Rows of a residual that share one name, because they belong to one joint or one direction.
struct RowGroup {
  std::string name;
  int size = 1;
};

/// Rows of a residual, in the order in which the residual writes them.
struct ResidualRows {
  std::vector<RowGroup> groups = {};
  /// Limits of the robot for each row, in the residual's unit; infinite for a row without a limit.
  /// The vectors are empty for residuals to which no limit of a robot applies.
  Eigen::VectorXd lower = {}, upper = {};
};

/// Returns the rows of a residual; none for a State, whose rows are the states of the problem.
/// Throws Error with the nearest known name for an unknown joint or contact.
ResidualRows residual_rows(const ProblemSpec& spec, const Residual& residual);

/// Returns one name for each row: the name of its group or, for a joint with several entries of v,
/// the name of its entry.
std::vector<std::string> row_names(const Model& model, const std::vector<RowGroup>& groups);

/// Returns one group for each direction that is set: "x", "y", "z", "rx", "ry", "rz".
std::vector<RowGroup> direction_rows(Directions directions);

/// Returns the contact with this name. A contact without a name has the name of its tool. Throws
/// Error with the nearest known name.
const ContactSpec& contact_named(const ProblemSpec& spec, const std::string& name);

}  // namespace burnish::ocp

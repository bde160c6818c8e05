// What the rows of a residual are called, in files and in tables, and the robot's limits of them.
#pragma once

#include <string>
#include <vector>

#include "burnish/ocp/problem_spec.hpp"

namespace burnish::ocp {

/// Rows that belong together under one name: a joint and its entries, or a direction.
struct RowGroup {
  std::string name;
  int size = 1;
};

struct ResidualRows {
  std::vector<RowGroup> groups = {};
  Eigen::VectorXd lower = {}, upper = {};  ///< of the robot, per row; empty: it states none
};

/// Rows of a residual in the order that it writes them; none of a State, whose rows are those of
/// the problem's state. Throws Error with the nearest name for a joint or a contact that is
/// unknown.
ResidualRows residual_rows(const ProblemSpec& spec, const Residual& residual);

/// Row by row: a direction's name, or that of a joint's entry of v.
std::vector<std::string> row_names(const Model& model, const std::vector<RowGroup>& groups);

/// Directions as rows: "x", "y", "z", "rx", ...
std::vector<RowGroup> direction_rows(Directions directions);

/// The contact of this name. Throws Error with the nearest known one.
const ContactSpec& contact_named(const ProblemSpec& spec, const std::string& name);

}  // namespace burnish::ocp

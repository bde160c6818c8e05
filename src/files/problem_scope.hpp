// What the parts of a problem file need to know of what was read before them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/ocp/problem_spec.hpp"
#include "burnish/robots/robot.hpp"
#include "files/reader.hpp"
#include "ocp/residual_rows.hpp"

namespace burnish::files {

using ocp::RowGroup;

struct ProblemScope {
  const Robot& robot;
  const ProblemSpec& spec;  ///< robot, contacts and actuation are filled
  Eigen::VectorXd q;        ///< at the start
  std::filesystem::path folder;

  const Model& model() const { return spec.model; }
  std::vector<const Joint*> driven() const;
  int controls() const;
};

/// Forces that are prescribed while the robot holds still: contact name -> its rows.
using HeldForces = std::map<std::string, Eigen::VectorXd>;

/// Controls and contact forces of least norm that hold the robot at `q` in a stage with these
/// contacts, some of the forces prescribed.
struct Holding {
  Eigen::VectorXd control;  ///< nu, Nm (N)
  HeldForces forces;        ///< of each contact that holds, N and Nm
  double residual = 0.0;    ///< largest torque that nothing balances, Nm
};
/// Where tables have what the state remembers, row by row.
std::vector<std::string> remembered_columns(const ProblemSpec& spec);
/// Rows of these forces that the state remembers, zero of contacts without one.
Eigen::VectorXd remembered_of(const ProblemSpec& spec, const HeldForces& forces);
Holding hold(const ProblemSpec& spec, const std::vector<std::string>& contacts,
             const Eigen::VectorXd& q, const HeldForces& prescribed);

/// Reads `hold` or `{hold: {contact: force rows}}`.
HeldForces read_held_forces(const ProblemScope& scope, const std::vector<std::string>& contacts,
                            const Reader& reader);

/// True for `hold` and `{hold: ...}`.
bool is_hold(const Reader& reader);

}  // namespace burnish::files

// Parts of a problem file that later parts use, and the forces and torques of the word `hold`.
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

/// Robot, contacts and starting configuration of a problem file.
struct ProblemScope {
  const Robot& robot;
  const ProblemSpec& spec;       ///< At least robot, contacts and actuation are set
  Eigen::VectorXd q;             ///< Starting configuration
  std::filesystem::path folder;  ///< Folder of the file, for relative names

  const Model& model() const { return spec.model; }
  std::vector<const Joint*> driven() const;  ///< Driven joints
  int controls() const;                      ///< Number of controls
};

/// Contact forces at rest, by contact name: one number for each row of the contact.
using HeldForces = std::map<std::string, Eigen::VectorXd>;

/// Controls and contact forces of least norm that keep the robot at rest.
struct Holding {
  Eigen::VectorXd control;  ///< Controls, nu entries [Nm or N]
  HeldForces forces;        ///< Forces of the active contacts [N and Nm]
  double residual = 0.0;    ///< Largest unbalanced torque [Nm]
};
/// Returns the names of the table columns of the force states: one for each force row.
std::vector<std::string> force_state_columns(const ProblemSpec& spec);
/// Returns the force states that equal `forces`; 0 for contacts that `forces` does not contain.
Eigen::VectorXd force_states_of(const ProblemSpec& spec, const HeldForces& forces);
/// Computes the controls and the contact forces that keep the robot at rest at `q`. `contacts` are
/// the active contacts. `prescribed` contains forces that are already known. Throws Error if the
/// dynamics cannot be evaluated.
Holding hold(const ProblemSpec& spec, const std::vector<std::string>& contacts,
             const Eigen::VectorXd& q, const HeldForces& prescribed);

/// Reads the prescribed forces of `hold` or `{hold: {contact: force rows}}`.
HeldForces read_held_forces(const ProblemScope& scope, const std::vector<std::string>& contacts,
                            const Reader& reader);

/// Returns whether a value is `hold` or `{hold: ...}`.
bool is_hold(const Reader& reader);

}  // namespace burnish::files

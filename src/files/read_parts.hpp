// Reads the robot of a problem file, its contacts, its actuators and its control bounds.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

/// Reads the keys base, lock, free, lock_posture and strict of a map; all are optional.
RobotOverrides read_overrides(const Reader& reader);
/// Returns the name for load_robot(): relative paths start from `folder`, and :variant is appended.
std::string robot_name(const Reader& reader, const std::filesystem::path& folder);
/// Reads a robot: a name, to which `overrides` apply, or {name: ..., variant: ...} with its own
/// overrides.
Robot read_robot(const Reader& reader, const std::filesystem::path& folder,
                 const RobotOverrides& overrides = {});
/// Returns the contacts of {name: contact, ...}, or of a list of contacts. Names from a list are
/// empty here; read_contact() reads the optional key `name` of such a contact.
std::vector<std::pair<std::string, Reader>> contacts_in(const Reader& reader);
/// Reads a contact. Its default target is the tool's placement at q. If `name` is empty, the
/// contact may have a key `name`. `tables` is the folder of tables, as in read_reference(). The
/// caller reads the key `surface_input`, which contacts of problems may have.
ContactSpec read_contact(const std::string& name, const Reader& reader, const Model& model,
                         const Eigen::VectorXd& q, const std::filesystem::path* tables = nullptr);
ContactSolver read_contact_solver(const Reader& reader);
ActuationSpec read_actuation(const Reader& reader, const Model& model);
TorqueModel read_torque_model(const Reader& reader);
/// Reads control_lower and control_upper.
void read_bounds(const Reader& reader, const ProblemScope& scope, ProblemSpec& spec);

}  // namespace burnish::files

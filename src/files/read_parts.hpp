// The robot of a problem file and what belongs to it: contacts, actuators, bounds.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

/// base, lock, free, lock_posture and strict, as far as the map states them.
RobotOverrides read_overrides(const Reader& reader);
/// The name alone, as load_robot() takes it: a path from `folder`, :variant behind it.
std::string robot_name(const Reader& reader, const std::filesystem::path& folder);
/// A name, which goes with `overrides`, or {name: ..., variant: ...} with overrides of its own.
Robot read_robot(const Reader& reader, const std::filesystem::path& folder,
                 const RobotOverrides& overrides = {});
/// {name: contact, ...}, or a list of contacts with a key `name` each, which may be missing.
std::vector<std::pair<std::string, Reader>> contacts_in(const Reader& reader);
/// A contact whose target, unless said, is where the tool is at q. An empty name: it may state one.
/// `tables`: as read_reference has it.
ContactSpec read_contact(const std::string& name, const Reader& reader, const Model& model,
                         const Eigen::VectorXd& q, const std::filesystem::path* tables = nullptr);
ContactSolver read_contact_solver(const Reader& reader);
ActuationSpec read_actuation(const Reader& reader, const Model& model);
TorqueModel read_torque_model(const Reader& reader);
/// Fills control_lower and control_upper.
void read_bounds(const Reader& reader, const ProblemScope& scope, ProblemSpec& spec);

}  // namespace burnish::files

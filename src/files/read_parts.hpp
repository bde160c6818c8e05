// The robot of a problem file and what belongs to it: contacts, actuators, bounds.
#pragma once

#include "files/read_values.hpp"

namespace burnish::files {

Robot read_robot(const YamlReader& reader, const std::filesystem::path& folder);
/// A contact whose target, unless said, is where the tool is at q.
ContactSpec read_contact(const std::string& name, const YamlReader& reader, const Model& model,
                         const Eigen::VectorXd& q);
ContactSolver read_contact_solver(const YamlReader& reader);
ActuationSpec read_actuation(const YamlReader& reader, const Model& model);
TorqueModel read_torque_model(const YamlReader& reader);
/// Fills control_lower and control_upper.
void read_bounds(const YamlReader& reader, const FileScene& scene, ProblemSpec& spec);

}  // namespace burnish::files

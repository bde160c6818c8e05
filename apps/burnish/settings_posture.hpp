// Addition of postures to settings files.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/model.hpp"

namespace burnish::app {

/// Returns a posture from the configuration q: values of the moving joints by name, rounded to 0.1
/// mrad or 0.1 mm. Joints that follow others are left out.
Posture posture_of(const Model& model, const Eigen::VectorXd& q);

/// Returns a posture in the notation of settings files: "{joint: 0.1, other: [0, 0, 1]}".
std::string posture_text(const Posture& posture);

/// Returns the path of a robot's settings file. `robot`: any name that load_robot() accepts, with
/// or without a variant. Throws Error if the robot has no settings file.
std::filesystem::path settings_file_of(const std::string& robot);

/// Adds the posture to the key `postures` of a settings file; other lines stay unchanged. Throws
/// Error if a posture of that name exists, or if `postures` is written on one line.
void add_posture(const std::filesystem::path& settings, const std::string& name,
                 const Posture& posture);

}  // namespace burnish::app

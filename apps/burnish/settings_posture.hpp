// Postures that are found, added to settings files.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/model.hpp"

namespace burnish::app {

/// q of joints that move by their names, to 0.1 mrad (mm); followers are left out.
Posture posture_of(const Model& model, const Eigen::VectorXd& q);

/// "{joint: 0.1, other: [0, 0, 1]}", as settings have it.
std::string posture_text(const Posture& posture);

/// The settings file of a robot that load_robot() knows by this name, with or without a variant.
/// Throws Error where it has none.
std::filesystem::path settings_file_of(const std::string& robot);

/// Adds the posture to the key `postures` of a settings file and leaves its other lines as they
/// are. Throws Error where the file has a posture of that name, or `postures` on one line.
void add_posture(const std::filesystem::path& settings, const std::string& name,
                 const Posture& posture);

}  // namespace burnish::app

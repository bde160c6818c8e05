// Robots that can be loaded by name.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace burnish {

/// Returns the settings files of the robots in the folders of robot_search_path(), by the name of
/// the robot's folder. If several folders have a robot of one name, the first takes precedence.
std::map<std::string, std::filesystem::path> known_robots();

/// Returns true if load_robot() treats `name` as a path, even if no file exists there. A path
/// contains a slash, or ends in .urdf, .xml, .mjcf, .yaml or .yml (in upper or lower case).
bool is_robot_path(const std::string& name);

/// Returns the file of a robot without a variant, or nothing if no file exists. A path is used as
/// it is. For any other name, a robot in robot_search_path() takes precedence over a file or folder
/// in the working folder.
std::optional<std::filesystem::path> robot_file(const std::string& name);

/// Returns the URDF or MJCF file that load_robot() reads for `name`, directly or through a settings
/// file. Empty if the name or its settings are invalid.
std::filesystem::path description_file(const std::string& name);

}  // namespace burnish

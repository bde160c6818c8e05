// The robots that are known by name.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace burnish {

/// The settings files of the robots in the folders of robot_search_path(), by the name of their own
/// folder; the first of a name counts.
std::map<std::string, std::filesystem::path> known_robots();

/// Whether load_robot takes the name for a path whatever lies there: it has a slash in it, or ends
/// in .urdf, .xml, .mjcf, .yaml or .yml, in capitals or not, with no variant behind.
bool is_robot_path(const std::string& name);

}  // namespace burnish

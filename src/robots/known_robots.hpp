// The robots that are known by name.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace burnish {

/// The settings files of the robots in the folders of robot_search_path(), by the name of their own
/// folder; the first of a name counts.
std::map<std::string, std::filesystem::path> known_robots();

/// Whether load_robot takes the name for a path whatever lies there: it has a slash in it, or ends
/// in .urdf, .xml, .mjcf, .yaml or .yml, in capitals or not, with no variant behind.
bool is_robot_path(const std::string& name);

/// File of a robot without a variant: a path means what lies there; a bare name means a robot of
/// robot_search_path(), and only then a file or folder of the working folder. Nothing where neither
/// exists.
std::optional<std::filesystem::path> robot_file(const std::string& name);

/// The URDF or MJCF file that load_robot() reads for this name, whatever settings lead there. Empty
/// where the name or its settings are refused.
std::filesystem::path description_file(const std::string& name);

}  // namespace burnish

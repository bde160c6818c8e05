// The robots that are known by name.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace burnish {

/// The settings files of the robots in the folders of robot_search_path(), by the name of their own
/// folder; the first of a name counts.
std::map<std::string, std::filesystem::path> known_robots();

}  // namespace burnish

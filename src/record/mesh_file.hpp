// Meshes that a robot's description names, as triangles.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/run_page.hpp"

namespace burnish {

/// Folders that meshes of a robot that load_robot() knows by this name are sought from: that of its
/// description, then that of its settings. Empty if it is unknown.
std::vector<std::filesystem::path> mesh_folders(const std::string& robot);

/// The file that a uri of a description means: beside the description; for package:// in a folder
/// of that name above it, in $ROS_PACKAGE_PATH or in a share folder of $AMENT_PREFIX_PATH, or else
/// without the package's name in the folder or one of the two above. Empty if there is none.
std::filesystem::path mesh_file(const std::string& uri, const std::filesystem::path& folder);

/// The meshes of a model by their uri, each from the first folder that has it. Those that are not
/// found, cannot be read (STL, OBJ, Collada and more where assimp was there when this was built,
/// none otherwise) or have too many triangles are left out.
std::map<std::string, Mesh> load_meshes(const Model& model,
                                        const std::vector<std::filesystem::path>& folders);

}  // namespace burnish

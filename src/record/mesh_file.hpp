// Files and triangles of the meshes in a robot's description.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/run_page.hpp"

namespace burnish {

/// Returns the folders in which to search for the meshes of a robot: the folder of its description,
/// then the folder of its settings. `robot` is a name for load_robot(). Empty if the robot is
/// unknown.
std::vector<std::filesystem::path> mesh_folders(const std::string& robot);

/// Returns the file of a mesh uri; empty if there is none. `folder` is the folder of the
/// description. A uri without a scheme is a path relative to `folder`.
/// A package:// uri is searched in folders named like the package: above `folder`, in
/// $ROS_PACKAGE_PATH, and in the share folders of $AMENT_PREFIX_PATH. If no such file exists, the
/// path without the package's name is searched in `folder` and the two folders above.
std::filesystem::path mesh_file(const std::string& uri, const std::filesystem::path& folder);

/// Loads the meshes of a model, by uri, each from the first folder that contains it. Omits meshes
/// that are not found, cannot be read, or exceed the maximum number of triangles. Reading needs
/// assimp at build time (STL, OBJ, Collada and more); without assimp, no mesh can be read.
std::map<std::string, Mesh> load_meshes(const Model& model,
                                        const std::vector<std::filesystem::path>& folders);

}  // namespace burnish

// Files that describe a robot: URDF and MJCF, distinguished by their contents.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/tree_spec.hpp"
#include "urdf/collisions.hpp"

namespace burnish {

/// Reads a URDF or MJCF file. The outermost element decides, <robot> or <mujoco>, not the file's
/// name. Throws Error for files that read_urdf() or read_mjcf() rejects, and for SDF and USD files.
TreeSpec read_description(const std::filesystem::path& file);

/// Contents of a file, and the collision geometry of a URDF file.
struct RobotDescription {
  TreeSpec tree;
  std::vector<LinkSolid> collisions = {};
};
/// Reads a URDF or MJCF file once. Throws Error for files that read_description() rejects.
RobotDescription read_robot_description(const std::filesystem::path& file);

/// Returns the settings key for a description file: "urdf" or "mjcf". Throws Error if the file
/// cannot be read.
std::string description_key(const std::filesystem::path& file);

}  // namespace burnish

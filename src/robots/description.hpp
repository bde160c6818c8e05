// Files that describe a robot, told apart by what is in them.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/tree_spec.hpp"
#include "urdf/collisions.hpp"

namespace burnish {

/// Reads URDF or MJCF, once, whatever the file's name: <robot> or <mujoco> is outermost. Throws
/// Error as read_urdf and read_mjcf do, and for SDF and USD by their names.
TreeSpec read_description(const std::filesystem::path& file);

/// What such a file describes, and the collision geometry of a URDF file.
struct RobotDescription {
  TreeSpec tree;
  std::vector<LinkSolid> collisions = {};
};
/// Reads the file once. Throws Error as read_description() does.
RobotDescription read_robot_description(const std::filesystem::path& file);

/// The key of settings that such a file stands under: "urdf" or "mjcf". Throws Error where it
/// cannot be read.
std::string description_key(const std::filesystem::path& file);

}  // namespace burnish

// The settings file that a URDF file alone does not have, drafted from what it says.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

/// Links at which a tool may sit: moving, with no link beyond them; those with the most moving
/// joints beneath first.
std::vector<std::string> tool_candidates(const Model& model);

/// Text of a settings file: base, held joints, a posture, the frame `tool`, limits, with comments
/// that say what to look at. `file` stands under `key`, "urdf" or "mjcf"; it and `srdf` (empty:
/// none) are written as they are.
std::string draft_settings(const Robot& robot, const std::string& key, const std::string& file,
                           const std::string& srdf);

/// Writes DIR/robot.yaml for a robot that was loaded from a URDF or MJCF file, and returns its
/// path. Throws Error where the robot came from a pipe or has settings, or the file is there
/// already.
std::filesystem::path write_settings(const Robot& robot, const std::string& from,
                                     const std::string& srdf, const std::filesystem::path& folder);

}  // namespace burnish::app

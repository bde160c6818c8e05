// The settings file that a URDF file alone does not have, drafted from what it says.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "robot_arguments.hpp"

namespace burnish::app {

/// Links at which a tool may sit: moving, with no link but `fingers` beyond them; those with the
/// most moving joints beneath first.
std::vector<std::string> tool_candidates(const Model& model, const std::set<std::string>& fingers);

/// What a draft refers to.
struct DraftPlace {
  std::string key;     ///< that `file` stands under, "urdf" or "mjcf"
  std::string file;    ///< the description, as it is written into the draft
  std::string srdf;    ///< likewise; empty: none
  std::string tool;    ///< frame that the draft's frame `tool` lies at; empty: a likely one
  std::string origin;  ///< path of the description
  bool fixed = false;  ///< the base stays where it is, and no feet are sought
};

/// Text of a settings file: base, feet, held joints, a posture, the frame `tool`, limits, with
/// comments that say what to look at. Fingers of grippers are locked and, of an arm whose tool is
/// named, what does not carry it. `tree`: the robot's description.
std::string draft_settings(const Robot& robot, const TreeSpec& tree, const DraftPlace& place);

/// Writes DIR/robot.yaml for a robot that was loaded from a URDF or MJCF file, and returns its
/// path. Throws Error where the robot came from a pipe or has settings, where it does not have the
/// frame `tool` (empty: a likely one is taken), or the file is there already.
std::filesystem::path write_settings(const Robot& robot, const RobotArguments& arguments,
                                     const std::filesystem::path& folder, const std::string& tool);

}  // namespace burnish::app

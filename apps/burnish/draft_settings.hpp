// Draft of the settings file robot.yaml for a robot that has only a URDF or MJCF file.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "robot_arguments.hpp"

namespace burnish::app {

/// Returns the moving links at the ends of chains, to which a tool may be attached. Links moved by
/// more joints come first. Joints in `fingers` do not count as part of a chain.
std::vector<std::string> tool_candidates(const Model& model, const std::set<std::string>& fingers);

/// Files and frames that a draft refers to.
struct DraftPlace {
  std::string key;     ///< Key under which the draft states `file`: "urdf" or "mjcf".
  std::string file;    ///< Path of the robot's description, as written into the draft.
  std::string srdf;    ///< Path of the SRDF file, as written into the draft; empty: none.
  std::string tool;    ///< Frame at which the draft places the frame `tool`; empty: a likely link.
  std::string origin;  ///< Path from which the robot's description was loaded.
  bool fixed = false;  ///< True to fix the base; the draft then has no feet.
};

/// Returns the text of a settings file with base, feet, locked joints, a posture, the frame `tool`
/// and limits. Comments mark entries to check. The fingers of grippers are locked and, if
/// `place.tool` is set, also the joints of an arm that do not carry the tool. `tree`: description
/// of the robot.
std::string draft_settings(const Robot& robot, const TreeSpec& tree, const DraftPlace& place);

/// Writes robot.yaml into `folder` and returns the path of the file. The robot must have been
/// loaded from a URDF or MJCF file. `tool`: name of the frame at which the frame `tool` is placed;
/// empty: a likely link. Throws Error for a robot read from a pipe, a robot that has settings, an
/// unknown frame, and if robot.yaml exists.
std::filesystem::path write_settings(const Robot& robot, const RobotArguments& arguments,
                                     const std::filesystem::path& folder, const std::string& tool);

}  // namespace burnish::app

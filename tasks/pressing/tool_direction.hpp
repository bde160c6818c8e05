// Pressing direction of a tool.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::pressing {

struct ToolDirection {
  Eigen::Vector3d axis;  ///< Pressing direction: unit vector in the tool's frame.
  bool decided = true;   ///< False if the sign is a guess.
};

/// Returns the pressing direction of a tool: `axis` if stated. Otherwise, the direction is along a
/// line, with a sign.
/// - Line for a frame that the settings of the robot add: its z axis.
/// - Line for a link or a joint of the description: the axis of the joint that carries the tool, or
///   the line from this joint to the tool if the tool lies beside the axis.
/// - Sign: away from the robot. Three offsets are tried: from the last joint to the tool, from the
///   joint before to the last joint, and from the last joint to the centre of mass of the last
///   link. The first one with a component of at least 1 mm along the line decides.
/// - Sign if no offset decides: -z for a frame of the settings, else towards the frame's z axis.
ToolDirection tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                             const Model& model);

/// Returns `axis` as text, rounded to three decimals, such as "tool.axis=[0, 0, 1]".
std::string axis_text(const Eigen::Vector3d& axis);

/// Adds a note if the sign of the direction is a guess.
void note_tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                         const Model& model, std::vector<std::string>& notes);

}  // namespace burnish::pressing

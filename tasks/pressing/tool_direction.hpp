// Which way a tool looks: the direction that it presses in.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::pressing {

struct ToolDirection {
  Eigen::Vector3d axis;  ///< in the tool's frame, of length one
  bool decided = true;   ///< false: nothing tells it from its opposite, and it is a guess
};

/// Direction that a tool presses in: `axis` where it is stated. Of a frame that the settings of the
/// robot add it is z or -z. Of a link or a joint of the description it is the axis of the last
/// joint that carries it, or the line from that joint to the tool where the tool lies beside the
/// axis rather than on it. The sign points away from the robot, by the first of these that is 1 mm
/// or more along the axis: the tool's offset from the last joint, the last joint's offset from the
/// joint before, the centre of mass of the last link. Where none is, it is -z of a frame of the
/// settings, and of others the way that the frame's own z looks along the axis.
ToolDirection tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                             const Model& model);

/// "tool.axis=[0, 0, 1]", to the third decimal.
std::string axis_text(const Eigen::Vector3d& axis);

/// Adds a sentence where the direction is a guess.
void note_tool_direction(const std::string& frame, const std::optional<Eigen::Vector3d>& axis,
                         const Model& model, std::vector<std::string>& notes);

}  // namespace burnish::pressing

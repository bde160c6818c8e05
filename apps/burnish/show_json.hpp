// Description of a robot as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/margins.hpp"

namespace burnish::app {

/// Returns the robot as JSON. `q`: configuration at which frames are placed; `posture`: name of
/// this configuration, may be empty.
nlohmann::ordered_json show_json(const Robot& robot, const Eigen::VectorXd& q,
                                 const std::string& posture);

/// Returns stability margins as JSON, for the pressing controller with a tool on a table: delays
/// [s] and gain ranges by joint. `fitted`: sentence about the fitted gains, may be empty.
nlohmann::ordered_json margins_json(const polishing::TaskMargins& margins, const std::string& tool,
                                    const std::string& fitted);

std::string kind_text(FrameKind kind);

/// Returns the rotation angles about the fixed axes x, y, z, applied in this order, with the pitch
/// in [-pi/2, pi/2] [rad].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

}  // namespace burnish::app

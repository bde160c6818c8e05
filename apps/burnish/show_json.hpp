// A robot as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/margins.hpp"

namespace burnish::app {

/// `q` is the configuration at which frames are placed, `posture` its name (may be empty).
nlohmann::ordered_json show_json(const Robot& robot, const Eigen::VectorXd& q,
                                 const std::string& posture);

/// What the pressing controller tolerates with a tool on a table: delays in s, gains by joint.
/// `fitted`: what was chosen for that, a sentence that may be empty.
nlohmann::ordered_json margins_json(const polishing::TaskMargins& margins, const std::string& tool,
                                    const std::string& fitted);

std::string kind_text(FrameKind kind);

/// Angles about x, then y, then z (fixed axes), with pitch in [-pi/2, pi/2].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

}  // namespace burnish::app

// A robot as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "burnish/robots/robot.hpp"

namespace burnish::app {

/// `q` is the configuration at which frames are placed, `posture` its name (may be empty).
nlohmann::ordered_json show_json(const Robot& robot, const Eigen::VectorXd& q,
                                 const std::string& posture);

std::string kind_text(FrameKind kind);

/// Angles about x, then y, then z (fixed axes), with pitch in [-pi/2, pi/2].
Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation);

}  // namespace burnish::app

// Arm that presses on surfaces: Talos' right arm, or arm7 in builds that read no files.
#pragma once

#include "support/robots.hpp"

namespace burnish::test {

struct PressingArm {
  Model model;
  Eigen::VectorXd posture;  ///< posture with the frame "tool" over the surface
};

/// Arm in a posture of Talos' arm; arm7 only has the posture "table".
inline PressingArm pressing_arm(const std::string& posture = "table") {
#if BURNISH_HAS_ROBOTS
  const Robot robot = load_robot(std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm");
  return {robot.model, robot.posture(posture)};
#else
  if (posture != "table")
    throw Error("posture '" + posture + "' needs robot files; this build reads none");
  return {arm7::model(Base::Fixed), arm7::ready()};
#endif
}

}  // namespace burnish::test

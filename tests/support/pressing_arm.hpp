// The arm that presses on surfaces: Talos' right arm, or arm7 where no files are read.
#pragma once

#include "support/robots.hpp"

namespace burnish::test {

struct PressingArm {
  Model model;
  Eigen::VectorXd posture;  ///< with the tool, frame "tool", over the surface
};

/// In a posture of Talos' arm; arm7 has one of them, "table".
inline PressingArm pressing_arm(const std::string& posture = "table") {
#if BURNISH_HAS_ROBOTS
  const Robot robot = load_robot(std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm");
  return {robot.model, robot.posture(posture)};
#else
  if (posture != "table") throw Error("posture '" + posture + "' is in a file that is not read");
  return {arm7::model(Base::Fixed), arm7::ready()};
#endif
}

}  // namespace burnish::test

// Joints that nothing can hold still: so light that the noise of their motors throws them about.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Names of joints between no foot and the base, such as those of fingers, that move less than
/// 3e-4 kg m^2 (kg) at the robot's reference posture, armature included. None of robots with loops.
/// Throws Error for a posture that is no state.
std::vector<std::string> light_joints(const Robot& robot, const Standing& standing);

/// `robot`, loaded by load_floating(name), with those joints locked, and a note that says so.
Robot light_joints_locked(Robot robot, const std::string& name, const Standing& standing);

}  // namespace burnish::pressing

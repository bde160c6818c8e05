// Joints that nothing can hold still: so light that the noise of their motors throws them about.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Names of joints outside every chain from the base to a foot whose effective inertia at the
/// reference posture, armature included, is below 3e-4 [kg m^2 or kg], and of fingers without an
/// armature: all beyond a link that carries two or more branches of less than 1 % of the robot's
/// mass each. Empty for robots with loops. Throws Error for a posture that cannot be evaluated.
std::vector<std::string> light_joints(const Robot& robot, const Standing& standing);

/// `robot`, loaded by load_floating(name), with those joints locked, and a note that says so.
Robot light_joints_locked(Robot robot, const std::string& name, const Standing& standing);

}  // namespace burnish::pressing

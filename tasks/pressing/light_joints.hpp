// Joints outside the legs that are too light to be held still: noise of their motors would shake
// them.
#pragma once

#include <string>
#include <vector>

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Returns the names of light joints outside the legs; empty for robots with loops. A joint is
/// light if its effective inertia at the reference posture, with armature, is below 3e-4 [kg m^2
/// (kg)]. Finger joints without an armature are light too. A finger is a branch of less than 1 % of
/// the robot's mass, on a link with two or more such branches. Throws Error for a posture that
/// cannot be evaluated.
std::vector<std::string> light_joints(const Robot& robot, const Standing& standing);

/// Returns `robot` with its light joints locked, and a note that names these joints. `robot` must
/// be the result of load_floating(name).
Robot light_joints_locked(Robot robot, const std::string& name, const Standing& standing);

}  // namespace burnish::pressing

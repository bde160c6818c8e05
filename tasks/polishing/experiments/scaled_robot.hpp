// Scaling of a robot to another mass.
#pragma once

#include "burnish/robots/robot.hpp"

namespace burnish::polishing {

/// Returns the robot scaled to a moving mass of `mass` [kg]. Lengths scale by the cube root of the
/// mass ratio, inertias by mass times length squared. Torque limits, joint friction, damping and
/// stiffness scale by mass times length. Angles, their limits and joint speeds do not change.
/// Throws Error unless the mass is positive and all joints are revolute.
Robot scaled_robot(Robot robot, double mass);

}  // namespace burnish::polishing

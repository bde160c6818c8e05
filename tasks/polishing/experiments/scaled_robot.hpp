// A robot of another size.
#pragma once

#include "burnish/robots/robot.hpp"

namespace burnish::polishing {

/// The robot with `mass` kg of moving bodies in place of its own: lengths by the cube root of the
/// masses' ratio, inertias as solids of the same density have them, and torque limits, joint
/// friction and damping by mass times length. Angles, their limits and joint speeds stay. Throws
/// Error for a mass that is not positive and for joints that are no revolute ones.
Robot scaled_robot(Robot robot, double mass);

}  // namespace burnish::polishing

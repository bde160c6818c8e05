// How firmly a robot on its feet may be held before its own feet begin to shake.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::pressing {

/// mpc.fallback, or a part of its stiffness and damping that holds the robot steadily on `feet`.
/// The hold acts in the metric of the robot on rigid feet. A light foot on ground that gives way
/// feels its torque at once, and the velocity that it answers late: heavy robots with light feet
/// shake. Motion about the start is linear: open mass matrix, springs and dampers of the ground,
/// motors one tick late, velocities from differences behind a low-pass of 50 Hz. With twice what is
/// returned it dies away, or at least with what is returned, where a part does. As it is for robots
/// with loops. Throws Error for a start that is no state.
Fallback steady_fallback(const MpcSpec& mpc, const std::vector<SupportSpec>& feet);

}  // namespace burnish::pressing

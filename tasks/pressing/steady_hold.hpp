// How firmly a robot on its feet may be held before its own feet begin to shake.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::pressing {

/// Returns mpc.fallback, with stiffness and damping scaled down where the hold on `feet` would not
/// be stable. The hold uses the mass matrix of the robot on rigid feet. On compliant ground a light
/// foot is accelerated at once, but the velocity feedback is late: heavy robots with light feet
/// oscillate. The motion about the start is linearized: open mass matrix, springs and dampers of
/// the ground, motors one tick late, velocities from differences behind a low-pass of 50 Hz. It
/// decays with twice the returned gains; where no scale achieves that, with the returned gains.
/// Returns mpc.fallback unchanged for robots with loops. Throws Error for a start that cannot be
/// evaluated.
Fallback steady_fallback(const MpcSpec& mpc, const std::vector<SupportSpec>& feet);

}  // namespace burnish::pressing

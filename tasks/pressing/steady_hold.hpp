// Gains that hold a standing robot without oscillation of its feet.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish::pressing {

/// Returns mpc.fallback, with stiffness and damping scaled down if the hold on `feet` would be
/// unstable. The hold assumes rigid feet. On compliant ground, delayed velocity feedback makes
/// heavy robots with light feet oscillate.
/// The stability test simulates the linearized motion about the start. It includes springs and
/// dampers of the ground, motors that act one tick late, and velocities from differences behind a
/// low-pass of 50 Hz. The motion must decay even with twice the returned gains; if no scale
/// achieves this, it must decay with the returned gains. If that fails too, mpc.fallback is
/// returned unchanged. Robots with loops are not tested. Throws Error for a start that cannot be
/// evaluated.
Fallback steady_fallback(const MpcSpec& mpc, const std::vector<TouchSpec>& feet);

}  // namespace burnish::pressing

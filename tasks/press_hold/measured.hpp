// Time window of a run over which the force is measured.
#pragma once

namespace burnish::press_hold {

// Chosen by hand: on the shipped robots, the force settles 0.1 to 0.2 s after the ramp.
inline constexpr double after_ramp = 0.2;  ///< Time from the end of the ramp to the window [s].
inline constexpr double before_retreat = 0.02;  ///< Time between window and retreat [s].
/// Smallest time from the end of the ramp to the retreat [s].
inline constexpr double min_measured = 0.5;

}  // namespace burnish::press_hold

// Time windows of a run over which forces are measured.
#pragma once

namespace burnish::push_wall {

// Chosen by hand: forces settle within 0.3 s on the shipped robot.
inline constexpr double settling = 0.3;  ///< Time from the end of a force ramp to the window [s].
inline constexpr double min_hold = 0.4;  ///< Smallest duration of a constant force [s].

}  // namespace burnish::push_wall

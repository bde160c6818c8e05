// The window of a run over which the force is judged.
#pragma once

namespace burnish::press_hold {

// Chosen: the transient of the ramp lasts 0.1 to 0.2 s on the robots that ship.
inline constexpr double after_ramp = 0.2;       ///< Begin of the window after the ramp [s].
inline constexpr double before_retreat = 0.02;  ///< End of the window before the retreat [s].
inline constexpr double least_measured = 0.5;   ///< Least time from ramp to retreat [s].

}  // namespace burnish::press_hold

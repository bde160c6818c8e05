// The windows of a run over which forces are judged.
#pragma once

namespace burnish::push_wall {

// Chosen: forces that were just reached settle within 0.3 s on the robot that ships.
inline constexpr double settling = 0.3;    ///< Begin of a window after its force was reached [s].
inline constexpr double least_hold = 0.4;  ///< Least time for which a force is held [s].

}  // namespace burnish::push_wall

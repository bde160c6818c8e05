// The phases of a tool that comes to a surface, presses on it, follows a path there and leaves.
#pragma once

#include <string>
#include <vector>

namespace burnish {

/// As Command::phase and traces count them.
enum class Phase { Reach, Approach, Ramp, Track, Retreat };

constexpr int number_of(Phase phase) { return static_cast<int>(phase); }
/// "reach", "approach", "ramp", "track" or "retreat".
std::string name_of(Phase phase);
const std::vector<std::string>& phase_names();  ///< of all, in their order

}  // namespace burnish

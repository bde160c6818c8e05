// What a controller is held to.
#pragma once

#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

struct Aim {
  std::string figure;
  double limit;  ///< in the unit that people are shown
};

/// "met", or by how much the value, in that unit, misses the aim.
std::string verdict(double value, const Aim& aim);

/// 1 - value / limit as a percentage; empty for a limit of zero.
ResultCell room_below(double value, const Aim& aim);

}  // namespace burnish::polishing

// Comparison of measured values with aims.
#pragma once

#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

struct Aim {
  std::string figure;
  double limit;  ///< Largest value that meets the aim, in the display unit of the figure.
};

/// Returns "met", or the amount by which the value misses the aim. Value and amount are in the
/// display unit of the figure.
std::string verdict(double value, const Aim& aim);

/// Returns how far a value is below its limit, 1 - value / limit, in percent; empty for a limit of
/// zero.
ResultCell room_below(double value, const Aim& aim);

}  // namespace burnish::polishing

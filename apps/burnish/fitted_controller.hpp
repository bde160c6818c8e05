// Fit of controller gains to an arm before a task runs, and the resulting stability margins.
#pragma once

#include <optional>
#include <string>

#include "burnish/tasks/polishing/margins.hpp"

namespace burnish::app {

struct FittedController {
  bool fits_all = true;  ///< True if all gains are fitted because the task states none.
  polishing::FittedGains fitted = {};
  std::optional<polishing::TaskMargins> margins = {};
};

/// Sets the gains that the task does not state, using fit_gains(), and computes the margins.
FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting);

/// Prints the fitted gains and the margins if `talks`. Prints a warning if all gains were fitted
/// but the margins are smaller than required.
void describe(const FittedController& controller, const std::string& place, bool talks);

}  // namespace burnish::app

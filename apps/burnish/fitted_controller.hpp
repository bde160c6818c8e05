// Gains that are fitted to an arm before a task runs, and what its loop tolerates with them.
#pragma once

#include <optional>
#include <string>

#include "burnish/tasks/polishing/margins.hpp"

namespace burnish::app {

struct FittedController {
  bool fits_all = true;  ///< No gain was stated.
  polishing::FittedGains fitted = {};
  std::optional<polishing::TaskMargins> margins = {};
};

/// Sets the gains that the task does not state, see fit_gains(), and computes the margins.
FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting);

/// Prints what was chosen and what the loop tolerates, and warns where that is too little.
void describe(const FittedController& controller, const std::string& place, bool talks);

}  // namespace burnish::app

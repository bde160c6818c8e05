// Gains that are fitted to an arm before a task runs, and what its loop tolerates with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/margins.hpp"
#include "files/described_file.hpp"

namespace burnish::app {

struct FittedController {
  polishing::FreeKeys free = {};
  polishing::FittedGains fitted = {};
  std::optional<polishing::TaskMargins> margins = {};
};

/// Changes those of the task's gains that none of its texts states.
FittedController fit_controller(polishing::Task& task, const polishing::Setting& setting,
                                const std::vector<document::Reader>& said);

/// Prints what was chosen and what the loop tolerates, and warns where that is too little.
void describe(const FittedController& controller, const std::string& place, bool talks);

}  // namespace burnish::app

// Figures of runs of the task, described by their table.
#pragma once

#include "pressing/run_descriptions.hpp"
#include "stand/descriptions.hpp"

namespace burnish::stand {

const Description& description_of(const SwayFigures*);

}  // namespace burnish::stand

// Descriptions of the metrics of a run's verdict, from their table.
#pragma once

#include "polishing/descriptions.hpp"
#include "pressing/run_descriptions.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures*);

}  // namespace burnish::polishing

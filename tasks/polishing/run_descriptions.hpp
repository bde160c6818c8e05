// Descriptions of the metrics of a run's verdict and of its resting hand, from their tables.
#pragma once

#include "polishing/descriptions.hpp"
#include "pressing/run_descriptions.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures*);
const Description& description_of(const RestFigures*);

}  // namespace burnish::polishing

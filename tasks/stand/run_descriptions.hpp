// What runs of the task are specified by, and what they give.
#pragma once

#include "pressing/run_descriptions.hpp"
#include "sim/descriptions.hpp"
#include "stand/descriptions.hpp"

namespace burnish::stand {

const Description& description_of(const SwayFigures*);
const Description& description_of(const Setting*);
const Description& description_of(const RunSpec*);

}  // namespace burnish::stand

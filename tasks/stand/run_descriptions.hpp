// Description of the figures in stand/figures.hpp.
#pragma once

#include "pressing/run_descriptions.hpp"
#include "stand/descriptions.hpp"

namespace burnish::stand {

const Description& description_of(const SwayFigures*);

}  // namespace burnish::stand

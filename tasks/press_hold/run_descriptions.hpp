// Description of the figures in press_hold/figures.hpp.
#pragma once

#include "press_hold/descriptions.hpp"
#include "pressing/run_descriptions.hpp"

namespace burnish::press_hold {

const Description& description_of(const HoldFigures*);

}  // namespace burnish::press_hold

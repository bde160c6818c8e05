// Description of the figures in pressing/figures.hpp.
#pragma once

#include "pressing/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const TickTimes*);

}  // namespace burnish

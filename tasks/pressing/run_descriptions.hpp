// Figures of all runs, described by their table: pressing/figures.hpp.
#pragma once

#include "pressing/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const TickTimes*);

}  // namespace burnish

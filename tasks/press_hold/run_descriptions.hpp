// What runs of the task are specified by, and what they give.
#pragma once

#include "press_hold/descriptions.hpp"
#include "pressing/run_descriptions.hpp"
#include "sim/descriptions.hpp"

namespace burnish::press_hold {

const Description& description_of(const HoldFigures*);
const Description& description_of(const Setting*);
const Description& description_of(const RunSpec*);

}  // namespace burnish::press_hold

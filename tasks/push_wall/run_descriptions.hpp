// What runs of the task are specified by, and what they give.
#pragma once

#include "pressing/run_descriptions.hpp"
#include "push_wall/descriptions.hpp"
#include "sim/descriptions.hpp"

namespace burnish::push_wall {

const Description& description_of(const PushFigures*);
const Description& description_of(const Setting*);
const Description& description_of(const RunSpec*);

}  // namespace burnish::push_wall

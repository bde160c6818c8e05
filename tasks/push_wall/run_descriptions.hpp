// Description of the figures in push_wall/figures.hpp.
#pragma once

#include "pressing/run_descriptions.hpp"
#include "push_wall/descriptions.hpp"

namespace burnish::push_wall {

const Description& description_of(const PushFigures*);

}  // namespace burnish::push_wall

// Are the steps of a controller's plans short enough? To be asked before it runs.
#pragma once

#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Sentences about the steps of plans that are too long, at the problem's initial state at rest;
/// empty: all is well. First step_complaints() of the problem, then what check_steps() says of the
/// first plan, which is made as the controller makes it. Solves that plan; throws Error for a
/// specification that cannot be planned with, and what its functions throw.
std::vector<std::string> step_complaints(const MpcSpec& spec);

}  // namespace burnish

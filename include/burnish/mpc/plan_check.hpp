// Checks before a run whether the steps of a controller's plans are short enough.
#pragma once

#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Solves the first plan of a controller, at rest at the problem's initial state, and returns a
/// sentence for each step that is too long: those of step_complaints(Problem), and the warning of
/// check_steps() for that plan. Empty if there is none. Throws Error for a specification that no
/// controller can be made from, and what its functions throw.
std::vector<std::string> step_complaints(const MpcSpec& spec);

}  // namespace burnish

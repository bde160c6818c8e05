// Check of the time steps of a controller's plans, before a run.
#pragma once

#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Computes the first plan of a controller, at rest in the problem's initial state. Then checks the
/// plan's time steps with step_complaints(Problem) and check_steps(). Returns one sentence for
/// each step that is too long, and nothing if all steps are short enough. Throws Error if `spec` is
/// not valid for a controller. Exceptions of functions in `spec` are not caught.
std::vector<std::string> step_complaints(const MpcSpec& spec);

}  // namespace burnish

// Check before a run whether the time steps of a controller's plans are short enough.
#pragma once

#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Solves the first plan of a controller, at rest in the problem's initial state, and checks the
/// time steps. The checks are step_complaints(Problem) and check_steps(). Returns one sentence for
/// each step that is too long, and nothing if all steps are short enough. Throws Error if `spec` is
/// not valid for a controller. Exceptions of functions in `spec` are not caught.
std::vector<std::string> step_complaints(const MpcSpec& spec);

}  // namespace burnish

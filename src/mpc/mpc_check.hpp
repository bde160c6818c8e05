// Consistency check of the specification of an MpcController.
#pragma once

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Checks the specification and returns the number of ticks between updates of the plan. Throws
/// Error with one sentence if the specification is inconsistent.
int checked_ticks_per_update(const MpcSpec& spec);

}  // namespace burnish

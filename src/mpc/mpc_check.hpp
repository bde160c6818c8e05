// Whether a specification of an MpcController fits together.
#pragma once

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Ticks from one update to the next. Throws Error with one sentence for what does not fit.
int checked_ticks_per_update(const MpcSpec& spec);

}  // namespace burnish

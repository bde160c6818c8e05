// Derivative check with a hook through which tests insert wrong derivatives.
#pragma once

#include "derivatives/check_blocks.hpp"
#include "derivatives/check_states.hpp"
#include "derivatives/check_values.hpp"

namespace burnish {

/// Function that may change the blocks of a state before the comparison.
using TamperWithBlocks = std::function<void(std::vector<DerivativeBlock>&)>;

/// Runs check_derivatives(), and calls `tamper`, if not empty, with the blocks of each state.
CheckReport run_check(const Model& model, const CheckOptions& options,
                      const TamperWithBlocks& tamper = {});

/// Returns all blocks at one state: derivatives from `dynamics`, finite differences from `values`.
/// Both must have the same contacts. Omits the blocks of forward dynamics if M is singular.
std::vector<DerivativeBlock> derivative_blocks(const Model& model, ContactDynamics& dynamics,
                                               CheckValues& values, const CheckState& state);

}  // namespace burnish

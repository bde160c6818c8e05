// The check of one set of contacts, and a place where tests can put a wrong derivative.
#pragma once

#include "derivatives/check_blocks.hpp"
#include "derivatives/check_states.hpp"
#include "derivatives/check_values.hpp"

namespace burnish {

/// Called with the blocks of each state before they are compared.
using TamperWithBlocks = std::function<void(std::vector<DerivativeBlock>&)>;

/// check_derivatives(), with the analytic blocks passed through `tamper` where it is not empty.
CheckReport run_check(const Model& model, const CheckOptions& options,
                      const TamperWithBlocks& tamper = {});

/// All blocks at one state: from the derivatives of `dynamics`, and from differences of `values`,
/// which are of the same contacts. Those of forward dynamics are left out where M is singular.
std::vector<DerivativeBlock> derivative_blocks(const Model& model, ContactDynamics& dynamics,
                                               CheckValues& values, const CheckState& state);

}  // namespace burnish

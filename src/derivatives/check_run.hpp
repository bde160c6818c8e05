// The check of one set of contacts, and a place where tests can put a wrong derivative.
#pragma once

#include "derivatives/check_blocks.hpp"
#include "derivatives/check_states.hpp"

namespace burnish {

/// Called with the blocks of each state before they are compared.
using TamperWithBlocks = std::function<void(std::vector<DerivativeBlock>&)>;

/// check_derivatives(), with the analytic blocks passed through `tamper` where it is not empty.
CheckReport run_check(const Model& model, const CheckOptions& options,
                      const TamperWithBlocks& tamper = {});

/// All blocks of these contacts at one state: analytic and from differences.
std::vector<DerivativeBlock> derivative_blocks(const Model& model,
                                               const std::vector<ContactSpec>& contacts, double mu,
                                               const CheckState& state);

}  // namespace burnish

// Derivatives of inverse dynamics in one backward sweep over composite quantities, in world
// coordinates (Singh, Russell, Wensing 2022; see docs/theory.md).
#pragma once

#include <vector>

#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// d tau / dq and d tau / dv, both row-major with leading dimension nv, at constant qdd and with
/// the applied wrenches moving rigidly with their bodies. Only entries of related joints are
/// written, but where axes share entries of v all are. Call after accelerate; sums `force` over
/// subtrees as it goes. `coriolis_of` is scratch, one entry per body.
template <class S>
void inverse_dynamics_derivatives(const Tree& tree, const Kinematics<S>& kinematics,
                                  const MassMatrix<S>& mass, InverseDynamics<S>& id,
                                  std::vector<Coriolis<S>>& coriolis_of, S* dtau_dq, S* dtau_dv);

}  // namespace burnish

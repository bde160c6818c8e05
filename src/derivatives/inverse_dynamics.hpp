// Derivatives of inverse dynamics in one backward sweep over composite quantities, in world
// coordinates (Singh, Russell, Wensing 2022; see docs/theory.md).
#pragma once

#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Computes dtau/dq and dtau/dv at constant joint accelerations (both nv x nv, row-major). Applied
/// wrenches move rigidly with their bodies.
///
/// Writes only the entries (j, k) whose joints j and k lie on one path to the root, or all entries
/// if axes share entries of v. Requires accelerate(). Sums id.force over subtrees.
template <class S>
void inverse_dynamics_derivatives(const Tree& tree, const Kinematics<S>& kinematics,
                                  const MassMatrix<S>& mass, InverseDynamics<S>& id, S* dtau_dq,
                                  S* dtau_dv);

}  // namespace burnish

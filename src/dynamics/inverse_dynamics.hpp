// Inverse dynamics: accelerations outward, forces inward, in world coordinates (recursive
// Newton-Euler).
#pragma once

#include <vector>

#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// Filled by accelerate, then by a sweep. World coordinates.
template <class S>
struct InverseDynamics {
  explicit InverseDynamics(const Tree& tree);

  std::vector<Motion<S>> a_joint;  ///< per body: sum of S_k qdd_k up to it
  std::vector<Motion<S>>
      axis_acc;  ///< per axis and sum: psi''_k = (a_parent - g) x S_k + v_parent x psi'_k
  std::vector<Force<S>>
      force;           ///< per body: inertia * a_joint - applied wrench; then of its subtree
  std::vector<S> tau;  ///< nv
  // Of trees whose axes share entries of v alone; the derivatives are scratch of theirs.
  std::vector<S> tau_by_axis, dq_by_axis, dv_by_axis;
};

/// Body accelerations at joint accelerations qdd (nv), and the force that they ask of each body
/// beyond its bias force. Wrenches applied from outside are subtracted from `force` afterwards,
/// before the sweep.
template <class S>
void accelerate(const Tree& tree, const Kinematics<S>& kinematics, const S* qdd,
                InverseDynamics<S>& id);

/// tau = M qdd + b - (generalised force of the applied wrenches). Sums `force` over subtrees.
template <class S>
void inverse_dynamics_sweep(const Tree& tree, const Kinematics<S>& kinematics,
                            const MassMatrix<S>& mass, const S* qdd, InverseDynamics<S>& id);

}  // namespace burnish

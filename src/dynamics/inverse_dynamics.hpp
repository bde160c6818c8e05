// Inverse dynamics by the recursive Newton-Euler algorithm in world coordinates: accelerations from
// the root to the tips, then forces from the tips to the root.
#pragma once

#include <vector>

#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// Results of inverse dynamics in world coordinates, filled by accelerate and then by
/// inverse_dynamics_sweep.
template <class S>
struct InverseDynamics {
  explicit InverseDynamics(const Tree& tree);

  std::vector<Motion<S>> a_joint;  ///< Sum of S_k qdd_k from the root to each body
  /// psi''_k = (a_parent - g) x S_k + v_parent x psi'_k for each axis and sum of axes
  std::vector<Motion<S>> axis_acc;
  /// inertia * a_joint minus the applied wrench of each body; the sweep sums it over subtrees
  std::vector<Force<S>> force;
  std::vector<S> tau;                 ///< Joint torques, nv
  std::vector<Coriolis<S>> coriolis;  ///< Scratch memory of inverse_dynamics_derivatives()
  // Scratch memory, only for trees in which an entry of v can have several axes:
  std::vector<S> tau_by_axis, dq_by_axis, dv_by_axis;
};

/// Computes the accelerations of all bodies due to joint accelerations qdd (nv). Sets `force` to
/// the forces that cause these accelerations, without the bias forces. Callers subtract external
/// wrenches from `force` between accelerate and inverse_dynamics_sweep.
template <class S>
void accelerate(const Tree& tree, const Kinematics<S>& kinematics, const S* qdd,
                InverseDynamics<S>& id);

/// Computes tau = M qdd + b - (generalized force of the applied wrenches), and sums `force` over
/// subtrees.
template <class S>
void inverse_dynamics_sweep(const Tree& tree, const Kinematics<S>& kinematics,
                            const MassMatrix<S>& mass, const S* qdd, InverseDynamics<S>& id);

}  // namespace burnish

// Derivatives of the contact acceleration (Proposition 3) and of the generalised contact force at
// constant lambda (Proposition 4), in any reference. Both follow from one rule for a motion m:
//   d(X m)/dq_k = X (dm/dq_k + xi_k x m).
// X maps m to the reference. xi_k is the twist of the tool frame relative to the reference at a
// unit rate of entry k. dm/dq_k is the derivative in tool axes. See docs/theory.md.
#pragma once

#include "contact/contact_kinematics.hpp"
#include "dynamics/columns.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Accelerations that the derivatives need, in world axes, about the world's origin.
template <class S>
struct ContactAccelerations {
  Motion<S> a_base;  ///< Spatial acceleration of the base, without gravity
  Motion<S> alpha;   ///< Contact acceleration a_L + eta x nu
  Vec3<S> gravity;   ///< Gravity [m/s^2]
};

/// Computes the accelerations at the joint accelerations of the last accelerate().
template <class S>
ContactAccelerations<S> contact_accelerations(const Tree& tree, const CompiledContact& contact,
                                              const Kinematics<S>& kinematics,
                                              const InverseDynamics<S>& id,
                                              const ContactState<S>& state);

/// Computes the negated derivatives of contact_acceleration() by q and v at constant joint
/// acceleration. Writes column v for each entry v of `influences`.
template <class S>
void contact_acceleration_derivatives(const CompiledContact& contact,
                                      const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                      const ContactState<S>& state,
                                      const ContactAccelerations<S>& at, StateDerivatives<S> minus);

/// Subtracts from dtau_dq (nv x nv, row-major) the term that the motion of the reference adds to
/// d(J^T lambda)/dq (Proposition 4, eq. 32). Without this term, dtau_dq treats the wrench as moving
/// rigidly with the bodies. The term is zero for `Local` with one moving body.
template <class S>
void subtract_force_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                              const ContactState<S>& state, S* dtau_dq, int stride);

/// Subtracts the derivative of a contact's friction torques by v from dtau_dv (nv x nv, row-major).
template <class S>
void subtract_friction_by_v(const CompiledContact& contact, const Kinematics<S>& kinematics,
                            const ContactState<S>& state, S* dtau_dv, int stride);

/// Returns true if subtract_force_transport() couples entries of v on different branches.
bool transport_couples_branches(const CompiledContact& contact);

}  // namespace burnish

// Derivatives of the contact acceleration (Proposition 3) and of the generalised contact force at
// constant lambda (Proposition 4), in any reference. Both come from one rule: with xi_k the twist
// of the tool frame seen from the reference per unit rate of entry k,
//   d(X m)/dq_k = X (dm/dq_k + xi_k x m),
// where dm/dq_k is the derivative seen from the tool. See docs/theory.md.
#pragma once

#include "contact/contact_kinematics.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

/// Spatial accelerations of the two bodies and what the derivatives need beside them; world axes,
/// about the world's origin.
template <class S>
struct ContactAccelerations {
  Motion<S> a_base;  ///< without gravity
  Motion<S> alpha;   ///< a_L + eta x nu
  Vec3<S> gravity;   ///< m/s^2, world axes
};

/// Accelerations at the joint accelerations last given to accelerate().
template <class S>
ContactAccelerations<S> contact_accelerations(const Tree& tree, const CompiledContact& contact,
                                              const Kinematics<S>& kinematics,
                                              const InverseDynamics<S>& id,
                                              const ContactState<S>& state);

/// Minus d(alpha + kd nu + kp e)/dq and /dv of the held rows, at constant joint acceleration:
/// entry (row, v) goes to out[row * stride + v], for the entries of the support.
template <class S>
void contact_acceleration_derivatives(const CompiledContact& contact,
                                      const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                      const ContactState<S>& state,
                                      const ContactAccelerations<S>& at, S* minus_dq, S* minus_dv,
                                      int stride);

/// Subtracts from dtau_dq (nv x nv row-major) what the reference adds to d(J^T lambda)/dq beyond a
/// wrench that moves rigidly with the bodies (Proposition 4, eq. 32). Nothing for `Local` with one
/// moving body.
template <class S>
void subtract_force_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                              const ContactState<S>& state, S* dtau_dq, int stride);

/// Subtracts from dtau_dv (nv x nv row-major) how the friction of a contact that rubs changes with
/// v.
template <class S>
void subtract_friction_by_v(const CompiledContact& contact, const Kinematics<S>& kinematics,
                            const ContactState<S>& state, S* dtau_dv, int stride);

/// True when subtract_force_transport couples entries of v that are not on one branch.
bool transport_couples_branches(const CompiledContact& contact);

}  // namespace burnish

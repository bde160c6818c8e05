// Poses, velocities, errors and Jacobian of one contact. Motions are kept in world axes about the
// world's origin and written in the reference at the end, so that only the held rows are computed.
#pragma once

#include "contact/compiled_contact.hpp"
#include "contact/sliding_friction.hpp"
#include "dynamics/curved_axes.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/reference.hpp"

namespace burnish {

/// Filled by update_contact; force_world by set_contact_force. World axes.
template <class S>
struct ContactState {
  Mat3<S> axes;              ///< columns: the reference's axes
  Vec3<S> origin;            ///< of the reference, m
  Mat3<S> tool_R;            ///< of C2
  Vec3<S> p;                 ///< origin of C2, m
  Motion<S> v_tool, v_base;  ///< twists of the bodies, about the world's origin
  Motion<S> nu;              ///< v_tool - v_base, about the world's origin
  Motion<S> eta;     ///< the twist in alpha = a_L + eta x nu that tells the accelerations apart
  Motion<S> error;   ///< pose error, linear part of the tool's origin; valid if proportional
  Vec3<S> target_p;  ///< origin of the target, m; valid if proportional
  Vec3<S> rotation_error;  ///< R_tool log(R_target^T R_tool); valid if proportional
  S rotation_angle;        ///< its length
  Force<S> force_world;    ///< on the tool by the base, moment about the world's origin
  CurvedAxes<S> curved;    ///< world axes; valid if the reference is curved
  Sliding<S> sliding;      ///< valid if the contact rubs
  /// What is numerical of a contact is slower by this factor, at most 1: gains are pace kd and
  /// pace^2 kp, friction fades below speed / pace. Stays when the state is updated.
  S pace{1.0};
};

/// Angle, rad, by which axes that follow a surface turn beyond those of the base, per unit rate of
/// an entry of v that moves the tool by `relative` against the base (about the world's origin).
template <class S>
BURNISH_INLINE Vec3<S> curved_turn(const ContactState<S>& state, const Motion<S>& relative) {
  return state.curved.turn(state.curved.normal_change(at_point(relative, state.p).linear));
}

/// Everything of the state but the force. `axes` are those of the reference in their body; the
/// surface is read where the reference follows one, the coefficient where the contact rubs.
template <class S>
void update_contact(const CompiledContact& contact, const Mat3<S>& axes,
                    const CurvedSurface<S>& surface, const S& friction,
                    const Kinematics<S>& kinematics, ContactState<S>& state);

/// Torques (nv entries, those of the support) of friction on the joints for lambda of one.
template <class S>
void friction_torque(const CompiledContact& contact, const Kinematics<S>& kinematics,
                     const ContactState<S>& state, S* out);

/// C2 and C1, without what moves them.
CompiledFrame tool_of(const CompiledContact& contact);
CompiledFrame base_of(const CompiledContact& contact);
/// What `reference` means at this contact.
CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledContact& contact);

/// Column k of the Jacobian for each support entry, as out[entry * stride + row]: the rate of nu's
/// held rows per unit rate of that entry.
template <class S>
void contact_jacobian(const CompiledContact& contact, const Kinematics<S>& kinematics,
                      const ContactState<S>& state, S* out_by_v, int stride);

/// Held rows of alpha + kd nu + kp e (gains at the state's pace), where the bodies' spatial
/// accelerations (world axes, about the world's origin, without gravity) are given.
template <class S>
void contact_acceleration(const CompiledContact& contact, const ContactState<S>& state,
                          const Motion<S>& a_tool, const Motion<S>& a_base, S* out);

/// Held rows of the velocity nu and of the error e alone.
template <class S>
void contact_velocity(const CompiledContact& contact, const ContactState<S>& state, S* out);
template <class S>
void contact_error(const CompiledContact& contact, const ContactState<S>& state, S* out);

/// The world wrench of lambda (held rows) alone, moment about the world's origin.
template <class S>
Force<S> wrench_of_rows(const CompiledContact& contact, const S* lambda,
                        const ContactState<S>& state);

/// The world wrench of lambda (held rows), and of the friction that goes with it: fills
/// state.force_world and state.sliding.normal_force.
template <class S>
void set_contact_force(const CompiledContact& contact, const S* lambda, ContactState<S>& state);

/// Of state.force_world, what the held rows alone exert: it moves with the reference.
template <class S>
BURNISH_INLINE Force<S> held_force(const CompiledContact& contact, const ContactState<S>& state) {
  if (!contact.rubs) return state.force_world;
  return state.force_world - state.sliding.per_normal * state.sliding.normal_force;
}

/// Derivative by q_k, at constant lambda, of the rest. The entry moves tool and base by these axes
/// (-1: not), and turns the reference's by w_axes.
template <class S>
BURNISH_INLINE Force<S> friction_by_q(const CompiledContact& contact, const ContactState<S>& state,
                                      int tool_axis, int base_axis, const Vec3<S>& w_axes,
                                      const Kinematics<S>& kinematics) {
  const SlidingEntry<S> entry =
      sliding_entry(tool_axis, base_axis, w_axes, state.v_tool, state.v_base, kinematics);
  return sliding_by_q(*contact.spec.friction, state.sliding, state.p, entry) *
         state.sliding.normal_force;
}

}  // namespace burnish

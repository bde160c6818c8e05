// Poses, velocities, errors and Jacobian of one contact. Motions are in world axes, about the
// world's origin. The last step converts only the constrained rows to the axes of the reference.
#pragma once

#include "contact/compiled_contact.hpp"
#include "contact/sliding_friction.hpp"
#include "dynamics/curved_axes.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/reference.hpp"

namespace burnish {

/// State of one contact, in world axes. update_contact() fills all fields but those of the force,
/// which set_contact_force() fills.
template <class S>
struct ContactState {
  Mat3<S> axes;              ///< Axes of the reference, as columns
  Vec3<S> origin;            ///< Origin of the reference [m]
  Mat3<S> tool_R;            ///< Rotation of the tool frame C2
  Vec3<S> p;                 ///< Origin of the tool frame C2 [m]
  Motion<S> v_tool, v_base;  ///< Twists of the bodies, about the world's origin
  Motion<S> nu;              ///< v_tool - v_base, about the world's origin
  Motion<S> eta;           ///< Twist in alpha = a_L + eta x nu; depends on the kind of acceleration
  Motion<S> error;         ///< Pose error, with the position error at p; valid if proportional
  Vec3<S> target_p;        ///< Origin of the target [m]; valid if proportional
  Vec3<S> rotation_error;  ///< R_tool log(R_target^T R_tool) [rad]; valid if proportional
  S rotation_angle;        ///< Length of rotation_error [rad]; valid if proportional
  Force<S> force_world;    ///< Force of the base on the tool, moment about the world's origin
  CurvedAxes<S> curved;    ///< Curved axes; valid if the reference is curved
  Sliding<S> sliding;      ///< Sliding friction; valid if the contact has friction
  /// Ratio of the stage step to the knot step, at most 1. The gains are step_ratio kd and
  /// step_ratio^2 kp. The smoothing speed of friction is fade_speed() / step_ratio.
  /// update_contact() does not change the ratio.
  S step_ratio{1.0};
};

/// Returns the angular velocity of axes that follow a surface, relative to the base, at a unit rate
/// of one entry of v. `relative` is the twist of the tool relative to the base at that rate, about
/// the world's origin.
template <class S>
BURNISH_INLINE Vec3<S> curved_turn(const ContactState<S>& state, const Motion<S>& relative) {
  return state.curved.turn(state.curved.normal_change(at_point(relative, state.p).linear));
}

/// Updates everything but the force. `axes` are the axes of the reference in their body. `surface`
/// is used if the reference is curved, the coefficient `friction` if the contact has friction.
template <class S>
void update_contact(const CompiledContact& contact, const Mat3<S>& axes,
                    const CurvedSurface<S>& surface, const S& friction,
                    const Kinematics<S>& kinematics, ContactState<S>& state);

/// Computes the joint torques of friction per unit of normal force. Writes only the entries of the
/// support in `out` (nv).
template <class S>
void friction_torque(const CompiledContact& contact, const Kinematics<S>& kinematics,
                     const ContactState<S>& state, S* out);

/// Return the tool frame C2 and the base frame C1, each with an empty support.
CompiledFrame tool_of(const CompiledContact& contact);
CompiledFrame base_of(const CompiledContact& contact);
/// Compiles `reference` for the tool and base of this contact.
CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledContact& contact);

/// Computes J^T for the entries k of the support: out_by_v[k * stride + row] is a constrained row
/// of the velocity nu at a unit rate of entry k.
template <class S>
void contact_jacobian(const CompiledContact& contact, const Kinematics<S>& kinematics,
                      const ContactState<S>& state, S* out_by_v, int stride);

/// Computes the constrained rows of alpha + kd nu + kp e: contact acceleration alpha, plus gains
/// times velocity nu and pose error e. The gains are scaled by the step ratio. `a_tool` and
/// `a_base` are the spatial accelerations of the bodies, without gravity, in world axes about the
/// world's origin.
template <class S>
void contact_acceleration(const CompiledContact& contact, const ContactState<S>& state,
                          const Motion<S>& a_tool, const Motion<S>& a_base, S* out);

/// Compute the constrained rows of the velocity nu and of the error e.
template <class S>
void contact_velocity(const CompiledContact& contact, const ContactState<S>& state, S* out);
template <class S>
void contact_error(const CompiledContact& contact, const ContactState<S>& state, S* out);

/// Returns the wrench of lambda (constrained rows) without friction, in world axes about the
/// world's origin.
template <class S>
Force<S> wrench_of_rows(const CompiledContact& contact, const S* lambda,
                        const ContactState<S>& state);

/// Fills state.sliding.normal_force, and sets state.force_world to the wrench of lambda
/// (constrained rows) plus the wrench of friction.
template <class S>
void set_contact_force(const CompiledContact& contact, const S* lambda, ContactState<S>& state);

/// Returns the part of state.force_world that is not friction. This part moves rigidly with the
/// reference.
template <class S>
BURNISH_INLINE Force<S> held_force(const CompiledContact& contact, const ContactState<S>& state) {
  if (!contact.has_friction) return state.force_world;
  return state.force_world - state.sliding.per_normal * state.sliding.normal_force;
}

/// Returns the derivative of the friction wrench by entry k of q, at constant lambda. Entry k moves
/// the tool along axis `tool_axis` and the base along axis `base_axis`; -1: no motion. w_axes is
/// the angular velocity of the reference axes at a unit rate of entry k.
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

// Derivatives of the wrench of a contact in any reference.
#pragma once

#include <vector>

#include "contact/contact_kinematics.tpp"

namespace burnish {

/// Entry of v that moves the reference of the contact or the requested reference of its wrench.
struct WrenchEntry {
  int v;
  ReferenceAxes own,
      requested;  ///< Axes that move the contact's reference, and the requested reference
  /// Axes that move tool and base. Each is -1 unless the contact's reference follows a surface or
  /// the contact has friction.
  int tool_axis = -1, base_axis = -1;
};

/// Fills `out` with all entries, ascending in v. Does not allocate if the capacity of `out` is at
/// least nv.
void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& requested, std::vector<WrenchEntry>& out);

/// Returns the derivative of state.force_world by an entry of q, in the requested reference at
/// `pose`. `dlambda` is the derivative of lambda, as a wrench in world axes.
///
/// The wrench W of lambda moves with the contact's reference. If V_k is the twist of that reference
/// per unit rate of the entry, the derivative of W is V_k x* W. The derivative of friction is
/// added. The sum is then converted to the derivative relative to the requested reference.
template <class S>
Force<S> wrench_rate(const CompiledContact& contact, const ReferencePose<S>& pose,
                     const WrenchEntry& entry, const ContactState<S>& state,
                     const Kinematics<S>& kinematics, const Force<S>& dlambda) {
  Motion<S> own = reference_twist(entry.own, state.origin, kinematics);
  if (contact.reference.is_curved && entry.tool_axis != entry.base_axis) {
    const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
    const Motion<S> relative = axis(entry.tool_axis) - axis(entry.base_axis);
    own += turning_at(state.p, curved_turn(state, relative));
  }
  const Motion<S> requested = reference_twist(entry.requested, pose, kinematics);
  if (!contact.has_friction)
    return in_reference(pose, dlambda + cross(own - requested, state.force_world));
  const Force<S> friction =
      friction_by_q(contact, state, entry.tool_axis, entry.base_axis, own.angular, kinematics);
  const Force<S> moved =
      cross(own, held_force(contact, state)) - cross(requested, state.force_world) + friction;
  return in_reference(pose, dlambda + moved);
}

/// Returns the derivative of state.force_world by an entry of v, in the requested reference at
/// `pose`. It consists of `dlambda` and the derivative of friction.
template <class S>
Force<S> wrench_rate_by_v(const CompiledContact& contact, const ReferencePose<S>& pose,
                          const ContactSupport& entry, const ContactState<S>& state,
                          const Kinematics<S>& kinematics, const Force<S>& dlambda) {
  if (!contact.has_friction || entry.carries_both()) return in_reference(pose, dlambda);
  const Motion<S> relative = contact_detail::relative_axis(entry, kinematics);
  const Force<S> friction = sliding_by_v(state.sliding, relative) * state.sliding.normal_force;
  return in_reference(pose, dlambda + friction);
}

}  // namespace burnish

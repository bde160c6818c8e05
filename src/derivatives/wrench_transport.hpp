// The wrench of a contact in any reference, and its derivative.
#pragma once

#include <vector>

#include "contact/contact_kinematics.tpp"

namespace burnish {

/// An entry of v that moves the contact's own reference or the one that its wrench is asked in.
struct WrenchEntry {
  int v;
  ReferenceAxes own, asked;
  /// Of the contact, where its own reference follows a surface or it rubs; else the same, which is
  /// nothing.
  int tool_axis = -1, base_axis = -1;
};

/// Fills `out`, ascending in v. Allocates nothing where `out` has room for nv entries.
void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out);

/// Derivative of state.force_world in the reference at `pose`, when lambda changes by `dlambda`
/// (world wrench of the change) and an entry of q moves both references: what is held moves with
/// the contact's own, V_k x* W, friction as it does, and both are seen from the one that is asked
/// for.
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
  const Motion<S> asked = reference_twist(entry.asked, pose, kinematics);
  if (!contact.rubs) return in_reference(pose, dlambda + cross(own - asked, state.force_world));
  const Force<S> friction =
      friction_by_q(contact, state, entry.tool_axis, entry.base_axis, own.angular, kinematics);
  const Force<S> moved =
      cross(own, held_force(contact, state)) - cross(asked, state.force_world) + friction;
  return in_reference(pose, dlambda + moved);
}

/// The same when an entry of v changes, beside `dlambda`: that of a contact that rubs.
template <class S>
Force<S> wrench_rate_by_v(const CompiledContact& contact, const ReferencePose<S>& pose,
                          const ContactSupport& entry, const ContactState<S>& state,
                          const Kinematics<S>& kinematics, const Force<S>& dlambda) {
  if (!contact.rubs || entry.carries_both()) return in_reference(pose, dlambda);
  const Motion<S> relative = contact_detail::relative_axis(entry, kinematics);
  const Force<S> friction = sliding_by_v(state.sliding, relative) * state.sliding.normal_force;
  return in_reference(pose, dlambda + friction);
}

}  // namespace burnish

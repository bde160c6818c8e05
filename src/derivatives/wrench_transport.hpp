// The wrench of a contact in any reference, and its derivative.
#pragma once

#include <vector>

#include "contact/contact_kinematics.hpp"

namespace burnish {

/// An entry of v that moves the contact's own reference or the one that its wrench is asked in.
struct WrenchEntry {
  int v;
  ReferenceAxes own, asked;
  /// Of the contact, where its own reference follows a surface; else the same, which is nothing.
  int tool_axis = -1, base_axis = -1;
};

/// Fills `out`, ascending in v. Allocates nothing where `out` has room for nv entries.
void wrench_entries(const Tree& tree, const CompiledContact& contact,
                    const CompiledReference& asked, std::vector<WrenchEntry>& out);

/// Derivative of state.force_world in the reference at `pose`, when lambda changes by `dlambda`
/// (world wrench of the change) and an entry of v moves both references: the wrench moves with the
/// contact's own, V_k x* W, and is seen from the one that is asked for.
template <class S>
Force<S> wrench_rate(const ReferencePose<S>& pose, const WrenchEntry& entry,
                     const ContactState<S>& state, const Kinematics<S>& kinematics,
                     const Force<S>& dlambda) {
  Motion<S> V = reference_twist(entry.own, state.origin, kinematics) -
                reference_twist(entry.asked, pose.p, kinematics);
  if (entry.tool_axis != entry.base_axis) {
    const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
    const Motion<S> relative = axis(entry.tool_axis) - axis(entry.base_axis);
    V += turning_at(state.p, curved_turn(state, relative));
  }
  return in_reference(pose, dlambda + cross(V, state.force_world));
}

}  // namespace burnish

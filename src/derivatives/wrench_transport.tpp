// The wrench of a contact and its derivatives, written in any reference.
#pragma once

#include "contact/contact_kinematics.tpp"

namespace burnish {

/// Pose of a reference at a contact's state: axes in the world, origin in the world.
template <class S>
contact_detail::Pose<S> reference_pose(const Reference& reference, const CompiledContact& contact,
                                       const Kinematics<S>& kinematics,
                                       const ContactState<S>& state) {
  const bool world = reference.origin == Reference::Origin::World;
  const Vec3<S> origin = world ? Vec3<S>::zero() : state.p;
  const Mat3<S> rotation = lift<S>(from_eigen(reference.rotation));
  switch (reference.axes) {
    case Reference::Axes::Tool:
      return {state.tool_R * rotation, origin};
    case Reference::Axes::Base:
      return {
          contact_detail::pose_of<S>(contact.base_body, contact.base_R, contact.base_p, kinematics)
                  .R *
              rotation,
          origin};
    case Reference::Axes::World:
      return {rotation, origin};
  }
  return {rotation, origin};
}

/// state.force_world in the reference with that pose.
template <class S>
Force<S> wrench_in(const contact_detail::Pose<S>& pose, const Force<S>& force_world) {
  const Force<S> there = at_point(force_world, pose.p);
  return {transpose_times(pose.R, there.linear), transpose_times(pose.R, there.angular)};
}

/// Derivative of that wrench when lambda changes by `dlambda` (world wrench of the change) and
/// entry `entry` of v turns tool and base: the transport rule for forces, from the contact's own
/// reference to the world and from there to `target`.
template <class S>
Force<S> wrench_rate(const Reference& target, const contact_detail::Pose<S>& pose,
                     const CompiledContact& contact, const ContactState<S>& state,
                     const Motion<S>& tool, const Motion<S>& base, const Force<S>& dlambda) {
  using namespace contact_detail;
  const Vec3<S> dp = at_point(tool, state.p).linear;
  const auto rate_of_axes = [&](const Reference& reference) {
    return reference.axes == Reference::Axes::Tool   ? tool.angular
           : reference.axes == Reference::Axes::Base ? base.angular
                                                     : Vec3<S>::zero();
  };
  // World wrench about the world's origin at constant components in the contact's reference.
  Force<S> dW = dlambda;
  const Vec3<S> w = rate_of_axes(contact.spec.reference);
  const Force<S> own = at_point(state.force_world, state.origin);
  const Vec3<S> df = cross(w, own.linear);
  dW.linear += df;
  dW.angular += cross(w, own.angular) + cross(state.origin, df);
  if (!at_world_origin(contact)) dW.angular += cross(dp, own.linear);
  // Components in the target, whose axes turn and whose origin may move.
  const Force<S> there = at_point(state.force_world, pose.p);
  Force<S> rate = at_point(dW, pose.p);
  if (target.origin == Reference::Origin::Tool) rate.angular -= cross(dp, there.linear);
  const Vec3<S> w_target = rate_of_axes(target);
  rate.linear -= cross(w_target, there.linear);
  rate.angular -= cross(w_target, there.angular);
  return {transpose_times(pose.R, rate.linear), transpose_times(pose.R, rate.angular)};
}

}  // namespace burnish

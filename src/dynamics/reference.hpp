// A reference at a state: where it is, how it moves, and how both change with the state. Whatever
// writes numbers in a reference asks here: contacts, wrenches, frames and costs.
//
// With X the map from motions in world coordinates about the world's origin to the reference, and
// V_k the twist of the reference per unit rate of entry k of v,
//   d(X m)/dq_k = X (dm/dq_k - V_k x m),   d(X^-T f)/dq_k = X^-T (df/dq_k - V_k x* f).
// The origin o may be fixed in one body and the axes in another: the twist moves o with the first
// and turns with the second.
#pragma once

#include <span>

#include "burnish/dynamics/reference.hpp"
#include "dynamics/compiled_reference.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"

namespace burnish {

/// What an anchor is fixed in, of those that it may mean; frame(name) answers for one of the robot.
template <class Place>
Place fixed_in(const Anchor& anchor, const Place& tool, const Place& base, const Place& world,
               const auto& frame) {
  switch (anchor.of) {
    case Anchor::Tool:
      return tool;
    case Anchor::Base:
      return base;
    case Anchor::World:
      break;
    case Anchor::Frame:
      return frame(anchor.frame);
  }
  return world;
}

/// `tool` and `base` are what the reference means by these names. Throws Error with the nearest
/// known name where it names a frame that the model lacks, and where it turns over time.
CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledFrame& tool, const CompiledFrame& base);

/// To 1e-6.
bool is_rotation(const Eigen::Matrix3d& matrix);
/// Of entries x, y, z, w: whether they are a rotation (to 1e-6), and which.
bool is_unit_quaternion(const ConstVectorRef& xyzw);
Eigen::Matrix3d rotation_matrix(const ConstVectorRef& xyzw);

/// World axes.
template <class S>
struct ReferencePose {
  Mat3<S> R;  ///< reference -> world
  Vec3<S> p;  ///< origin, m
};

/// A motion that turns with w about a line through the point p, about the world's origin.
template <class S>
BURNISH_INLINE Motion<S> turning_at(const Vec3<S>& p, const Vec3<S>& w) {
  return {cross(p, w), w};
}
/// A motion with linear part l at the point p, about the world's origin.
template <class S>
BURNISH_INLINE Motion<S> moving_at(const Vec3<S>& p, const Vec3<S>& l, const Vec3<S>& w) {
  return {l + cross(p, w), w};
}

template <class S>
BURNISH_INLINE Vec3<S> reference_origin(const CompiledReference& reference,
                                        const Kinematics<S>& kinematics) {
  if (reference.origin_body < 0) return lift<S>(reference.origin);
  const BodyState<S>& body = kinematics.bodies[reference.origin_body];
  return body.p + body.R * lift<S>(reference.origin);
}

/// `axes` are those of the reference in their body: reference.axes, or others in their place.
template <class S>
BURNISH_INLINE Mat3<S> reference_axes(const CompiledReference& reference, const Mat3<S>& axes,
                                      const Kinematics<S>& kinematics) {
  if (reference.axes_body < 0) return axes;
  return kinematics.bodies[reference.axes_body].R * axes;
}

template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const Kinematics<S>& kinematics) {
  return {reference_axes(reference, lift<S>(reference.axes), kinematics),
          reference_origin(reference, kinematics)};
}

/// The same with another rotation in the place of its own.
template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const Mat3<S>& rotation,
                                               const Kinematics<S>& kinematics) {
  return {reference_axes(reference, lift<S>(reference.fixed_in) * rotation, kinematics),
          reference_origin(reference, kinematics)};
}

/// X m: a motion in world coordinates about the world's origin, in the reference.
template <class S>
BURNISH_INLINE Motion<S> in_reference(const CompiledReference& reference,
                                      const ReferencePose<S>& at, const Motion<S>& m) {
  const Motion<S> there = reference.at_world ? m : at_point(m, at.p);
  if (reference.is_aligned) return there;
  return {transpose_times(at.R, there.linear), transpose_times(at.R, there.angular)};
}
/// X^-T f: a wrench in world coordinates about the world's origin, in the reference.
template <class S>
BURNISH_INLINE Force<S> in_reference(const ReferencePose<S>& at, const Force<S>& f) {
  const Force<S> there = at_point(f, at.p);
  return {transpose_times(at.R, there.linear), transpose_times(at.R, there.angular)};
}

/// Twist of the reference, when these are the twists of what its origin (at p) and its axes are
/// fixed in.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const Vec3<S>& p, const Motion<S>& origin,
                                         const Motion<S>& axes) {
  return moving_at(p, at_point(origin, p).linear, axes.angular);
}

/// The same at the velocity of the state.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const CompiledReference& reference, const Vec3<S>& p,
                                         const Kinematics<S>& kinematics) {
  const auto twist = [&](int body) {
    return body < 0 ? Motion<S>::zero() : kinematics.bodies[body].v;
  };
  if (reference.origin_body == reference.axes_body) return twist(reference.axes_body);
  return reference_twist(p, twist(reference.origin_body), twist(reference.axes_body));
}

/// V_k: the same per unit rate of an entry.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const ReferenceAxes& by, const Vec3<S>& p,
                                         const Kinematics<S>& kinematics) {
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  if (by.origin == by.axes) return axis(by.axes);
  if (by.axes < 0) return {at_point(axis(by.origin), p).linear, Vec3<S>::zero()};
  return reference_twist(p, axis(by.origin), axis(by.axes));
}

/// Derivative of the reference's twist by q_k; by v_k it is V_k. With v_O, w_A the twist of the
/// origin's body and the angular velocity of the axes, u_k the step of o per unit of q_k,
///   dV/dq_k moves o with (dv_O/dq_k)(o) + (w_O - w_A) x u_k and turns with dw_A/dq_k,
/// where dv/dq_k = S_k x v + psi'_k for both bodies.
template <class S>
BURNISH_INLINE Motion<S> reference_twist_by_q(const CompiledReference& reference,
                                              const ReferenceAxes& by, const Vec3<S>& p,
                                              const Kinematics<S>& kinematics) {
  const auto by_q = [&](int body, int k) {
    if (k < 0) return Motion<S>::zero();
    const AxisState<S>& axis = kinematics.axes[k];
    return cross(axis.axis, kinematics.bodies[body].v) + axis.parent_rate;
  };
  if (reference.origin_body == reference.axes_body) return by_q(reference.axes_body, by.axes);
  const auto turning = [&](int body) {
    return body < 0 ? Vec3<S>::zero() : kinematics.bodies[body].v.angular;
  };
  const Motion<S> of_axes = by_q(reference.axes_body, by.axes);
  if (by.origin < 0) return turning_at(p, of_axes.angular);
  const Vec3<S> step = at_point(kinematics.axes[by.origin].axis, p).linear;
  const Vec3<S> w = turning(reference.origin_body) - turning(reference.axes_body);
  const Vec3<S> rate = at_point(by_q(reference.origin_body, by.origin), p).linear + cross(w, step);
  return moving_at(p, rate, of_axes.angular);
}

/// Entries of v that move the bodies of a reference's origin and axes.
struct ReferenceSupport {
  std::span<const MovingAxis> origin, axes;
};

/// Calls visit(v, axis, ReferenceAxes) for every entry of v that moves a frame or the reference
/// that it is seen in, ascending; axis is -1 where the frame stands still.
template <class Visit>
BURNISH_INLINE void for_each_entry(const CompiledFrame& frame, const ReferenceSupport& support,
                                   const Visit& visit) {
  const auto is_frames = [&](std::span<const MovingAxis> entries) {
    return entries.data() == frame.support.data();
  };
  const bool origin_moves = !support.origin.empty(), axes_move = !support.axes.empty();
  if ((is_frames(support.origin) || !origin_moves) && (is_frames(support.axes) || !axes_move)) {
    for (const MovingAxis& k : frame.support)
      visit(k.v, k.axis, ReferenceAxes{origin_moves ? k.axis : -1, axes_move ? k.axis : -1});
    return;
  }
  std::span<const MovingAxis> left[3] = {frame.support, support.origin, support.axes};
  while (!left[0].empty() || !left[1].empty() || !left[2].empty()) {
    int v = -1;
    for (const auto& entries : left)
      if (!entries.empty() && (v < 0 || entries.front().v < v)) v = entries.front().v;
    int axis[3] = {-1, -1, -1};
    for (int i = 0; i < 3; ++i)
      if (!left[i].empty() && left[i].front().v == v) {
        axis[i] = left[i].front().axis;
        left[i] = left[i].subspan(1);
      }
    visit(v, axis[0], ReferenceAxes{axis[1], axis[2]});
  }
}

}  // namespace burnish

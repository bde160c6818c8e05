// A reference at a state: where it is, how it moves, and how both change with the state. Whatever
// writes numbers in a reference asks here: contacts, wrenches, frames and costs.
//
// With X the map from motions in world coordinates about the world's origin to the reference, and
// V_k the twist of the reference per unit rate of entry k of v,
//   d(X m)/dq_k = X (dm/dq_k - V_k x m),   d(X^-T f)/dq_k = X^-T (df/dq_k - V_k x* f).
// The origin o may be fixed in one body and the axes in another: the twist moves o with the first
// and turns with the second. Axes that follow a curved surface (curved_axes.hpp) turn as the tool
// moves against the second, on top of that.
#pragma once

#include <span>

#include "burnish/dynamics/reference.hpp"
#include "dynamics/compiled_reference.hpp"
#include "dynamics/curved_axes.hpp"
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
/// known name where it names a frame that the model lacks, where it turns over time, and where it
/// follows a surface that moves with the tool.
CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledFrame& tool, const CompiledFrame& base);

/// As the position of the tool itself is asked in it: where it follows a surface and has its origin
/// at the tool, with the origin of the frame that the surface is fixed in.
Reference asked_for_positions(Reference reference);

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
  bool is_curved = false;
  // Where the axes follow a surface, else not set:
  Vec3<S> tool;          ///< point that they look at it from, m
  CurvedAxes<S> curved;  ///< world axes

  ReferencePose(const Mat3<S>& rotation, const Vec3<S>& origin) : R(rotation), p(origin) {}
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

/// Of a body, about the world's origin; -1 is the world.
template <class S>
BURNISH_INLINE Motion<S> twist_of(int body, const Kinematics<S>& kinematics) {
  return body < 0 ? Motion<S>::zero() : kinematics.bodies[body].v;
}

/// The frame that a surface is fixed in.
template <class S>
BURNISH_INLINE ReferencePose<S> frame_of_surface(const CompiledReference& reference,
                                                 const Kinematics<S>& kinematics) {
  const Mat3<S> R = lift<S>(reference.fixed_in);
  const Vec3<S> p = lift<S>(reference.place);
  if (reference.axes_body < 0) return {R, p};
  const BodyState<S>& body = kinematics.bodies[reference.axes_body];
  return {body.R * R, body.p + body.R * p};
}

/// Turns the axes of `pose`, which are those that they start from, to the surface at the tool.
template <class S>
void follow_surface(const CompiledReference& reference, const CurvedSurface<S>& surface,
                    const Kinematics<S>& kinematics, ReferencePose<S>& pose) {
  const ReferencePose<S> base = frame_of_surface(reference, kinematics);
  const Mat3<S>& R = base.R;
  pose.tool = lift<S>(reference.tool);
  if (reference.tool_body >= 0) {
    const BodyState<S>& body = kinematics.bodies[reference.tool_body];
    pose.tool = body.p + body.R * pose.tool;
  }
  const Motion<S> seen =
      twist_of(reference.tool_body, kinematics) - twist_of(reference.axes_body, kinematics);
  CurvedAxes<S>& at = pose.curved;
  at = curved_axes(surface, transpose_times(R, pose.R.c2), transpose_times(R, pose.tool - base.p));
  move_over(R, at_point(seen, pose.tool).linear, at);
  pose.R = {least_rotation(at.n0, at.n, at.share, pose.R.c0),
            least_rotation(at.n0, at.n, at.share, pose.R.c1), at.n};
  pose.is_curved = true;
}

/// Of a reference that follows a surface: this one, in the place of its own.
template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const CurvedSurface<S>& surface,
                                               const Kinematics<S>& kinematics) {
  ReferencePose<S> pose(reference_axes(reference, lift<S>(reference.axes), kinematics),
                        reference_origin(reference, kinematics));
  follow_surface(reference, surface, kinematics, pose);
  return pose;
}

template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const Kinematics<S>& kinematics) {
  if (reference.is_curved)
    return reference_pose(reference, CurvedSurface<S>{lift<S>(reference.Q), lift<S>(reference.b)},
                          kinematics);
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

/// The same at the velocity of the state, of axes that follow no surface, and of any.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const CompiledReference& reference, const Vec3<S>& p,
                                         const Kinematics<S>& kinematics) {
  const Motion<S> of_axes = twist_of(reference.axes_body, kinematics);
  if (reference.origin_body == reference.axes_body) return of_axes;
  return reference_twist(p, twist_of(reference.origin_body, kinematics), of_axes);
}
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const CompiledReference& reference,
                                         const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  Motion<S> V = reference_twist(reference, at.p, kinematics);
  if (at.is_curved) V += turning_at(at.p, at.curved.w);
  return V;
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

/// Step of the tool's point against what the axes are fixed in, per unit of an entry.
template <class S>
BURNISH_INLINE Vec3<S> step_over_surface(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  return at_point(axis(by.tool) - axis(by.axes), at.tool).linear;
}
/// Angle by which axes that follow a surface turn with that, rad.
template <class S>
BURNISH_INLINE Vec3<S> turn_over_surface(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  return at.curved.turn(at.curved.normal_change(step_over_surface(by, at, kinematics)));
}
/// V_k of axes that may follow a surface.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  Motion<S> V = reference_twist(by, at.p, kinematics);
  if (at.is_curved) V += turning_at(at.p, turn_over_surface(by, at, kinematics));
  return V;
}

/// Derivative by q_k of a body's twist, where `k` is the axis by which the entry moves it.
template <class S>
BURNISH_INLINE Motion<S> twist_by_q(int body, int k, const Kinematics<S>& kinematics) {
  if (k < 0) return Motion<S>::zero();
  const AxisState<S>& axis = kinematics.axes[k];
  return cross(axis.axis, kinematics.bodies[body].v) + axis.parent_rate;
}

/// Derivative of the reference's twist by q_k; by v_k it is V_k. With v_O, w_A the twist of the
/// origin's body and the angular velocity of the axes, u_k the step of o per unit of q_k,
///   dV/dq_k moves o with (dv_O/dq_k)(o) + (w_O - w_A) x u_k and turns with dw_A/dq_k,
/// where dv/dq_k = S_k x v + psi'_k for both bodies.
template <class S>
BURNISH_INLINE Motion<S> reference_twist_by_q(const CompiledReference& reference,
                                              const ReferenceAxes& by, const Vec3<S>& p,
                                              const Kinematics<S>& kinematics) {
  const Motion<S> of_axes = twist_by_q(reference.axes_body, by.axes, kinematics);
  if (reference.origin_body == reference.axes_body) return of_axes;
  const auto turning = [&](int body) { return twist_of(body, kinematics).angular; };
  if (by.origin < 0) return turning_at(p, of_axes.angular);
  const Vec3<S> step = at_point(kinematics.axes[by.origin].axis, p).linear;
  const Vec3<S> w = turning(reference.origin_body) - turning(reference.axes_body);
  const Motion<S> of_origin = twist_by_q(reference.origin_body, by.origin, kinematics);
  return moving_at(p, at_point(of_origin, p).linear + cross(w, step), of_axes.angular);
}

/// The same of axes that may follow a surface: w_C, by which they turn in what they are fixed in
/// (A), changes with A and with what A sees of the tool's point x and of its velocity u, which
/// changes by du/dq_k + w_u x dx, w_u being that of the tool less that of A.
template <class S>
BURNISH_INLINE Motion<S> reference_twist_by_q(const CompiledReference& reference,
                                              const ReferenceAxes& by, const ReferencePose<S>& at,
                                              const Kinematics<S>& kinematics) {
  const Motion<S> fixed = reference_twist_by_q(reference, by, at.p, kinematics);
  if (!at.is_curved) return fixed;
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  const Motion<S> seen =
      twist_of(reference.tool_body, kinematics) - twist_of(reference.axes_body, kinematics);
  const Motion<S> seen_by_q = twist_by_q(reference.tool_body, by.tool, kinematics) -
                              twist_by_q(reference.axes_body, by.axes, kinematics);
  const Vec3<S> carried = axis(by.axes).angular;
  const Vec3<S> moved = at_point(axis(by.tool), at.tool).linear;
  const Vec3<S> rate = at_point(seen_by_q, at.tool).linear + cross(seen.angular, moved) -
                       cross(carried, at_point(seen, at.tool).linear);
  const Vec3<S> step = step_over_surface(by, at, kinematics);
  const CurvedAxes<S>& curved = at.curved;
  const Vec3<S> dw =
      cross(carried, curved.w) + curved.turn_rate_change(step, curved.normal_change(step), rate);
  const Vec3<S> origin_step = at_point(axis(by.origin), at.p).linear;
  return fixed + Motion<S>{cross(origin_step, curved.w) + cross(at.p, dw), dw};
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
      visit(k.v, k.axis,
            ReferenceAxes{origin_moves ? k.axis : -1, axes_move ? k.axis : -1, k.axis});
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
    visit(v, axis[0], ReferenceAxes{axis[1], axis[2], axis[0]});
  }
}

}  // namespace burnish

// Pose and twist of a Reference at a state, and their derivatives. Contacts, wrenches, frames and
// costs use these functions to express quantities in a Reference.
//
// X maps motions in world coordinates about the world's origin to the reference. V_k is the twist
// of the reference per unit rate of entry k of v. Then
//   d(X m)/dq_k = X (dm/dq_k - V_k x m),   d(X^-T f)/dq_k = X^-T (df/dq_k - V_k x* f).
// The origin o can be fixed in one body and the axes in another. The twist then has the velocity of
// o as a point of the first body, and the angular velocity of the second. Axes that follow a curved
// surface (curved_axes.hpp) also turn when the tool moves relative to the second body.
#pragma once

#include <span>

#include "burnish/dynamics/reference.hpp"
#include "dynamics/compiled_reference.hpp"
#include "dynamics/curved_axes.hpp"
#include "dynamics/frame.hpp"
#include "dynamics/kinematics.hpp"

namespace burnish {

/// Returns the argument that `anchor` selects: `tool`, `base`, `world`, or frame(name) for a frame
/// of the robot.
template <class Place>
Place fixed_in(const Anchor& anchor, const Place& tool, const Place& base, const Place& world,
               const auto& frame) {
  switch (anchor.kind) {
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

/// Prepares a reference for the kernels. `tool` and `base` are the frames for Anchor::Tool and
/// Anchor::Base. Throws Error if the reference
/// - names a frame that the model lacks (with the nearest name),
/// - has a rotation over time, or
/// - follows a surface that moves with the tool.
CompiledReference compile_reference(const Model& model, const Reference& reference,
                                    const CompiledFrame& tool, const CompiledFrame& base);

/// Returns the reference frame for coordinates of the tool's position. If the axes follow a surface
/// and the origin is at the tool, the result has its origin at the origin of the surface frame.
/// Otherwise the result equals the argument.
Reference asked_for_positions(Reference reference);

/// Returns true if `matrix` is a rotation matrix, within 1e-6.
bool is_rotation(const Eigen::Matrix3d& matrix);
/// Returns true if the quaternion (x, y, z, w) has unit length, within 1e-6.
bool is_unit_quaternion(const ConstVectorRef& xyzw);
/// Returns the rotation matrix of the quaternion (x, y, z, w).
Eigen::Matrix3d rotation_matrix(const ConstVectorRef& xyzw);

/// Pose of a reference, in world axes.
template <class S>
struct ReferencePose {
  Mat3<S> R;  ///< Rotation from the reference to the world
  Vec3<S> p;  ///< Origin [m]
  bool is_curved = false;
  // Set only if the axes follow a surface:
  Vec3<S> tool;          ///< Point of the tool whose surface normal the axes follow [m]
  CurvedAxes<S> curved;  ///< Axes at this point, in world axes

  ReferencePose(const Mat3<S>& rotation, const Vec3<S>& origin) : R(rotation), p(origin) {}
};

/// Returns the motion, about the world's origin, of a rotation with angular velocity w about a line
/// through the point p.
template <class S>
BURNISH_INLINE Motion<S> turning_at(const Vec3<S>& p, const Vec3<S>& w) {
  return {cross(p, w), w};
}
/// Returns the motion, about the world's origin, with linear velocity l at the point p and angular
/// velocity w.
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

/// Returns the rotation from the reference to the world. `axes`: the axes of the reference in their
/// body, usually reference.axes.
template <class S>
BURNISH_INLINE Mat3<S> reference_axes(const CompiledReference& reference, const Mat3<S>& axes,
                                      const Kinematics<S>& kinematics) {
  if (reference.axes_body < 0) return axes;
  return kinematics.bodies[reference.axes_body].R * axes;
}

/// Twist of a body (-1: the world) about the world's origin.
template <class S>
BURNISH_INLINE Motion<S> twist_of(int body, const Kinematics<S>& kinematics) {
  return body < 0 ? Motion<S>::zero() : kinematics.bodies[body].v;
}

/// Pose of the frame to which the surface of the reference is fixed.
template <class S>
BURNISH_INLINE ReferencePose<S> frame_of_surface(const CompiledReference& reference,
                                                 const Kinematics<S>& kinematics) {
  const Mat3<S> R = lift<S>(reference.fixed_in);
  const Vec3<S> p = lift<S>(reference.place);
  if (reference.axes_body < 0) return {R, p};
  const BodyState<S>& body = kinematics.bodies[reference.axes_body];
  return {body.R * R, body.p + body.R * p};
}

/// Turns the initial axes in `pose` so that they follow the surface at the tool.
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
  const Motion<S> relative =
      twist_of(reference.tool_body, kinematics) - twist_of(reference.axes_body, kinematics);
  CurvedAxes<S>& at = pose.curved;
  at = curved_axes(surface, transpose_times(R, pose.R.c2), transpose_times(R, pose.tool - base.p));
  move_over(R, at_point(relative, pose.tool).linear, at);
  pose.R = {least_rotation(at.n0, at.n, at.inverse_sum, pose.R.c0),
            least_rotation(at.n0, at.n, at.inverse_sum, pose.R.c1), at.n};
  pose.is_curved = true;
}

/// Pose of a reference that follows a surface, with `surface` in place of its own surface.
template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const CurvedSurface<S>& surface,
                                               const Kinematics<S>& kinematics) {
  ReferencePose<S> pose(reference_axes(reference, lift<S>(reference.axes), kinematics),
                        reference_origin(reference, kinematics));
  follow_surface(reference, surface, kinematics, pose);
  return pose;
}

/// Pose of a reference.
template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const Kinematics<S>& kinematics) {
  if (reference.is_curved)
    return reference_pose(reference, CurvedSurface<S>{lift<S>(reference.Q), lift<S>(reference.b)},
                          kinematics);
  return {reference_axes(reference, lift<S>(reference.axes), kinematics),
          reference_origin(reference, kinematics)};
}

/// Pose of a reference, with `rotation` in place of its own rotation.
template <class S>
BURNISH_INLINE ReferencePose<S> reference_pose(const CompiledReference& reference,
                                               const Mat3<S>& rotation,
                                               const Kinematics<S>& kinematics) {
  return {reference_axes(reference, lift<S>(reference.fixed_in) * rotation, kinematics),
          reference_origin(reference, kinematics)};
}

/// Returns X m: transforms a motion from world coordinates about the world's origin to the
/// reference.
template <class S>
BURNISH_INLINE Motion<S> in_reference(const CompiledReference& reference,
                                      const ReferencePose<S>& at, const Motion<S>& m) {
  const Motion<S> there = reference.at_world ? m : at_point(m, at.p);
  if (reference.is_aligned) return there;
  return {transpose_times(at.R, there.linear), transpose_times(at.R, there.angular)};
}
/// Returns X^-T f: transforms a wrench from world coordinates about the world's origin to the
/// reference.
template <class S>
BURNISH_INLINE Force<S> in_reference(const ReferencePose<S>& at, const Force<S>& f) {
  const Force<S> there = at_point(f, at.p);
  return {transpose_times(at.R, there.linear), transpose_times(at.R, there.angular)};
}

/// Twist of a reference with its origin at p. `origin` and `axes` are the twists of the bodies to
/// which its origin and its axes are fixed.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const Vec3<S>& p, const Motion<S>& origin,
                                         const Motion<S>& axes) {
  return moving_at(p, at_point(origin, p).linear, axes.angular);
}

/// Twist of a reference with its origin at p, at the velocity of the state. The rotation of axes
/// that follow a surface is left out.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const CompiledReference& reference, const Vec3<S>& p,
                                         const Kinematics<S>& kinematics) {
  const Motion<S> of_axes = twist_of(reference.axes_body, kinematics);
  if (reference.origin_body == reference.axes_body) return of_axes;
  return reference_twist(p, twist_of(reference.origin_body, kinematics), of_axes);
}
/// Twist of a reference at the velocity of the state. Includes the rotation of axes that follow a
/// surface.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const CompiledReference& reference,
                                         const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  Motion<S> V = reference_twist(reference, at.p, kinematics);
  if (at.is_curved) V += turning_at(at.p, at.curved.w);
  return V;
}

/// Returns V_k: twist of a reference per unit rate of one entry of v. The rotation of axes that
/// follow a surface is left out.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const ReferenceAxes& by, const Vec3<S>& p,
                                         const Kinematics<S>& kinematics) {
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  if (by.origin == by.axes) return axis(by.axes);
  if (by.axes < 0) return {at_point(axis(by.origin), p).linear, Vec3<S>::zero()};
  return reference_twist(p, axis(by.origin), axis(by.axes));
}

/// Displacement of the tool's point relative to the body of the axes, per unit of one entry of v.
template <class S>
BURNISH_INLINE Vec3<S> step_over_surface(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  return at_point(axis(by.tool) - axis(by.axes), at.tool).linear;
}
/// Rotation, per unit of one entry of v, of axes that follow a surface [rad].
template <class S>
BURNISH_INLINE Vec3<S> turn_over_surface(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  return at.curved.turn(at.curved.normal_change(step_over_surface(by, at, kinematics)));
}
/// Returns V_k: twist of a reference per unit rate of one entry of v. Includes the rotation of axes
/// that follow a surface.
template <class S>
BURNISH_INLINE Motion<S> reference_twist(const ReferenceAxes& by, const ReferencePose<S>& at,
                                         const Kinematics<S>& kinematics) {
  Motion<S> V = reference_twist(by, at.p, kinematics);
  if (at.is_curved) V += turning_at(at.p, turn_over_surface(by, at, kinematics));
  return V;
}

/// Derivative of a body's twist by an entry of q that moves the body along axis `k`.
template <class S>
BURNISH_INLINE Motion<S> twist_by_q(int body, int k, const Kinematics<S>& kinematics) {
  if (k < 0) return Motion<S>::zero();
  const AxisState<S>& axis = kinematics.axes[k];
  return cross(axis.axis, kinematics.bodies[body].v) + axis.parent_rate;
}

/// Derivative by q_k of the twist V of a reference, without the rotation of axes that follow a
/// surface. (The derivative by v_k is V_k.) v_O and w_O are the twist and the angular velocity of
/// the origin's body, w_A is the angular velocity of the axes, and u_k is the displacement of the
/// origin o per unit of q_k. dV/dq_k has the linear part (dv_O/dq_k)(o) + (w_O - w_A) x u_k at o,
/// and the angular part dw_A/dq_k. twist_by_q() computes the derivatives of both bodies' twists.
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

/// Derivative by q_k of the twist of a reference, including the rotation of axes that follow a
/// surface. A is the body of the axes. Relative to A, w_C and w_u are the angular velocities of the
/// axes and the tool, and x and u are position and velocity of the tool's point. w_C turns with A
/// and depends on x and u. If the point moves by dx, u changes by du/dq_k + w_u x dx.
template <class S>
BURNISH_INLINE Motion<S> reference_twist_by_q(const CompiledReference& reference,
                                              const ReferenceAxes& by, const ReferencePose<S>& at,
                                              const Kinematics<S>& kinematics) {
  const Motion<S> fixed = reference_twist_by_q(reference, by, at.p, kinematics);
  if (!at.is_curved) return fixed;
  const auto axis = [&](int k) { return k < 0 ? Motion<S>::zero() : kinematics.axes[k].axis; };
  const Motion<S> relative =
      twist_of(reference.tool_body, kinematics) - twist_of(reference.axes_body, kinematics);
  const Motion<S> relative_by_q = twist_by_q(reference.tool_body, by.tool, kinematics) -
                                  twist_by_q(reference.axes_body, by.axes, kinematics);
  const Vec3<S> carried = axis(by.axes).angular;
  const Vec3<S> moved = at_point(axis(by.tool), at.tool).linear;
  const Vec3<S> rate = at_point(relative_by_q, at.tool).linear + cross(relative.angular, moved) -
                       cross(carried, at_point(relative, at.tool).linear);
  const Vec3<S> step = step_over_surface(by, at, kinematics);
  const CurvedAxes<S>& curved = at.curved;
  const Vec3<S> dw =
      cross(carried, curved.w) + curved.turn_rate_change(step, curved.normal_change(step), rate);
  const Vec3<S> origin_step = at_point(axis(by.origin), at.p).linear;
  return fixed + Motion<S>{cross(origin_step, curved.w) + cross(at.p, dw), dw};
}

/// Entries of v that move the bodies to which a reference's origin and axes are fixed.
struct ReferenceSupport {
  std::span<const MovingAxis> origin, axes;
};

/// Calls visit(v, axis, ReferenceAxes) in ascending order for every entry of v that moves the frame
/// or its reference. `axis` is -1 if the entry does not move the frame.
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

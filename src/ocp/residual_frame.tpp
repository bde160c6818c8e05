// Residuals of a frame's placement and velocity. The columns of their Jacobians are the entries of
// v that move the frame or the reference.
#pragma once

#include <type_traits>

#include "derivatives/frame_kinematics.hpp"
#include "dynamics/columns.hpp"
#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {
namespace frame_detail {

template <class S>
void store(const Vec3<S>& x, S* out) {
  out[0] = x.x;
  out[1] = x.y;
  out[2] = x.z;
}
template <class S>
void store(const Motion<S>& m, S* out) {
  store(m.linear, out);
  store(m.angular, out + 3);
}

/// Copies the columns of the given `entries` of v from `full` to `out`, side by side. `full` is
/// 6 x nv; the rows of `out` are `stride` apart.
template <class S, class Entry>
void keep_columns(const S* full, int nv, const std::vector<Entry>& entries, S* out, int stride) {
  const auto index = [](const auto& entry) {
    if constexpr (std::is_same_v<Entry, int>)
      return entry;
    else
      return entry.v;
  };
  for (int i = 0; i < 6; ++i)
    for (std::size_t k = 0; k < entries.size(); ++k)
      out[i * stride + static_cast<int>(k)] = full[i * nv + index(entries[k])];
}

/// Calls visit(turn) for every entry of v that moves a frame or its reference. `turn` is the
/// angular velocity of the frame relative to the reference per unit of this entry, in world axes.
template <class S>
void for_each_turn(const KnotState<S>& knot, int frame, const FrameReference<S>& seen,
                   const auto& visit) {
  const Kinematics<S>& kinematics = knot.dynamics->kinematics();
  for_each_entry(knot.compiled_frames[frame], seen.support,
                 [&](int, int k, const ReferenceAxes& by) {
                   Vec3<S> turn = -reference_twist(by, seen.pose, kinematics).angular;
                   if (k >= 0) turn += kinematics.axes[k].axis.angular;
                   visit(turn);
                 });
}

}  // namespace frame_detail

template <class S>
FrameReference<S> FrameView::at(const KnotState<S>& knot, int frame) const {
  const CompiledFrame& seen = knot.compiled_frames[frame];
  const auto support = [&](int body, const std::vector<MovingAxis>& other) {
    return std::span<const MovingAxis>(body == seen.body ? seen.support : other);
  };
  return {reference,
          reference.pose(knot),
          {support(reference.origin_body, origin), support(reference.axes_body, axes)}};
}

template <class S>
void FramePositionError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const FrameState<S>& state = knot.frames[frame];
  const Kinematics<S>& kinematics = knot.dynamics->kinematics();
  const FrameReference<S> seen = view.at(knot, frame);
  const ReferencePose<S>& at = seen.pose;
  Vec3<S> p_target{target[0], target[1], target[2]};
  if (!is_in_world)
    p_target = at.p + reference_axes(view.reference, lift<S>(view.reference.fixed_in), kinematics) *
                          p_target;
  frame_detail::store(transpose_times(at.R, state.p - p_target), r);
  if (J == nullptr) return;
  // Each column is the velocity of the frame minus that of the target, both relative to the
  // reference. The target is at rest in the frame in which the axes are fixed. Axes that follow a
  // surface turn relative to that frame, so that the target moves in these axes.
  const int columns = static_cast<int>(view.entries.size());
  S* out = J;
  for_each_entry(knot.compiled_frames[frame], seen.support,
                 [&](int, int k, const ReferenceAxes& by) {
                   Motion<S> m = -reference_twist(by, at.p, kinematics);
                   if (k >= 0) m += kinematics.axes[k].axis;
                   if (at.is_curved)
                     m = m - turning_at(p_target, turn_over_surface(by, at, kinematics));
                   store_column(transpose_times(at.R, at_point(m, state.p).linear), out++, columns);
                 });
}

template <class S>
void FrameDistance::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J,
                             S* curvatures) const {
  S e[3];
  S* const by_q = J == nullptr ? nullptr : knot.scratch;
  position.evaluate(knot, target, e, by_q);
  S squared(1e-12);  // (1e-6 m)^2, makes the length differentiable at zero
  for (int i = 0; i < 3; ++i)
    if (directions.has(i)) squared += e[i] * e[i];
  r[0] = square_root(squared);
  if (J == nullptr) return;
  const int columns = static_cast<int>(position.view.entries.size());
  for (int k = 0; k < columns; ++k) {
    S sum(0.0);
    for (int i = 0; i < 3; ++i)
      if (directions.has(i)) sum += e[i] * by_q[i * columns + k];
    J[k] = sum / r[0];
  }
  if (curvatures == nullptr) return;
  // The length r of the error e has the second derivative (1 - n n^T) / r with n = e / r. It equals
  // B^T B with B = S(n) / sqrt(r), where S(n) is the matrix of the cross product n x. With two
  // directions, only one row of B is used.
  const S scale = S(1.0) / (r[0] * square_root(r[0]));
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    if (!directions.has(a) || !directions.has(b)) continue;
    const S ea = scale * e[a], eb = scale * e[b];
    for (int k = 0; k < columns; ++k)
      curvatures[k] = ea * by_q[b * columns + k] - eb * by_q[a * columns + k];
    curvatures += columns;
  }
}

template <class S>
void FrameRotationError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const FrameState<S>& state = knot.frames[frame];
  const FrameReference<S> seen = view.at(knot, frame);
  Mat3<S> wanted = rotation_of(target);
  if (!view.reference.is_aligned) wanted = seen.pose.R * wanted;
  const FrameError<S> error = frame_error(state, wanted, Vec3<S>::zero());
  frame_detail::store(error.rotation, r);
  if (J == nullptr) return;
  const int columns = static_cast<int>(view.entries.size());
  frame_detail::for_each_turn(knot, frame, seen, [&](const Vec3<S>& turn) {
    const Vec3<S> turning = transpose_times(state.R, turn);
    store_column(d_log_rotation(error.terms, error.rotation, turning), J++, columns);
  });
}

template <class S>
void FrameInclinationError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const FrameState<S>& state = knot.frames[frame];
  const FrameReference<S> seen = view.at(knot, frame);
  const Vec3<S> along = state.R * lift<S>(axis);
  const Vec3<S> e = transpose_times(seen.pose.R, along);
  r[0] = arc_tangent2(e.x, e.z) - target[0];
  r[1] = arc_tangent2(e.y, e.z) - target[1];
  if (J == nullptr) return;
  // An angle is undefined if both of its arguments are 0. `tiny` makes its derivative 0 there.
  const S tiny(1e-30);
  const S by_lead = S(1.0) / (e.x * e.x + e.z * e.z + tiny);
  const S by_tilt = S(1.0) / (e.y * e.y + e.z * e.z + tiny);
  const int columns = static_cast<int>(view.entries.size());
  frame_detail::for_each_turn(knot, frame, seen, [&](const Vec3<S>& turn) {
    const Vec3<S> de = transpose_times(seen.pose.R, cross(turn, along));
    J[0] = (e.z * de.x - e.x * de.z) * by_lead;
    J[columns] = (e.z * de.y - e.y * de.z) * by_tilt;
    ++J;
  });
}

/// Height of a point above a surface phi = 0 with gradient g, normal n and Hessian H. At a distance
/// d below the point along n, the value of phi is phi - d |g| + d^2 k / 2 with k = n . H n. The
/// height is the smaller zero of this value, d = 2 phi / (|g| + s) with s^2 = |g|^2 - 2 phi k. If
/// s^2 is below 0.01 |g|^2, s is 0.1 |g| instead, so that the height is always defined.
template <class S>
void FrameHeightError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const Kinematics<S>& kinematics = knot.dynamics->kinematics();
  const FrameReference<S> seen = view.at(knot, frame);
  const ReferencePose<S>& at = seen.pose;
  const CurvedAxes<S>& curved = at.curved;
  const S* const numbers = knot.targets + view.reference.followed;
  const CurvedSurface<S> surface = surface_of(numbers);
  const ReferencePose<S> base = frame_of_surface(view.reference, kinematics);
  const Vec3<S> x = transpose_times(base.R, at.tool - base.p);
  const S phi = dot(x, surface.Q * x) * S(0.5) + dot(surface.b, x) + numbers[surface_size - 1];
  const S length = S(1.0) / curved.per_gradient;
  const Vec3<S> Hn = curved.H * curved.n;
  const S curvature = dot(curved.n, Hn);
  const S squared = length * length - phi * curvature * S(2.0);
  const S min_squared = length * length * S(0.01);
  const auto has_root = less(min_squared, squared);
  const S root = square_root(select(has_root, squared, min_squared));
  const S height = phi * S(2.0) / (length + root);
  r[0] = height - target[0];
  if (J == nullptr) return;
  const Vec3<S> curvature_by_x = (curved.H * Hn - Hn * curvature) * (curved.per_gradient * S(2.0));
  const Vec3<S> exact =
      (Hn * length - curved.n * (length * curvature) - curvature_by_x * phi) * (S(1.0) / root);
  const auto chosen = [&](const S& a, const S& b) { return select(has_root, a, b * S(0.1)); };
  const Vec3<S> root_by_x{chosen(exact.x, Hn.x), chosen(exact.y, Hn.y), chosen(exact.z, Hn.z)};
  const Vec3<S> by_x =
      (curved.n * (length * S(2.0)) - (Hn + root_by_x) * height) * (S(1.0) / (length + root));
  for_each_entry(knot.compiled_frames[frame], seen.support, [&](int, int, const ReferenceAxes& by) {
    *J++ = dot(by_x, step_over_surface(by, at, kinematics));
  });
}

template <class S>
void FramePlacementError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const FrameState<S>& state = knot.frames[frame];
  const FrameError<S> error =
      frame_error(state, rotation_of(target + 3), Vec3<S>{target[0], target[1], target[2]});
  frame_detail::store(error.placement, r);
  if (J == nullptr) return;
  const CompiledFrame& compiled = knot.compiled_frames[frame];
  const int nv = knot.layout->nv;
  frame_placement_error_derivative(compiled, knot.dynamics->kinematics(), state, error,
                                   knot.scratch, nv);
  frame_detail::keep_columns(knot.scratch, nv, compiled.support, J,
                             static_cast<int>(compiled.support.size()));
}

template <class S>
void FrameVelocityError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const FrameState<S>& state = knot.frames[frame];
  const FrameReference<S> seen = view.at(knot, frame);
  frame_detail::store(frame_velocity(view.reference, seen.pose, state), r);
  for (int i = 0; i < 6; ++i) r[i] -= target[i];
  if (J == nullptr) return;
  const CompiledFrame& compiled = knot.compiled_frames[frame];
  const Kinematics<S>& kinematics = knot.dynamics->kinematics();
  const int nv = knot.layout->nv;
  const int by_q = static_cast<int>(view.entries.size());
  const int columns = by_q + static_cast<int>(compiled.support.size());
  frame_velocity_derivative(compiled, seen, kinematics, state, knot.scratch, nv);
  frame_detail::keep_columns(knot.scratch, nv, view.entries, J, columns);
  frame_jacobian(compiled, view.reference, seen.pose, kinematics, knot.scratch, nv);
  frame_detail::keep_columns(knot.scratch, nv, compiled.support, J + by_q, columns);
}

}  // namespace burnish::ocp

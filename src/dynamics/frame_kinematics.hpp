// Placement, velocity, acceleration and Jacobian of a frame that is fixed to a body.
//
// The six numbers of a velocity depend on the axes they are written in and on the point whose
// velocity is meant; FrameAxes chooses both. With X the motion transform from world coordinates
// about the world's origin to that choice, the velocity is X v. The acceleration is everywhere the
// time derivative of those six numbers: with rho the twist of the chosen origin and axes,
//   d(X v)/dt = X (a - rho x v).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "burnish/dynamics/frame_axes.hpp"
#include "dynamics/inverse_dynamics.hpp"
#include "math/logarithm.hpp"

namespace burnish {

/// Constants of one frame, as the kernels read them.
struct CompiledFrame {
  int body;                         ///< joint index, -1 for the world
  Mat3<double> R;                   ///< frame -> body
  Vec3<double> p;                   ///< origin in the body, m
  std::vector<MovingAxis> support;  ///< entries of v that move the body, ascending
};

CompiledFrame compile_frame(const Model& model, const Frame& frame);
/// By name; "world" is always known. Throws Error with the nearest known name.
CompiledFrame compile_frame(const Model& model, std::string_view name);

/// Filled by update_frame; a by update_frame_acceleration. World axes; motions about the world's
/// origin.
template <class S>
struct FrameState {
  Mat3<S> R;    ///< frame -> world
  Vec3<S> p;    ///< origin, m
  Motion<S> v;  ///< twist
  Motion<S> a;  ///< spatial acceleration, gravity not in it
};

template <class S>
void update_frame(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                  FrameState<S>& state);

/// The acceleration at the joint accelerations last given to accelerate().
template <class S>
void update_frame_acceleration(const Tree& tree, const CompiledFrame& frame,
                               const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                               FrameState<S>& state);

/// X m: a motion in world coordinates about the world's origin, in the chosen axes.
template <class S>
BURNISH_INLINE Motion<S> in_axes(FrameAxes axes, const FrameState<S>& state, const Motion<S>& m) {
  if (axes == FrameAxes::World) return m;
  const Motion<S> there = at_point(m, state.p);
  if (axes == FrameAxes::Centered) return there;
  return {transpose_times(state.R, there.linear), transpose_times(state.R, there.angular)};
}

/// The part of the frame's twist m that its origin and axes take part in: all of it for Local, the
/// translation with the frame's origin for Centered, none for World.
template <class S>
BURNISH_INLINE Motion<S> twist_of_axes(FrameAxes axes, const FrameState<S>& state,
                                       const Motion<S>& m) {
  if (axes == FrameAxes::World) return Motion<S>::zero();
  if (axes == FrameAxes::Local) return m;
  return {at_point(m, state.p).linear, Vec3<S>::zero()};
}

/// X v: m/s, rad/s.
template <class S>
Motion<S> frame_velocity(FrameAxes axes, const FrameState<S>& state);

/// d(X v)/dt: m/s^2, rad/s^2. Needs update_frame_acceleration.
template <class S>
Motion<S> frame_acceleration(FrameAxes axes, const FrameState<S>& state);

/// d(X v)/dv, 6 x nv: entry (r, k) goes to out[r * stride + k], for the entries k of the support.
/// It is d(acceleration)/da too.
template <class S>
void frame_jacobian(const CompiledFrame& frame, FrameAxes axes, const Kinematics<S>& kinematics,
                    const FrameState<S>& state, S* out, int stride);

/// How far a frame is from a target placement.
template <class S>
struct FrameError {
  Vec3<S> position;          ///< p - p_target, world axes, m
  Vec3<S> rotation;          ///< log(R_target^T R), rad
  Motion<S> placement;       ///< SE(3) logarithm of the frame in the target: m, rad
  LogCoefficients<S> terms;  ///< of the derivatives, at the angle of `rotation`
};

template <class S>
FrameError<S> frame_error(const FrameState<S>& state, const Mat3<S>& target_R,
                          const Vec3<S>& target_p);

}  // namespace burnish

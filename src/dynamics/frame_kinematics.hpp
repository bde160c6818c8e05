// Placement, velocity, acceleration and Jacobian of a frame that is fixed to a body.
//
// The six numbers of a velocity depend on the axes they are written in and on the point whose
// velocity is meant; a reference says both, whose tool is the frame and whose base is the world.
// With X its map (reference.hpp), the velocity is X v. The acceleration is everywhere the time
// derivative of those six numbers: with V the twist of the reference,
//   d(X v)/dt = X (a - V x v).
#pragma once

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/reference.hpp"
#include "math/logarithm.hpp"

namespace burnish {

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

/// X v: m/s, rad/s.
template <class S>
BURNISH_INLINE Motion<S> frame_velocity(const CompiledReference& reference,
                                        const ReferencePose<S>& at, const FrameState<S>& state) {
  return in_reference(reference, at, state.v);
}

/// d(X v)/dt: m/s^2, rad/s^2. Needs update_frame_acceleration.
template <class S>
Motion<S> frame_acceleration(const CompiledReference& reference, const ReferencePose<S>& at,
                             const Kinematics<S>& kinematics, const FrameState<S>& state);

/// d(X v)/dv, 6 x nv: entry (r, k) goes to out[r * stride + k], for the entries k of the frame's
/// support. It is d(acceleration)/da too.
template <class S>
void frame_jacobian(const CompiledFrame& frame, const CompiledReference& reference,
                    const ReferencePose<S>& at, const Kinematics<S>& kinematics, S* out,
                    int stride);

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

// Placement, velocity, acceleration and Jacobian of a frame that is fixed to a body.
//
// The six numbers of a velocity depend on the axes and the point for which they are stated. A
// reference defines both; its tool is the frame and its base is the world. With the map X of the
// reference (reference.hpp), the velocity is X v. The acceleration is always the time derivative of
// the six numbers. With the twist V of the reference, it is
//   d(X v)/dt = X (a - V x v).
#pragma once

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/reference.hpp"
#include "math/logarithm.hpp"

namespace burnish {

/// State of a frame, in world axes; motions are about the world's origin. update_frame fills all
/// members except `a`, which update_frame_acceleration fills.
template <class S>
struct FrameState {
  Mat3<S> R;    ///< Rotation from the frame to the world
  Vec3<S> p;    ///< Origin [m]
  Motion<S> v;  ///< Twist
  Motion<S> a;  ///< Spatial acceleration, without gravity
};

template <class S>
void update_frame(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                  FrameState<S>& state);

/// Computes the acceleration of the frame for the joint accelerations of the last accelerate().
template <class S>
void update_frame_acceleration(const Tree& tree, const CompiledFrame& frame,
                               const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                               FrameState<S>& state);

/// Returns X v: velocity of the frame in a reference [m/s, rad/s].
template <class S>
BURNISH_INLINE Motion<S> frame_velocity(const CompiledReference& reference,
                                        const ReferencePose<S>& at, const FrameState<S>& state) {
  return in_reference(reference, at, state.v);
}

/// Returns d(X v)/dt: acceleration of the frame in a reference [m/s^2, rad/s^2]. Call
/// update_frame_acceleration before.
template <class S>
Motion<S> frame_acceleration(const CompiledReference& reference, const ReferencePose<S>& at,
                             const Kinematics<S>& kinematics, const FrameState<S>& state);

/// Computes d(X v)/dv (6 x nv), which is also the derivative of the acceleration by joint
/// accelerations. Writes entry (r, k) to out[r * stride + k], only for entries k of v that move the
/// frame.
template <class S>
void frame_jacobian(const CompiledFrame& frame, const CompiledReference& reference,
                    const ReferencePose<S>& at, const Kinematics<S>& kinematics, S* out,
                    int stride);

/// Difference between a frame and a target placement.
template <class S>
struct FrameError {
  Vec3<S> position;          ///< p - p_target, in world axes [m]
  Vec3<S> rotation;          ///< log(R_target^T R) [rad]
  Motion<S> placement;       ///< SE(3) logarithm of the frame relative to the target [m, rad]
  LogCoefficients<S> terms;  ///< Coefficients for derivatives of the logarithms, at |rotation|
};

template <class S>
FrameError<S> frame_error(const FrameState<S>& state, const Mat3<S>& target_R,
                          const Vec3<S>& target_p);

}  // namespace burnish

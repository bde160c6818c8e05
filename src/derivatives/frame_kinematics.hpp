// Derivatives of a frame's placement, velocity and acceleration. Seen in world coordinates about
// the world's origin, with lambda the body that joint k hangs on (Singh, Russell, Wensing,
// "Efficient Analytical Derivatives of Rigid-Body Dynamics using Spatial Vector Algebra", 2022):
//   dv/dq_k = S_k x v + psi'_k,                 psi'_k  = v_lambda x S_k,
//   da/dq_k = S_k x a + psi'_k x v + psi''_k,   psi''_k = a_lambda x S_k + v_lambda x psi'_k,
//   da/dv_k = S_k x v + psi'_k + dS_k/dt.
// They are carried into the reference by d(X m)/dq_k = X (dm/dq_k - V_k x m):
// dynamics/reference.hpp.
//
// Matrices are row-major: entry (r, k) goes to out[r * stride + k], for the entries k that move the
// frame or the reference only; the others are zero and not written.
#pragma once

#include "dynamics/frame_kinematics.hpp"

namespace burnish {

/// A reference at a state, with the entries of v that move it.
template <class S>
struct FrameReference {
  const CompiledReference& compiled;
  ReferencePose<S> pose;
  ReferenceSupport support;
};

/// d(frame_velocity)/dq, 6 x nv; d/dv is frame_jacobian.
template <class S>
void frame_velocity_derivative(const CompiledFrame& frame, const FrameReference<S>& reference,
                               const Kinematics<S>& kinematics, const FrameState<S>& state, S* dq,
                               int stride);

/// d(frame_acceleration)/dq and /dv at constant joint accelerations, 6 x nv each; d/da is
/// frame_jacobian. Needs update_frame_acceleration.
template <class S>
void frame_acceleration_derivatives(const CompiledFrame& frame, const FrameReference<S>& reference,
                                    const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                    const FrameState<S>& state, S* dq, S* dv, int stride);

/// dp/dq of the frame's origin, world axes, 3 x nv.
template <class S>
void frame_position_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride);

/// The rotation of the frame, in its own axes, per unit of q: R^T dR/dq_k = [column k x], 3 x nv.
template <class S>
void frame_rotation_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride);

/// d(error.rotation)/dq, 3 x nv, the target held. Needs an angle below pi.
template <class S>
void frame_rotation_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                     const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                     int stride);

/// d(error.placement)/dq, 6 x nv, the target held. Needs an angle below pi.
template <class S>
void frame_placement_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                      const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                      int stride);

}  // namespace burnish

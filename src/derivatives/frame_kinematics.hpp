// Derivatives of a frame's placement, velocity and acceleration, in world axes about the world's
// origin. lambda is the parent body of joint k (Singh, Russell, Wensing, "Efficient Analytical
// Derivatives of Rigid-Body Dynamics using Spatial Vector Algebra", 2022):
//   dv/dq_k = S_k x v + psi'_k,                 psi'_k  = v_lambda x S_k,
//   da/dq_k = S_k x a + psi'_k x v + psi''_k,   psi''_k = a_lambda x S_k + v_lambda x psi'_k,
//   da/dv_k = S_k x v + psi'_k + dS_k/dt.
// X maps a motion m to a reference, which moves with the twist V_k per unit rate of entry k:
//   d(X m)/dq_k = X (dm/dq_k - V_k x m), see dynamics/reference.hpp.
//
// Matrices are row-major: entry (r, k) is out[r * stride + k]. The functions write only the entries
// k that move the frame or the reference; all other entries are zero.
#pragma once

#include "dynamics/columns.hpp"
#include "dynamics/frame_kinematics.hpp"

namespace burnish {

/// Reference at a state, and the entries of v that move it.
template <class S>
struct FrameReference {
  const CompiledReference& compiled;
  ReferencePose<S> pose;
  ReferenceSupport support;
};

/// Computes d(frame_velocity)/dq, 6 x nv. The derivative by v is frame_jacobian().
template <class S>
void frame_velocity_derivative(const CompiledFrame& frame, const FrameReference<S>& reference,
                               const Kinematics<S>& kinematics, const FrameState<S>& state, S* dq,
                               int stride);

/// Computes d(frame_acceleration)/dq and /dv at constant joint accelerations, 6 x nv each. The
/// derivative by a is frame_jacobian(). Requires update_frame_acceleration().
template <class S>
void frame_acceleration_derivatives(const CompiledFrame& frame, const FrameReference<S>& reference,
                                    const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                    const FrameState<S>& state, StateDerivatives<S> out);

/// Computes dp/dq (3 x nv) for the position p of the frame's origin in world axes.
template <class S>
void frame_position_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride);

/// Computes the rotation of the frame per unit of q, in the frame's axes, 3 x nv. R^T dR/dq_k is
/// the cross-product matrix of column k.
template <class S>
void frame_rotation_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride);

/// Computes d(error.rotation)/dq for a fixed target, 3 x nv. |error.rotation| must be below pi.
template <class S>
void frame_rotation_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                     const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                     int stride);

/// Computes d(error.placement)/dq for a fixed target, 6 x nv. |error.rotation| must be below pi.
template <class S>
void frame_placement_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                      const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                      int stride);

}  // namespace burnish

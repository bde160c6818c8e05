// Definitions of frame_kinematics.hpp, for any scalar.
#pragma once

#include "derivatives/frame_kinematics.hpp"
#include "dynamics/frame_kinematics.tpp"

namespace burnish {

template <class S>
void frame_velocity_derivative(const CompiledFrame& frame, const FrameReference<S>& reference,
                               const Kinematics<S>& kinematics, const FrameState<S>& state, S* dq,
                               int stride) {
  const ReferencePose<S>& at = reference.pose;
  for_each_entry(frame, reference.support, [&](int v, int k, const ReferenceAxes& by) {
    Motion<S> seen = -reference_twist(by, at, kinematics);
    if (k >= 0) seen += kinematics.axes[k].axis;
    Motion<S> rate = cross(seen, state.v);
    if (k >= 0) rate += kinematics.axes[k].parent_rate;
    store_column(in_reference(reference.compiled, at, rate), dq + v, stride);
  });
}

template <class S>
void frame_acceleration_derivatives(const CompiledFrame& frame, const FrameReference<S>& reference,
                                    const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                    const FrameState<S>& state, StateDerivatives<S> out) {
  if (frame.body < 0) return;
  // psi''_k is computed with a_lambda - g in place of a_lambda. The product of S_k and a must
  // therefore use a - g too. Then the terms g x S_k and S_k x g cancel.
  const Motion<S> a_minus_gravity = kinematics.bodies[frame.body].a_bias + id.a_joint[frame.body];
  const CompiledReference& compiled = reference.compiled;
  const ReferencePose<S>& at = reference.pose;
  const Motion<S> V = reference_twist(compiled, at, kinematics);
  const Motion<S> seen = state.a - cross(V, state.v);
  for_each_entry(frame, reference.support, [&](int v, int k, const ReferenceAxes& by) {
    const Motion<S> V_k = reference_twist(by, at, kinematics);
    const Motion<S> V_by_q = reference_twist_by_q(compiled, by, at, kinematics);
    Motion<S> by_q = -cross(V_by_q, state.v) - cross(V_k, seen);
    Motion<S> by_v = -cross(V_k, state.v);
    if (k >= 0) {
      const AxisState<S>& axis = kinematics.axes[k];
      const Motion<S> turned = cross(axis.axis, state.v);
      const Motion<S> a_by_q =
          cross(axis.axis, a_minus_gravity) + cross(axis.parent_rate, state.v) + id.axis_acc[k];
      by_q += a_by_q - cross(V, turned + axis.parent_rate);
      by_v += turned + axis.rate_sum - cross(V, axis.axis);
    }
    store_column(in_reference(compiled, at, by_q), out.dq + v, out.stride);
    store_column(in_reference(compiled, at, by_v), out.dv + v, out.stride);
  });
}

template <class S>
void frame_position_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride) {
  for (const MovingAxis& k : frame.support)
    store_column(at_point(kinematics.axes[k.axis].axis, state.p).linear, dq + k.v, stride);
}

template <class S>
void frame_rotation_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                               const FrameState<S>& state, S* dq, int stride) {
  for (const MovingAxis& k : frame.support)
    store_column(transpose_times(state.R, kinematics.axes[k.axis].axis.angular), dq + k.v, stride);
}

template <class S>
void frame_rotation_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                     const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                     int stride) {
  for (const MovingAxis& k : frame.support) {
    const Vec3<S> turning = transpose_times(state.R, kinematics.axes[k.axis].axis.angular);
    store_column(d_log_rotation(error.terms, error.rotation, turning), dq + k.v, stride);
  }
}

template <class S>
void frame_placement_error_derivative(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                                      const FrameState<S>& state, const FrameError<S>& error, S* dq,
                                      int stride) {
  for (const MovingAxis& k : frame.support) {
    const Motion<S> there = at_point(kinematics.axes[k.axis].axis, state.p);
    const Motion<S> twist{transpose_times(state.R, there.linear),
                          transpose_times(state.R, there.angular)};
    store_column(d_log_placement(error.terms, error.placement, twist), dq + k.v, stride);
  }
}

}  // namespace burnish

// Definitions of frame_kinematics.hpp, for any scalar.
#pragma once

#include "derivatives/frame_kinematics.hpp"
#include "dynamics/frame_kinematics.tpp"

namespace burnish {

template <class S>
void frame_velocity_derivative(const CompiledFrame& frame, FrameAxes axes,
                               const Kinematics<S>& kinematics, const FrameState<S>& state, S* dq,
                               int stride) {
  for (const MovingAxis& k : frame.support) {
    const AxisState<S>& axis = kinematics.axes[k.axis];
    const Motion<S> xi = twist_of_axes(axes, state, axis.axis);
    const Motion<S> rate = cross(axis.axis - xi, state.v) + axis.parent_rate;
    store_column(in_axes(axes, state, rate), dq + k.v, stride);
  }
}

template <class S>
void frame_acceleration_derivatives(const CompiledFrame& frame, FrameAxes axes,
                                    const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                    const FrameState<S>& state, S* dq, S* dv, int stride) {
  if (frame.body < 0) return;
  // psi''_k holds a_lambda - g, so S_k is crossed with a - g: the two g x S_k cancel.
  const Motion<S> a_minus_gravity = kinematics.bodies[frame.body].a_bias + id.a_joint[frame.body];
  const Motion<S> rho = twist_of_axes(axes, state, state.v);
  const Motion<S> seen = state.a - cross(rho, state.v);
  for (const MovingAxis& k : frame.support) {
    const AxisState<S>& axis = kinematics.axes[k.axis];
    const Motion<S> xi = twist_of_axes(axes, state, axis.axis);
    const Motion<S> turned = cross(axis.axis, state.v);
    const Motion<S> v_by_q = turned + axis.parent_rate;
    const Motion<S> a_by_q =
        cross(axis.axis, a_minus_gravity) + cross(axis.parent_rate, state.v) + id.axis_acc[k.axis];
    Motion<S> rho_by_q = twist_of_axes(axes, state, v_by_q);
    // The point that a centred reference follows moves with q itself.
    if (axes == FrameAxes::Centered) rho_by_q.linear += cross(state.v.angular, xi.linear);
    const Motion<S> by_q = a_by_q - cross(rho_by_q, state.v) - cross(rho, v_by_q) - cross(xi, seen);
    const Motion<S> by_v = turned + axis.rate_sum - cross(xi, state.v) - cross(rho, axis.axis);
    store_column(in_axes(axes, state, by_q), dq + k.v, stride);
    store_column(in_axes(axes, state, by_v), dv + k.v, stride);
  }
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
    const Motion<S> twist = in_axes(FrameAxes::Local, state, kinematics.axes[k.axis].axis);
    store_column(d_log_placement(error.terms, error.placement, twist), dq + k.v, stride);
  }
}

}  // namespace burnish

// Definitions of the templates in frame_kinematics.hpp.
#pragma once

#include "dynamics/columns.hpp"
#include "dynamics/frame_kinematics.hpp"

namespace burnish {
template <class S>
void update_frame(const CompiledFrame& frame, const Kinematics<S>& kinematics,
                  FrameState<S>& state) {
  state.R = lift<S>(frame.R);
  state.p = lift<S>(frame.p);
  state.v = Motion<S>::zero();
  state.a = Motion<S>::zero();
  if (frame.body < 0) return;
  const BodyState<S>& body = kinematics.bodies[frame.body];
  state.R = body.R * state.R;
  state.p = body.p + body.R * state.p;
  state.v = body.v;
}

template <class S>
void update_frame_acceleration(const Tree& tree, const CompiledFrame& frame,
                               const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                               FrameState<S>& state) {
  if (frame.body < 0) return;
  const Motion<S> gravity{lift<S>(tree.gravity), Vec3<S>::zero()};
  state.a = kinematics.bodies[frame.body].a_bias + gravity + id.a_joint[frame.body];
}

template <class S>
Motion<S> frame_acceleration(const CompiledReference& reference, const ReferencePose<S>& at,
                             const Kinematics<S>& kinematics, const FrameState<S>& state) {
  const Motion<S> V = reference_twist(reference, at, kinematics);
  return in_reference(reference, at, state.a - cross(V, state.v));
}

template <class S>
void frame_jacobian(const CompiledFrame& frame, const CompiledReference& reference,
                    const ReferencePose<S>& at, const Kinematics<S>& kinematics, S* out,
                    int stride) {
  for (const MovingAxis& k : frame.support)
    store_column(in_reference(reference, at, kinematics.axes[k.axis].axis), out + k.v, stride);
}

template <class S>
FrameError<S> frame_error(const FrameState<S>& state, const Mat3<S>& target_R,
                          const Vec3<S>& target_p) {
  FrameError<S> error;
  S angle;
  error.position = state.p - target_p;
  error.rotation = log_rotation(transpose_times(target_R, state.R), angle);
  error.terms = log_coefficients(angle);
  error.placement =
      log_placement(error.terms, error.rotation, transpose_times(target_R, error.position));
  return error;
}

}  // namespace burnish

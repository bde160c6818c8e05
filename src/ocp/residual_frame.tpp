// Residuals of a frame's placement and velocity. Columns are the entries of its support.
#pragma once

#include "derivatives/frame_kinematics.hpp"
#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {
namespace frame_detail {

template <class S>
Mat3<S> rotation_of(const S* target) {
  return {{target[0], target[1], target[2]},
          {target[3], target[4], target[5]},
          {target[6], target[7], target[8]}};
}

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

/// The columns of the support, of a matrix with nv columns, into one that has only those; `first`
/// is the place of the first one.
template <class S>
void keep_support(const S* full, int rows, int nv, const std::vector<MovingAxis>& support, S* J,
                  int columns, int first) {
  for (int i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < support.size(); ++k)
      J[i * columns + first + static_cast<int>(k)] = full[i * nv + support[k].v];
}

}  // namespace frame_detail

template <class S>
void FramePositionError::evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const {
  const FrameState<S>& state = scene.frames[frame];
  const Mat3<S> A = lift<S>(axes);
  const Vec3<S> p_target{target[0], target[1], target[2]};
  frame_detail::store(transpose_times(A, state.p - p_target), r);
  if (J == nullptr) return;
  const CompiledFrame& compiled = scene.compiled_frames[frame];
  const int nv = scene.layout->nv;
  const int columns = static_cast<int>(compiled.support.size());
  frame_position_derivative(compiled, scene.dynamics->kinematics(), state, scene.scratch, nv);
  for (int k = 0; k < columns; ++k) {
    const S* const dp = scene.scratch + compiled.support[k].v;
    const Vec3<S> turned = transpose_times(A, Vec3<S>{dp[0], dp[nv], dp[2 * nv]});
    J[k] = turned.x;
    J[columns + k] = turned.y;
    J[2 * columns + k] = turned.z;
  }
}

template <class S>
void FrameRotationError::evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const {
  const FrameState<S>& state = scene.frames[frame];
  const FrameError<S> error =
      frame_error(state, frame_detail::rotation_of(target), Vec3<S>::zero());
  frame_detail::store(error.rotation, r);
  if (J == nullptr) return;
  const CompiledFrame& compiled = scene.compiled_frames[frame];
  const int nv = scene.layout->nv;
  frame_rotation_error_derivative(compiled, scene.dynamics->kinematics(), state, error,
                                  scene.scratch, nv);
  frame_detail::keep_support(scene.scratch, 3, nv, compiled.support, J,
                             static_cast<int>(compiled.support.size()), 0);
}

template <class S>
void FramePlacementError::evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const {
  const FrameState<S>& state = scene.frames[frame];
  const FrameError<S> error = frame_error(state, frame_detail::rotation_of(target + 3),
                                          Vec3<S>{target[0], target[1], target[2]});
  frame_detail::store(error.placement, r);
  if (J == nullptr) return;
  const CompiledFrame& compiled = scene.compiled_frames[frame];
  const int nv = scene.layout->nv;
  frame_placement_error_derivative(compiled, scene.dynamics->kinematics(), state, error,
                                   scene.scratch, nv);
  frame_detail::keep_support(scene.scratch, 6, nv, compiled.support, J,
                             static_cast<int>(compiled.support.size()), 0);
}

template <class S>
void FrameVelocityError::evaluate(const Scene<S>& scene, const S* target, S* r, S* J) const {
  const FrameState<S>& state = scene.frames[frame];
  const Mat3<S> A = lift<S>(rotation);
  const Motion<S> v = frame_velocity(axes, state);
  frame_detail::store(Motion<S>{transpose_times(A, v.linear), transpose_times(A, v.angular)}, r);
  for (int i = 0; i < 6; ++i) r[i] -= target[i];
  if (J == nullptr) return;
  const CompiledFrame& compiled = scene.compiled_frames[frame];
  const Kinematics<S>& kinematics = scene.dynamics->kinematics();
  const int nv = scene.layout->nv;
  const int half = static_cast<int>(compiled.support.size());
  const int columns = 2 * half;
  frame_velocity_derivative(compiled, axes, kinematics, state, scene.scratch, nv);
  frame_detail::keep_support(scene.scratch, 6, nv, compiled.support, J, columns, 0);
  frame_jacobian(compiled, axes, kinematics, state, scene.scratch, nv);
  frame_detail::keep_support(scene.scratch, 6, nv, compiled.support, J, columns, half);
  if (!turned) return;
  for (int part = 0; part < 6; part += 3)
    for (int c = 0; c < columns; ++c) {
      S* const entry = J + part * columns + c;
      const Vec3<S> column{entry[0], entry[columns], entry[2 * columns]};
      const Vec3<S> rotated = transpose_times(A, column);
      entry[0] = rotated.x;
      entry[columns] = rotated.y;
      entry[2 * columns] = rotated.z;
    }
}

}  // namespace burnish::ocp

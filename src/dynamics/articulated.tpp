// Definitions of the templates in articulated.hpp.
#pragma once

#include <algorithm>

#include "base/to_size.hpp"
#include "dynamics/articulated.hpp"
#include "math/reciprocal_root.hpp"

namespace burnish {
namespace articulated_detail {

// Number of columns in a block. The vector registers of the target can hold the forces (or motions)
// of a block, with six registers per column, together with one axis and its force.
#if defined(__AVX512F__) || defined(__aarch64__)
inline constexpr int block = 4;
#else
inline constexpr int block = 2;
#endif

}  // namespace articulated_detail

/// Magnitude of the terms that axis k of body `i` contributes to the diagonal of M when computed
/// about the world's origin.
template <class S>
BURNISH_INLINE S added_about_origin(const Kinematics<S>& kinematics, const MassMatrix<S>& m, int i,
                                    int k) {
  const Inertia<S>& composite = m.composite[i];
  const Vec3<S>& linear = kinematics.axes[k].axis.linear;
  const S trace = composite.second.xx + composite.second.yy + composite.second.zz;
  return trace + dot(linear, linear) * composite.mass;
}

/// Minimum pivot of entry k of v, which moves body `i`. A smaller pivot can be a rounding error.
/// The minimum is 1e-13 of the diagonal entry, plus ten rounding errors of the terms about the
/// world's origin.
template <class S>
BURNISH_INLINE S least_mass_pivot(const Tree& tree, const Kinematics<S>& kinematics,
                                  const MassMatrix<S>& m, int i, int k) {
  const S added = tree.shares_entries() ? S(m.added[k]) : added_about_origin(kinematics, m, i, k);
  return m.mass[k * tree.nv + k] * S(1e-13) + added * S(2e-15);
}

template <class S>
auto factorize_articulated(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m) {
  using namespace articulated_detail;
  const int n = tree.nv;
  auto bad = less(S(0.0), S(0.0));
  for (int i = 0; i < tree.bodies(); ++i)
    m.articulated[i] = ArticulatedInertia<S>::of(kinematics.bodies[i].inertia);
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const TreeJoint& joint = tree.joints[i];
    ArticulatedInertia<S> inertia = m.articulated[i];
    for (int k = joint.axis + joint.nv - 1; k >= joint.axis; --k) {
      const Motion<S>& axis = kinematics.axes[k].axis;
      const Force<S> force = inertia * axis;
      const S pivot = dot(axis, force) + S(tree.armature[k]);
      const auto weak = mask_not(less(least_mass_pivot(tree, kinematics, m, i, k), pivot));
      bad = mask_or(bad, weak);
      const S reciprocal = reciprocal_root(pivot, weak);
      const Force<S> row = force * reciprocal;
      m.inverse_diagonal[k] = reciprocal;
      m.row_force[k] = row;
      for (int j = tree.parent_of_v[k]; j >= 0; j = tree.parent_of_v[j])
        m.factor[k * n + j] = dot(kinematics.axes[j].axis, row);
      inertia.release(row);
    }
    if (joint.parent < 0) continue;
    m.articulated[joint.parent] += inertia;
  }
  return bad;
}

template <class S>
ArticulatedSolver<S>::ArticulatedSolver(const Tree& tree) : n_(tree.nv) {
  std::vector<int> segment_of_v(to_size(tree.nv));
  for (const auto& [first, end] : tree.chains()) {
    const int above = tree.parent_of_v[first];
    for (int k = first; k < end; ++k) segment_of_v[k] = static_cast<int>(segments_.size());
    segments_.push_back({first, end, above < 0 ? -1 : segment_of_v[above]});
  }
  pulled_.resize(segments_.size() * articulated_detail::block);
  pushed_.resize(segments_.size() * articulated_detail::block);
}

/// Solves L^T x = right-hand side for the entries of v in the segment, up to entry `end` - 1.
template <class S>
template <int C>
void ArticulatedSolver<S>::pull(const Segment& segment, int end, const Kinematics<S>& kinematics,
                                const MassMatrix<S>& m, const auto& right_side, S* x) {
  const auto at = to_size(&segment - segments_.data());
  Force<S> force[C];
  for (int c = 0; c < C; ++c) force[c] = pulled_[at * C + c];
  for (int k = end - 1; k >= segment.first; --k) {
    const Motion<S>& axis = kinematics.axes[k].axis;
    const Force<S>& row = m.row_force[k];
    const S reciprocal = m.inverse_diagonal[k];
    for (int c = 0; c < C; ++c) {
      const S t = (right_side(k, c) - dot(axis, force[c])) * reciprocal;
      x[k * stride_ + c] = t;
      force[c] += row * t;
    }
  }
  if (segment.parent < 0) return;
  for (int c = 0; c < C; ++c) pulled_[segment.parent * C + c] += force[c];
}

/// Replaces x by L^-1 x for the entries of v in the segment.
template <class S>
template <int C>
void ArticulatedSolver<S>::push(const Segment& segment, const Kinematics<S>& kinematics,
                                const MassMatrix<S>& m, S* x) {
  const auto at = to_size(&segment - segments_.data());
  Motion<S> motion[C];
  for (int c = 0; c < C; ++c)
    motion[c] = segment.parent < 0 ? Motion<S>::zero() : pushed_[segment.parent * C + c];
  for (int k = segment.first; k < segment.end; ++k) {
    const Motion<S>& axis = kinematics.axes[k].axis;
    const Force<S>& row = m.row_force[k];
    const S reciprocal = m.inverse_diagonal[k];
    for (int c = 0; c < C; ++c) {
      const S result = (x[k * stride_ + c] - dot(motion[c], row)) * reciprocal;
      x[k * stride_ + c] = result;
      motion[c] += axis * result;
    }
  }
  for (int c = 0; c < C; ++c) pushed_[at * C + c] = motion[c];
}

template <class S>
template <int C>
void ArticulatedSolver<S>::solve_block(const Kinematics<S>& kinematics, const MassMatrix<S>& m,
                                       const S* rhs, S* x, int stride) {
  stride_ = stride;
  std::fill(pulled_.begin(), pulled_.end(), Force<S>::zero());
  for (std::size_t s = segments_.size(); s-- > 0;)
    pull<C>(
        segments_[s], segments_[s].end, kinematics, m,
        [&](int k, int c) { return -rhs[k * stride + c]; }, x);
  for (const Segment& segment : segments_) push<C>(segment, kinematics, m, x);
}

template <class S>
void ArticulatedSolver<S>::solve_negative(const Kinematics<S>& kinematics, const MassMatrix<S>& m,
                                          const S* rhs, S* x, int columns, int stride) {
  constexpr int block = articulated_detail::block;
  int j = 0;
  for (; j + block <= columns; j += block)
    solve_block<block>(kinematics, m, rhs + j, x + j, stride);
  for (; j < columns; ++j) solve_block<1>(kinematics, m, rhs + j, x + j, stride);
}

/// Computes columns `column` up to `column + C` of M^-1, all in one segment. The right-hand sides
/// are unit vectors, so L^-T times them is nonzero only on the path from the segment to the root.
template <class S>
template <int C>
void ArticulatedSolver<S>::invert_block(const Kinematics<S>& kinematics, const MassMatrix<S>& m,
                                        int segment, int column, S* x) {
  stride_ = n_;
  std::fill(pulled_.begin(), pulled_.end(), Force<S>::zero());
  S* const block = x + column;
  for (int k = 0; k < n_; ++k)
    for (int c = 0; c < C; ++c) block[k * n_ + c] = S(0.0);
  const auto unit = [&](int k, int c) { return S(k == column + c ? 1.0 : 0.0); };
  int end = column + C;
  for (int s = segment; s >= 0; s = segments_[s].parent) {
    pull<C>(segments_[s], end, kinematics, m, unit, block);
    if (segments_[s].parent >= 0) end = segments_[segments_[s].parent].end;
  }
  for (const Segment& each : segments_) push<C>(each, kinematics, m, block);
}

template <class S>
void ArticulatedSolver<S>::invert(const Kinematics<S>& kinematics, const MassMatrix<S>& m, S* x) {
  constexpr int block = articulated_detail::block;
  for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
    int j = segments_[s].first;
    for (; j + block <= segments_[s].end; j += block) invert_block<block>(kinematics, m, s, j, x);
    for (; j < segments_[s].end; ++j) invert_block<1>(kinematics, m, s, j, x);
  }
}

}  // namespace burnish

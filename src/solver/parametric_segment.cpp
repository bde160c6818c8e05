#include "solver/parametric_segment.hpp"

#include <algorithm>
#include <cmath>

#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

using dense::Update;

namespace {

/// Computes X = A^-1 B from the n rows of [A | B], by Gaussian elimination with partial pivoting. X
/// replaces B. Returns false if a pivot is zero or not finite.
bool solve_rows(double* a, int stride, int n, int columns) {
  for (int c = 0; c < n; ++c) {
    int best = c;
    for (int i = c + 1; i < n; ++i)
      if (std::abs(a[i * stride + c]) > std::abs(a[best * stride + c])) best = i;
    double* pivot = a + c * stride;
    if (best != c) std::swap_ranges(pivot, pivot + columns, a + best * stride);
    if (!(std::abs(pivot[c]) > 0.0) || !std::isfinite(pivot[c])) return false;
    const int first = dense::round_down(c);
    for (int i = c + 1; i < n; ++i) {
      double* row = a + i * stride;
      dense::add_scaled(-row[c] / pivot[c], pivot + first, columns - first, row + first);
    }
  }
  const int beside = dense::round_down(n);
  for (int c = n - 1; c >= 0; --c) {
    double* row = a + c * stride;
    // Starts at the last row. Each addition also overwrites entries of A right of the diagonal,
    // which are then no longer needed.
    for (int k = n - 1; k > c; --k)
      dense::add_scaled(-row[k], a + k * stride + beside, columns - beside, row + beside);
    const double inverse = 1.0 / row[c];
    for (int j = n; j < columns; ++j) row[j] *= inverse;
  }
  return true;
}

}  // namespace

ParametricSegment::ParametricSegment(const StateShape& state, int max_controls)
    : state_(state),
      layout_(state, max_controls),
      recursion_(state, max_controls),
      system_stride_(dense::round_up(2 * dense::round_up(state.ndx) + 1)) {
  const int ndx = state.ndx;
  const int vs = layout_.value_stride;
  for (Value* v : {&nothing_, &joined_}) v->memory = Buffer(dense::block_size(vs + 1, vs));
  for (Buffer& b : fx_)
    b = Buffer(dense::block_size(dense::round_up(max_controls + ndx) + dense::lanes, vs));
  projected_ = Buffer(dense::block_size(state.nv, vs));
  d_ = Buffer(dense::block_size(vs, vs));
  r_ = Buffer(dense::block_size(1, vs));
  transposed_ = Buffer(dense::block_size(vs, vs));
  system_ = Buffer(dense::block_size(ndx, system_stride_));
}

void ParametricSegment::start() {
  const int vs = layout_.value_stride;
  now_ = controls_ = 0;
  double* x = fx_[now_].data();
  std::fill_n(x, state_.ndx * vs, 0.0);
  for (int i = 0; i < state_.ndx; ++i) x[i * vs + i] = 1.0;
  std::fill_n(d_.data(), vs * vs, 0.0);
  std::fill_n(r_.data(), vs, 0.0);
}

void ParametricSegment::extend(const KnotExpansion& e, int controls, const double* gap,
                               const PolicyStorage& policy) {
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  const double* x = fx_[now_].data() + controls_ * vs;
  now_ = 1 - now_;
  controls_ = controls;
  double* z = fx_[now_].data();
  multiply_transposed(e, controls, x, z);
  dense::add_row_times(gap, {x, vs}, ndx, ndx, r_.data());
  dense::add_row_times(policy.feedforward, {z, vs}, controls, ndx, r_.data());
  dense::product<Update::Add>({policy.gain, layout_.gain_stride, 1}, {z, vs}, controls, ndx, ndx,
                              {z + controls * vs, vs});
  dense::solve_transposed(recursion_.factor(), controls, ndx, {z, vs});
  dense::lower_product<Update::Add>({z, vs, 1}, {z, vs}, controls, ndx, {d_.data(), vs});
}

void ParametricSegment::multiply_transposed(const KnotExpansion& e, int controls, const double* x,
                                            double* out) {
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  const dense::Left f{e.dynamics, e.stride, 1};
  if (e.form == DynamicsForm::Dense) {
    dense::product<Update::Set>(f, {x, vs}, ndx, controls + ndx, ndx, {out, vs});
    return;
  }
  const int nv = state_.nv;
  double* t = projected_.data();
  project_rows(state_, e, x, vs, t);
  dense::product<Update::Set>(f, {t, vs}, nv, controls + ndx, ndx, {out, vs});
  add_passed(e, controls, x, out);
}

/// Adds E^T X to `out`.
void ParametricSegment::add_passed(const KnotExpansion& e, int controls, const double* x,
                                   double* out) const {
  const int ndx = state_.ndx;
  const int nv = state_.nv;
  const int vs = layout_.value_stride;
  double* states = out + controls * vs;
  int done = 0;
  const auto add_rows = [&](int end) {
    for (; done < end; ++done) dense::add_scaled(1.0, x + done * vs, ndx, states + done * vs);
  };
  const double* tangent_blocks = e.tangent_blocks;
  for (const NonEuclideanBlock& b : state_.blocks) {
    add_rows(b.first);
    for (int i = 0; i < b.size; ++i)
      for (int k = 0; k < b.size; ++k)
        dense::add_scaled(tangent_blocks[k * b.size + i], x + (b.first + k) * vs, ndx,
                          states + (b.first + i) * vs);
    done = b.first + b.size;
    tangent_blocks += 2 * b.size * b.size;
  }
  add_rows(nv);
  const int through = std::min(controls, state_.filtered);
  for (int c = 0; c < state_.filtered; ++c) {
    const double* row = x + (2 * nv + c) * vs;
    dense::add_scaled(e.decay[c], row, ndx, states + (2 * nv + c) * vs);
    if (c < through) dense::add_scaled(1.0 - e.decay[c], row, ndx, out + c * vs);
  }
}

bool ParametricSegment::join(const ValueStorage& segment, const ValueStorage& following) {
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  const int ss = system_stride_;
  const double* x = fx_[now_].data() + controls_ * vs;
  double* s = system_.data();
  double* xt = transposed_.data();
  const dense::Left p{following.hessian, vs, 1};
  dense::transpose_copy({x, vs}, ndx, ndx, {xt, vs});
  dense::mirror_lower({d_.data(), vs}, {0, ndx}, {d_.data(), vs});
  dense::product<Update::Set>(p, {d_.data(), vs}, ndx, ndx, ndx, {s, ss});
  dense::product<Update::Set>(p, {xt, vs}, ndx, ndx, ndx, {s + vs, ss});
  for (int i = 0; i < ndx; ++i) {
    double* row = s + i * ss;
    // Clears the padding between the columns of 1 + P D and the columns of P X^T.
    std::fill_n(row + ndx, vs - ndx, 0.0);
    row[i] += 1.0;
    row[2 * vs] = dense::dot(following.hessian + i * vs, r_.data(), ndx) + following.gradient[i];
  }
  if (!solve_rows(s, ss, ndx, 2 * vs + 1)) return false;
  const ValueStorage out = joined();
  dense::copy(segment.gradient, ndx, out.gradient);
  for (int i = 0; i < ndx; ++i) {
    dense::copy(segment.hessian + i * vs, ndx, out.hessian + i * vs);
    dense::add_scaled(s[i * ss + 2 * vs], xt + i * vs, ndx, out.gradient);
  }
  dense::lower_product<Update::Add>({xt, vs, 1}, {s + vs, ss}, ndx, ndx, {out.hessian, vs});
  dense::mirror_lower({out.hessian, vs}, {0, ndx}, {out.hessian, vs});
  double sum = 0.0;
  for (int i = 0; i < ndx; ++i) sum += std::abs(out.gradient[i]) + std::abs(out.hessian[i * vs]);
  return std::isfinite(sum);
}

}  // namespace burnish

#include "solver/linear_dynamics.hpp"

#include <algorithm>

#include "solver/dense.hpp"

namespace burnish {

void transform_tangent(const StateShape& state, const double* tangent_blocks, bool of_velocity,
                       double* row) {
  for (const NonEuclideanBlock& b : state.blocks) {
    const int n = b.size;
    const double* factor = tangent_blocks + (of_velocity ? n * n : 0);
    double* block = row + b.first;
    double product[max_tangent_size];
    for (int j = 0; j < n; ++j) {
      double sum = 0.0;
      for (int i = 0; i < n; ++i) sum += block[i] * factor[i * n + j];
      product[j] = sum;
    }
    std::copy_n(product, n, block);
    tangent_blocks += 2 * n * n;
  }
}

void project_rows(const StateShape& state, const KnotExpansion& e, const double* x, int stride,
                  double* out) {
  const int nv = state.nv;
  const int ndx = state.ndx;
  for (int i = 0; i < nv; ++i)
    dense::sum_scaled(x + (nv + i) * stride, e.step, x + i * stride, ndx, out + i * stride);
  const double* tangent_blocks = e.tangent_blocks;
  for (const NonEuclideanBlock& b : state.blocks) {
    const double* factor = tangent_blocks + b.size * b.size;
    for (int i = 0; i < b.size; ++i) {
      double* row = out + (b.first + i) * stride;
      dense::copy(x + (nv + b.first + i) * stride, ndx, row);
      for (int k = 0; k < b.size; ++k)
        dense::add_scaled(e.step * factor[k * b.size + i], x + (b.first + k) * stride, ndx, row);
    }
    tangent_blocks += 2 * b.size * b.size;
  }
}

void multiply(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
              double* scratch, double* next) {
  const int nz = controls + state.ndx;
  if (e.form == DynamicsForm::Dense) {
    for (int i = 0; i < state.ndx; ++i) next[i] = dense::dot(e.dynamics + i * e.stride, z, nz);
    return;
  }
  double* dv = next + state.nv;
  for (int i = 0; i < state.nv; ++i) dv[i] = dense::dot(e.dynamics + i * e.stride, z, nz);
  complete_next(state, e, controls, z, scratch, next);
}

void complete_next(const StateShape& state, const KnotExpansion& e, int controls, const double* z,
                   double* scratch, double* next) {
  const int nv = state.nv;
  const double* dx = z + controls;
  const double* dv = next + nv;
  for (int i = 0; i < nv; ++i) next[i] = dx[i] + e.step * dv[i];
  const double* tangent_blocks = e.tangent_blocks;
  for (const NonEuclideanBlock& b : state.blocks) {
    const int n = b.size;
    for (int i = 0; i < n; ++i) {
      double sum = 0.0;
      double moved = 0.0;
      for (int j = 0; j < n; ++j) {
        sum += tangent_blocks[i * n + j] * dx[b.first + j];
        moved += tangent_blocks[n * n + i * n + j] * dv[b.first + j];
      }
      scratch[i] = sum + e.step * moved;
    }
    std::copy_n(scratch, n, next + b.first);
    tangent_blocks += 2 * n * n;
  }
  const int through = std::min(controls, state.filtered);
  for (int c = 0; c < state.filtered; ++c) {
    next[2 * nv + c] = e.decay[c] * dx[2 * nv + c];
    if (c < through) next[2 * nv + c] += (1.0 - e.decay[c]) * z[c];
  }
}

void add_transposed(const StateShape& state, const KnotExpansion& e, int controls, double* w,
                    double* scratch, double* out) {
  const int nz = controls + state.ndx;
  if (e.form == DynamicsForm::Dense) {
    dense::add_row_times(w, {e.dynamics, e.stride}, state.ndx, nz, out);
    return;
  }
  const int nv = state.nv;
  std::copy_n(w, nv, scratch);
  transform_tangent(state, e.tangent_blocks, true, scratch);
  for (int i = 0; i < nv; ++i) scratch[i] = e.step * scratch[i] + w[nv + i];
  dense::add_row_times(scratch, {e.dynamics, e.stride}, nv, nz, out);
  transform_tangent(state, e.tangent_blocks, false, w);
  const int through = std::min(controls, state.filtered);
  for (int i = 0; i < nv; ++i) out[controls + i] += w[i];
  for (int c = 0; c < state.filtered; ++c) out[controls + 2 * nv + c] += e.decay[c] * w[2 * nv + c];
  for (int c = 0; c < through; ++c) out[c] += (1.0 - e.decay[c]) * w[2 * nv + c];
}

}  // namespace burnish

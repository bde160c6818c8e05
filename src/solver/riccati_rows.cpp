// The recursion's end where it has rows, and a step again for other multipliers.
#include <algorithm>

#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"
#include "solver/riccati.hpp"

namespace burnish {

using dense::Update;

void RiccatiRecursion::terminal(const KnotExpansion& e, const WeightedRows& rows,
                                ValueStorage value) {
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  std::copy_n(rows.gradient, ndx, value.gradient);
  for (int i = 0; i < ndx; ++i) dense::copy(e.hessian + i * e.stride, i + 1, qxx_.data() + i * vs);
  if (rows.count > 0)
    dense::lower_product<Update::Add>({rows.weighted, rows.stride, 1}, {rows.rows, rows.stride},
                                      rows.count, ndx, qxx_.data(), vs);
  if (rows.diagonal != nullptr)
    for (int i = 0; i < ndx; ++i) qxx_.data()[i * vs + i] += rows.diagonal[i];
  dense::mirror_lower({qxx_.data(), vs}, {0, ndx}, value.hessian, vs);
}

void RiccatiRecursion::resolve(const KnotExpansion& expansion, int controls,
                               const RiccatiFactor& factor, const double* next_gradient,
                               const double* hessian_gap, double* gradient, PolicyStorage policy,
                               double* value_gradient) {
  const int ndx = state_.ndx;
  dense::sum_scaled(next_gradient, 1.0, hessian_gap, ndx, w_next_.data());
  add_transposed(state_, expansion, controls, w_next_.data(), own_[0].passed.data(), gradient);
  double* k = policy.feedforward;
  for (int i = 0; i < controls; ++i) {  // R^T l = qu
    double sum = gradient[i];
    for (int j = 0; j < i; ++j) sum -= factor.r[j * factor.stride + i] * k[j];
    k[i] = sum * factor.inverse_diagonal[i];
  }
  for (int i = controls; i-- > 0;) {  // R k = -l
    double sum = -k[i];
    for (int j = i + 1; j < controls; ++j) sum -= factor.r[i * factor.stride + j] * k[j];
    k[i] = sum * factor.inverse_diagonal[i];
  }
  // vx = qx + K^T qu
  std::copy_n(gradient + controls, ndx, value_gradient);
  dense::product<Update::Add>({gradient, 1, 1}, {policy.gain, layout_.gain_stride}, controls, 1,
                              ndx, value_gradient, 0);
}

}  // namespace burnish

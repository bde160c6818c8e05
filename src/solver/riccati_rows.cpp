// Terminal step with constraint rows, and a repeated step for other multipliers.
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
                                      rows.count, ndx, {qxx_.data(), vs});
  if (rows.diagonal != nullptr)
    for (int i = 0; i < ndx; ++i) qxx_.data()[i * vs + i] += rows.diagonal[i];
  dense::mirror_lower({qxx_.data(), vs}, {0, ndx}, {value.hessian, vs});
}

void RiccatiRecursion::resolve(const RiccatiKnot& at, const dense::Factor& factor,
                               double* gradient) {
  const int ndx = state_.ndx, controls = at.controls;
  dense::sum_scaled(at.next.gradient, 1.0, at.hessian_gap, ndx, w_next_.data());
  add_transposed(state_, at.expansion, controls, w_next_.data(), own_[0].passed.data(), gradient);
  // Solves R^T R k = -qu. Each entry fills a whole SIMD vector, because scalar stores followed by
  // vector loads would stall.
  double* column = column_.data();
  for (int i = 0; i < controls; ++i)
    dense::store(column + i * dense::lanes, dense::Lane(-gradient[i]));
  dense::solve_transposed(factor, controls, 1, {column, dense::lanes});
  dense::solve_upper(factor, controls, 1, {column, dense::lanes});
  for (int i = 0; i < controls; ++i) at.policy.feedforward[i] = column[i * dense::lanes];
  // vx = qx + K^T qu
  std::copy_n(gradient + controls, ndx, at.value.gradient);
  dense::add_row_times(gradient, {at.policy.gain, layout_.gain_stride}, controls, ndx,
                       at.value.gradient);
}

}  // namespace burnish

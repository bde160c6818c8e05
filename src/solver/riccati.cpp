#include "burnish/solver/riccati.hpp"

#include <algorithm>

#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

using dense::Rows;
using dense::Update;

namespace {

std::size_t block(int rows, int stride) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride) + dense::spare;
}

}  // namespace

RiccatiLayout::RiccatiLayout(const StateShape& state, int max_controls)
    : expansion_stride(dense::round_up(state.ndx + max_controls)),
      expansion_rows(expansion_stride),
      value_stride(dense::round_up(state.ndx)),
      gain_stride(dense::round_up(state.ndx + 1)),
      spare(dense::spare) {}

RiccatiRecursion::RiccatiRecursion(const StateShape& state, int max_controls)
    : state_(state),
      layout_(state, max_controls),
      y_stride_(dense::round_up(max_controls + state.ndx + 1)),
      box_qp_(max_controls) {
  const int inner = state.nv;
  const int rows = std::max(1, dense::round_up(max_controls));
  y_ = Buffer(block(rows, y_stride_));
  qxx_ = Buffer(block(layout_.value_stride, layout_.value_stride));
  gradient_ = Buffer(block(2, y_stride_));
  u_ = Buffer(block(inner, layout_.value_stride));
  w_ = Buffer(block(inner, dense::round_up(inner)));
  m_ = Buffer(block(inner, y_stride_));
  g_ = Buffer(block(state.ndx, y_stride_));
  passed_ = Buffer(block(state.nv + state.filtered, layout_.value_stride));
  w_next_ = Buffer(block(2, layout_.value_stride));
  inverse_diagonal_ = Buffer(block(1, rows));
  solution_ = Buffer(block(1, rows));
  box_lower_ = Buffer(block(1, rows));
  box_upper_ = Buffer(block(1, rows));
}

void RiccatiRecursion::terminal(const KnotExpansion& e, ValueStorage value) const {
  std::copy_n(e.gradient, state_.ndx, value.gradient);
  dense::mirror_lower({e.hessian, e.stride}, state_.ndx, value.hessian, layout_.value_stride);
}

/// Y <- [Huu | Hux], Qxx <- Hxx, q <- h.
void RiccatiRecursion::load_cost(const KnotExpansion& e) {
  dense::transpose_copy({e.hessian, e.stride}, nz_, nu_, y_.data(), y_stride_);
  for (int i = 0; i < state_.ndx; ++i)
    dense::copy(e.hessian + (nu_ + i) * e.stride + nu_, i + 1,
                qxx_.data() + i * layout_.value_stride);
  std::copy_n(e.gradient, nz_, gradient_.data());
}

void RiccatiRecursion::add_dense(const KnotExpansion& e, const ValueStorage& next) {
  const int ndx = state_.ndx;
  const Rows f{e.dynamics, e.stride};
  const Rows g{g_.data(), y_stride_};
  dense::product<Update::Set>({next.hessian, layout_.value_stride, 1}, f, ndx, ndx, nz_, g_.data(),
                              y_stride_);
  dense::product<Update::Add>({e.dynamics, e.stride, 1}, g, ndx, nu_, nz_, y_.data(), y_stride_);
  dense::lower_product<Update::Add>({e.dynamics + nu_, e.stride, 1}, {g_.data() + nu_, y_stride_},
                                    ndx, ndx, qxx_.data(), layout_.value_stride);
}

/// U^T = step B^T Vq + Vv, W = U^T T, M = U^T E.
void RiccatiRecursion::project_value(const KnotExpansion& e, const ValueStorage& next) {
  const int nv = state_.nv;
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  const int ws = dense::round_up(nv);
  for (int i = 0; i < nv; ++i)
    dense::sum_scaled(next.hessian + (nv + i) * vs, e.step, next.hessian + i * vs, ndx,
                      u_.data() + i * vs);
  const double* lead = e.lead;
  for (const LeadBlock& b : state_.blocks) {
    const double* factor = lead + b.size * b.size;
    for (int i = 0; i < b.size; ++i) {
      double* row = u_.data() + (b.first + i) * vs;
      dense::copy(next.hessian + (nv + b.first + i) * vs, ndx, row);
      for (int k = 0; k < b.size; ++k)
        dense::add_scaled(e.step * factor[k * b.size + i], next.hessian + (b.first + k) * vs, ndx,
                          row);
    }
    lead += 2 * b.size * b.size;
  }
  for (int i = 0; i < nv; ++i) {
    const double* u = u_.data() + i * vs;
    double* w = w_.data() + i * ws;
    double* m = m_.data() + i * y_stride_;
    std::fill_n(m, nz_, 0.0);
    for (int c = 0; c < filtered_controls_; ++c) m[c] = u[2 * nv + c] * (1.0 - e.decay[c]);
    std::copy_n(u, nv, m + nu_);
    for (int c = 0; c < state_.filtered; ++c) m[nu_ + 2 * nv + c] = u[2 * nv + c] * e.decay[c];
    if (state_.blocks.empty()) {
      dense::sum_scaled(u + nv, e.step, u, nv, w);
      continue;
    }
    double* moved = passed_.data();
    std::copy_n(u, nv, moved);
    transform_lead(state_, e.lead, true, moved);
    dense::sum_scaled(u + nv, e.step, moved, nv, w);
    transform_lead(state_, e.lead, false, m + nu_);
  }
}

/// Y and Qxx += P^T (W P + M) + M^T P.
void RiccatiRecursion::add_products(const KnotExpansion& e) {
  const int nv = state_.nv;
  const int qs = layout_.value_stride;
  const Rows p{e.dynamics, e.stride};
  for (int i = 0; i < nv; ++i)
    dense::copy(m_.data() + i * y_stride_, nz_, g_.data() + i * y_stride_);
  dense::product<Update::Add>({w_.data(), dense::round_up(nv), 1}, p, nv, nv, nz_, g_.data(),
                              y_stride_);
  dense::product<Update::Add>({e.dynamics, e.stride, 1}, {g_.data(), y_stride_}, nv, nu_, nz_,
                              y_.data(), y_stride_);
  dense::lower_product<Update::Add>({e.dynamics + nu_, e.stride, 1}, {g_.data() + nu_, y_stride_},
                                    nv, state_.ndx, qxx_.data(), qs);
  // M^T P has the rows of what passes through: filtered controls, dq, dtau.
  const Rows px{e.dynamics + nu_, e.stride};
  if (filtered_controls_ > 0)
    dense::product<Update::Add>({m_.data(), y_stride_, 1}, p, nv, filtered_controls_, nz_,
                                y_.data(), y_stride_);
  dense::lower_product<Update::Add>({m_.data() + nu_, y_stride_, 1}, px, nv, nv, qxx_.data(), qs);
  if (state_.filtered > 0)
    dense::product<Update::Add>({m_.data() + nu_ + 2 * nv, y_stride_, 1}, px, nv, state_.filtered,
                                state_.ndx, qxx_.data() + 2 * nv * qs, qs);
}

/// Y and Qxx += E^T V E.
void RiccatiRecursion::add_passed(const KnotExpansion& e, const ValueStorage& next) {
  const int nv = state_.nv;
  const int nf = state_.filtered;
  const int qs = layout_.value_stride;
  if (state_.blocks.empty()) {
    for (int i = 0; i < nv; ++i)
      dense::add_scaled(1.0, next.hessian + i * qs, i + 1, qxx_.data() + i * qs);
  } else {
    for (int i = 0; i < nv; ++i) {
      std::copy_n(next.hessian + i * qs, nv, passed_.data() + i * qs);
      transform_lead(state_, e.lead, false, passed_.data() + i * qs);
    }
    const double* lead = e.lead;
    int done = 0;
    const auto add_rows = [&](int end) {
      for (; done < end; ++done)
        dense::add_scaled(1.0, passed_.data() + done * qs, done + 1, qxx_.data() + done * qs);
    };
    for (const LeadBlock& b : state_.blocks) {
      add_rows(b.first);
      for (int i = 0; i < b.size; ++i)
        for (int k = 0; k < b.size; ++k)
          dense::add_scaled(lead[k * b.size + i], passed_.data() + (b.first + k) * qs,
                            b.first + i + 1, qxx_.data() + (b.first + i) * qs);
      done = b.first + b.size;
      lead += 2 * b.size * b.size;
    }
    add_rows(nv);
  }
  for (int c = 0; c < nf; ++c) {
    double* row = passed_.data();
    std::copy_n(next.hessian + (2 * nv + c) * qs, state_.ndx, row);
    if (c < filtered_controls_) {
      double* y = y_.data() + c * y_stride_;
      const double through = 1.0 - e.decay[c];
      for (int j = 0; j < filtered_controls_; ++j)
        y[j] += through * row[2 * nv + j] * (1.0 - e.decay[j]);
    }
    transform_lead(state_, e.lead, false, row);
    std::fill_n(row + nv, nv, 0.0);
    for (int j = 0; j < nf; ++j) row[2 * nv + j] *= e.decay[j];
    if (c < filtered_controls_) {
      double* y = y_.data() + c * y_stride_ + nu_;
      for (int j = 0; j < state_.ndx; ++j) y[j] += (1.0 - e.decay[c]) * row[j];
    }
    dense::add_scaled(e.decay[c], row, state_.ndx, qxx_.data() + (2 * nv + c) * qs);
  }
}

void RiccatiRecursion::add_second_order(const KnotExpansion& e, const ValueStorage& next) {
  filtered_controls_ = std::min(nu_, state_.filtered);
  project_value(e, next);
  add_products(e);
  add_passed(e, next);
}

/// Solves the knot's box problem and leaves in Y a system whose solution is its own: clamped
/// controls have a unit row, no gain, and their step k_i as right-hand side.
void RiccatiRecursion::clamp(const ControlBox& box, double* k, RiccatiStep& result) {
  double* y = y_.data();
  double* qu = y + nz_;
  for (int i = 0; i < nu_; ++i) {
    box_lower_.data()[i] = box.lower[i] - box.u[i];
    box_upper_.data()[i] = box.upper[i] - box.u[i];
  }
  const BoxQpResult solved =
      box_qp_.solve({nu_, y, y_stride_, qu, y_stride_, box_lower_.data(), box_upper_.data()}, k);
  if (!solved.positive_definite) return;
  const auto quu = [&](int i, int j) {
    return i < j ? y[i * y_stride_ + j] : y[j * y_stride_ + i];
  };
  for (int i = 0; i < nu_; ++i) {
    result.slope += qu[i * y_stride_] * k[i];
    for (int j = 0; j < nu_; ++j) result.curvature += k[i] * quu(i, j) * k[j];
  }
  for (int c = 0; c < nu_; ++c) {
    if (!box_qp_.clamped(c)) continue;
    for (int i = 0; i < nu_; ++i)
      if (!box_qp_.clamped(i)) qu[i * y_stride_] += quu(i, c) * k[c];
    dense::add_scaled(k[c], y + c * y_stride_ + nu_, state_.ndx, gradient_.data() + nu_);
  }
  for (int c = 0; c < nu_; ++c) {
    if (!box_qp_.clamped(c)) continue;
    for (int i = 0; i < c; ++i) y[i * y_stride_ + c] = 0.0;
    std::fill_n(y + c * y_stride_ + c, nz_ - c, 0.0);
    y[c * y_stride_ + c] = 1.0;
    qu[c * y_stride_] = -k[c];
  }
}

RiccatiStep RiccatiRecursion::step(const KnotExpansion& e, int controls, const double* gap,
                                   ValueStorage next, double regularization, const ControlBox& box,
                                   PolicyStorage policy, ValueStorage value, double* hessian_gap) {
  RiccatiStep result;
  nu_ = controls;
  nz_ = controls + state_.ndx;
  const int vs = layout_.value_stride;
  const int ndx = state_.ndx;
  std::fill_n(hessian_gap, vs, 0.0);
  dense::add_transposed_times({next.hessian, vs}, gap, ndx, ndx, hessian_gap);
  result.gap_slope = dense::dot(next.gradient, gap, ndx);
  result.gap_curvature = dense::dot(hessian_gap, gap, ndx);
  dense::sum_scaled(next.gradient, 1.0, hessian_gap, ndx, w_next_.data());

  load_cost(e);
  if (e.form == DynamicsForm::Dense)
    add_dense(e, next);
  else
    add_second_order(e, next);
  add_transposed(state_, e, nu_, w_next_.data(), passed_.data(), gradient_.data());

  double* y = y_.data();
  double* q = gradient_.data();
  for (int i = 0; i < nu_; ++i) {
    y[i * y_stride_ + i] += regularization;
    y[i * y_stride_ + nz_] = q[i];
  }
  const bool bounded = box.lower != nullptr && box.upper != nullptr && nu_ > 0;
  if (bounded) clamp(box, policy.feedforward, result);
  result.failed_control =
      dense::partial_cholesky(y, y_stride_, nu_, nz_ + 1, inverse_diagonal_.data());
  if (result.failed_control >= 0) return result;

  dense::solve_gains(y, y_stride_, nu_, ndx + 1, inverse_diagonal_.data(), policy.gain,
                     layout_.gain_stride);
  dense::lower_product<Update::Subtract>({y + nu_, y_stride_, 1}, {y + nu_, y_stride_}, nu_, ndx,
                                         qxx_.data(), vs);
  dense::mirror_lower({qxx_.data(), vs}, ndx, value.hessian, vs);
  std::copy_n(q + nu_, ndx, value.gradient);
  for (int i = 0; i < nu_; ++i) {
    const double l = y[i * y_stride_ + nz_];
    dense::add_scaled(-l, y + i * y_stride_ + nu_, ndx, value.gradient);
    policy.feedforward[i] = policy.gain[i * layout_.gain_stride + ndx];
    if (!bounded) {
      result.slope -= l * l;
      result.curvature += l * l;
    }
  }
  return result;
}

}  // namespace burnish

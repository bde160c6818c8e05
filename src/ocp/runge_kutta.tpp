// Runge-Kutta steps of fourth order on the manifold of states y = (q, v, tau). The rates are
// k = (v, a). With c = (0, 1/2, 1/2, 1), the points and the step are
//   y_i = y (+) c_i h k_(i-1),
//   h (k_1 + 2 k_2 + 2 k_3 + k_4) / 6.
// Torques at the points follow the torque filter.
//
// Rates of joints with several entries cannot be added directly. The offset theta of q0 (+) theta
// has the rate J_r^-1(theta) v. For order four, two brackets of the series of this rate suffice (H.
// Munthe-Kaas, "High order Runge-Kutta methods on manifolds", 1999):
//   k = v + [theta, v] / 2 + [theta, [theta, v]] / 12.
#pragma once

#include "dynamics/joint_twist.hpp"
#include "ocp/node_kernel.hpp"

namespace burnish::ocp {
namespace runge_kutta_detail {

/// These functions return the rate of the offset theta, and the change of this rate for changes
/// dtheta and dv.
template <class S>
Motion<S> offset_rate(const Motion<S>& theta, const Motion<S>& v) {
  const Motion<S> once = cross(theta, v);
  return v + once * S(0.5) + cross(theta, once) * S(1.0 / 12.0);
}
template <class S>
Motion<S> offset_rate_change(const Motion<S>& theta, const Motion<S>& v, const Motion<S>& dtheta,
                             const Motion<S>& dv) {
  const Motion<S> once = cross(theta, v);
  const Motion<S> change = cross(dtheta, v) + cross(theta, dv);
  return dv + change * S(0.5) + (cross(dtheta, once) + cross(theta, change)) * S(1.0 / 12.0);
}

}  // namespace runge_kutta_detail

template <class S>
void NodeKernel<S>::runge_kutta(const CompiledStage& stage, const KnotTime<S>& when, const S* x,
                                const S* u, bool with_derivatives) {
  const StateLayout& layout = problem_->layout;
  const int nq = layout.nq, nv = layout.nv, nz = layout.nz();
  constexpr double fraction[4] = {0.0, 0.5, 0.5, 1.0};
  const S decay[4] = {S(1.0), when.half_decay, when.half_decay, when.decay};
  for (int i = 0; i < 4; ++i) {
    if (i > 0) {
      const S ch = S(fraction[i]) * when.step;
      const S* const before = rates_.data() + (i - 1) * 2 * nv;
      for (int k = 0; k < 2 * nv; ++k) offset_[k] = ch * before[k];
      integrate_configuration(problem_->tree, x, offset_.data(), point_.data());
      for (int k = 0; k < nv; ++k) point_[nq + k] = x[nq + k] + offset_[nv + k];
      filter_torque(x, u, decay[i], point_.data());
      dynamics_.values(stage, point_.data(), u);
      for (int l = 0; l < Lanes<S>::count; ++l) status_[l] = worst(status_[l], dynamics_.status(l));
      if (with_derivatives) dynamics_.derivatives(stage);
    }
    S* const rate = rates_.data() + i * 2 * nv;
    std::copy_n((i == 0 ? x : point_.data()) + nq, nv, rate);
    std::copy_n(dynamics_.acceleration(), nv, rate + nv);
    if (i > 0) {
      using namespace runge_kutta_detail;
      for (const TangentBlock& block : problem_->blocks) {
        const auto theta = load_twist(block.kind, offset_.data() + block.first, 1);
        const auto v = load_twist(block.kind, rate + block.first, 1);
        store_twist(block.kind, offset_rate(theta, v), rate + block.first, 1);
      }
    }
    if (with_derivatives) runge_kutta_derivative(when, i);
  }
  const S sixth = when.step / S(6.0), third = when.step / S(3.0);
  const S weights[4] = {sixth, third, third, sixth};
  std::fill(offset_.begin(), offset_.end(), S(0.0));
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 2 * nv; ++k) offset_[k] += weights[i] * rates_[i * 2 * nv + k];
  integrate_configuration(problem_->tree, x, offset_.data(), next.data());
  for (int k = 0; k < nv; ++k) next[nq + k] = x[nq + k] + offset_[nv + k];
  filter_torque(x, u, when.decay, next.data());
  if (!with_derivatives) return;

  S* const F = dynamics_by_z.data();
  for (int r = 0; r < 2 * nv; ++r)
    for (int c = 0; c < nz; ++c) {
      S sum(0.0);
      for (int i = 0; i < 4; ++i) sum += weights[i] * rates_by_z_[(i * 2 * nv + r) * nz + c];
      F[r * nz + c] = sum;
    }
  close_point(when.decay, offset_.data(), F);
}

template <class S>
void NodeKernel<S>::close_point(const S& decay, const S* offset, S* by_z) {
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz();
  // For joints with several entries, d(q (+) dq) = A dq0 + B d(dq) with Jacobians A and B.
  for (const TangentBlock& block : problem_->blocks) {
    S A[36], B[36], column[6];
    integrate_jacobians(block, offset + block.first, A, B);
    for (int c = 0; c < nz; ++c) {
      for (int i = 0; i < block.size; ++i) column[i] = by_z[(block.first + i) * nz + c];
      for (int i = 0; i < block.size; ++i) {
        S sum(0.0);
        for (int j = 0; j < block.size; ++j) sum += B[i * block.size + j] * column[j];
        by_z[(block.first + i) * nz + c] = sum;
      }
    }
    for (int i = 0; i < block.size; ++i)
      for (int j = 0; j < block.size; ++j)
        by_z[(block.first + i) * nz + layout.column_q() + block.first + j] += A[i * block.size + j];
  }
  for (int k = 0; k < nv; ++k) {
    if (!in_block(k)) by_z[k * nz + layout.column_q() + k] += S(1.0);
    by_z[(nv + k) * nz + layout.column_v() + k] += S(1.0);
  }
  for (int i = 0; i < layout.filtered; ++i) {
    S* const row = by_z + (2 * nv + i) * nz;
    std::fill_n(row, nz, S(0.0));
    row[i] = S(1.0) - decay;
    row[layout.column_tau() + i] = decay;
  }
}

template <class S>
bool NodeKernel<S>::in_block(int k) const {
  return std::any_of(problem_->blocks.begin(), problem_->blocks.end(),
                     [k](const TangentBlock& b) { return k >= b.first && k < b.first + b.size; });
}

template <class S>
void NodeKernel<S>::runge_kutta_derivative(const KnotTime<S>& when, int i) {
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz(), ndx = layout.ndx();
  constexpr double fraction[4] = {0.0, 0.5, 0.5, 1.0};
  const S decay[4] = {S(1.0), when.half_decay, when.half_decay, when.decay};
  S* const X = point_by_z_.data();  // d(point i)/dz, ndx x nz
  if (i == 0) {
    std::fill(point_by_z_.begin(), point_by_z_.end(), S(0.0));
    for (int k = 0; k < ndx; ++k) X[k * nz + layout.nu + k] = S(1.0);
  } else {
    const S ch = S(fraction[i]) * when.step;
    const S* const before = rates_by_z_.data() + (i - 1) * 2 * nv * nz;
    for (int k = 0; k < 2 * nv * nz; ++k) X[k] = ch * before[k];
    close_point(decay[i], offset_.data(), X);
  }
  S* const rate = rates_by_z_.data() + i * 2 * nv * nz;
  std::copy_n(X + nv * nz, nv * nz, rate);
  if (i > 0) {
    using namespace runge_kutta_detail;
    const S ch = S(fraction[i]) * when.step;
    const S* const before = rates_by_z_.data() + (i - 1) * 2 * nv * nz;
    for (const TangentBlock& block : problem_->blocks) {
      const auto theta = load_twist(block.kind, offset_.data() + block.first, 1);
      const auto v = load_twist(block.kind, point_.data() + layout.nq + block.first, 1);
      for (int c = 0; c < nz; ++c) {
        const int at = block.first * nz + c;
        const auto dtheta = load_twist(block.kind, before + at, nz) * ch;
        const auto dv = load_twist(block.kind, rate + at, nz);
        store_twist(block.kind, offset_rate_change(theta, v, dtheta, dv), rate + at, nz);
      }
    }
  }
  // da/dz = da/du at a constant state + da/dx dX/dz. With a torque model, da/du is zero.
  const S* const D = dynamics_.derivative();
  for (int r = 0; r < nv; ++r)
    for (int c = 0; c < nz; ++c) {
      S sum = c < layout.nu ? D[r * nz + c] : S(0.0);
      for (int k = 0; k < ndx; ++k) sum += D[r * nz + layout.nu + k] * X[k * nz + c];
      rate[(nv + r) * nz + c] = sum;
    }
}

}  // namespace burnish::ocp

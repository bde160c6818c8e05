// Definitions of node_kernel.hpp: costs, semi-implicit Euler steps and impacts.
#pragma once

#include <algorithm>
#include <numeric>

#include "base/to_size.hpp"
#include "math/gram.hpp"
#include "ocp/custom_lanes.tpp"
#include "ocp/node_kernel.hpp"
#include "ocp/penalty_kernel.hpp"
#include "ocp/residual_force.tpp"
#include "ocp/residual_frame.tpp"
#include "ocp/residual_momentum.tpp"
#include "ocp/residual_state.tpp"
#include "ocp/stage_dynamics.tpp"

namespace burnish::ocp {

template <class S>
NodeKernel<S>::NodeKernel(const CompiledProblem& problem)
    : cost(0.0),
      problem_(&problem),
      dynamics_(problem),
      status_(to_size(Lanes<S>::count), Status::Ok) {
  const StateLayout& layout = problem.layout;
  const auto room = [](int count) { return to_size(std::max(count, 1)); };
  const int nz = layout.nz();
  next.assign(room(layout.nx()), S(0.0));
  term_costs.assign(room(problem.largest_terms), S(0.0));
  row_values.assign(room(problem.largest_limited_rows), S(0.0));
  rows.assign(room(problem.largest_limited_rows * nz), S(0.0));
  curvatures.assign(room(problem.largest_curvatures * nz), S(0.0));
  curvatures_ = curvatures;
  gradient.assign(room(nz), S(0.0));
  hessian.assign(room(nz * nz), S(0.0));
  dynamics_by_z.assign(room((problem.has_dense_stages ? layout.ndx() : layout.nv) * nz), S(0.0));
  int tangent_size = 0;
  for (const TangentBlock& block : problem.blocks) tangent_size += 2 * block.size * block.size;
  tangent_blocks.assign(room(tangent_size), S(0.0));
  step_.assign(room(layout.nv), S(0.0));
  for (auto* vector : {&r_, &slope_, &curvature_})
    vector->assign(room(problem.largest_rows), S(0.0));
  jacobian_.assign(room(problem.largest_jacobian), S(0.0));
  weighted_ = jacobian_;
  product_.assign(room(nz * nz), S(0.0));
  row_list_.resize(room(problem.largest_rows));
  std::iota(row_list_.begin(), row_list_.end(), 0);
  if (problem.has_custom) custom_.emplace(problem);
  if (!problem.has_dense_stages) return;
  const int rates = layout.nv + layout.nv;
  rates_.assign(room(4 * rates), S(0.0));
  point_.assign(room(layout.nx()), S(0.0));
  offset_.assign(room(2 * layout.nv), S(0.0));
  rates_by_z_.assign(room(4 * rates * nz), S(0.0));
  point_by_z_.assign(room(layout.ndx() * nz), S(0.0));
}

template <class S>
void NodeKernel<S>::residual(const CompiledStage& stage, const CompiledTerm& term, const S* targets,
                             const double* times, const ResidualOutput<S>& out) {
  const KnotState<S>& knot = dynamics_.knot();
  std::visit(
      [&](const auto& compiled) {
        if constexpr (std::is_same_v<std::decay_t<decltype(compiled)>, CustomResidual>) {
          custom_->evaluate(stage, compiled, knot, times, out.r, out.J);
        } else if constexpr (requires { compiled.curvature_rows(); }) {
          compiled.evaluate(knot, targets + term.target, out.r, out.J, out.curvatures);
        } else {
          compiled.evaluate(knot, targets + term.target, out.r, out.J);
        }
      },
      term.residual);
}

template <class S>
void NodeKernel<S>::load(const CompiledStage& stage, const S* targets, const KnotTime<S>& when) {
  dynamics_.turn(stage, targets);
  dynamics_.set_step(when.per_second, when.step_ratio, when.decaying);
}

template <class S>
void NodeKernel<S>::add_block(const JacobianBlock& block, const S* J, const S* slope,
                              const S* curvature) {
  const int nz = problem_->layout.nz();
  const int columns = static_cast<int>(block.columns.size());
  if (block.diagonal) {
    for (int i = 0; i < block.rows; ++i) {
      const int c = block.columns[i];
      gradient[c] += J[i] * slope[i];
      hessian[c * nz + c] += J[i] * J[i] * curvature[i];
    }
    return;
  }
  for (int i = 0; i < block.rows; ++i)
    for (int k = 0; k < columns; ++k) {
      gradient[block.columns[k]] += J[i * columns + k] * slope[i];
      weighted_[i * columns + k] = J[i * columns + k] * curvature[i];
    }
  const std::span<const int> all(row_list_.data(), to_size(block.rows));
  const StridedView<const S> left{weighted_.data(), columns}, right{J, columns};
  const int first = block.columns[0];
  const bool contiguous = block.columns[columns - 1] - first + 1 == columns;
  // Lower triangle of J^T W J, in strips of four rows.
  for (int i = 0; i < columns; i += 4) {
    const int end = std::min(i + 4, columns);
    if (contiguous) {
      gram<Gram::Add>(left, right, all, i, end, 0, end,
                      StridedView<S>{hessian.data() + first * nz + first, nz});
    } else {
      gram<Gram::Set>(left, right, all, i, end, 0, end, StridedView<S>{product_.data(), columns});
    }
  }
  if (contiguous) return;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j <= i; ++j)
      hessian[block.columns[i] * nz + block.columns[j]] += product_[i * columns + j];
}

template <class S>
void NodeKernel<S>::add_costs(const CompiledStage& stage, const S* targets, const KnotTime<S>& when,
                              bool expand) {
  cost = S(0.0);
  for (std::size_t t = 0; t < stage.costs; ++t) {
    const CompiledTerm& term = stage.terms[t];
    residual(stage, term, targets, when.times,
             {.r = r_.data(), .J = expand ? jacobian_.data() : nullptr});
    const S scale = S(term.weight) * when.weight;
    S sum(0.0), largest(0.0);
    for (int i = 0; i < term.rows; ++i) {
      const PenaltyValue<S> value =
          evaluate_penalty(term.penalty, term.lower[i], term.upper[i], term.width, r_[i]);
      const S w = scale * S(term.weights[i]);
      sum += w * value.value;
      slope_[i] = w * value.slope;
      curvature_[i] = w * value.curvature;
      largest = select(less(largest, curvature_[i]), curvature_[i], largest);
    }
    term_costs[t] = sum;
    cost += sum;
    // A barrier without a violated limit has zero slope and curvature.
    if (!expand || !any(less(S(0.0), largest))) continue;
    const S* J = jacobian_.data();
    for (const JacobianBlock& block : term.blocks) {
      add_block(block, J, slope_.data() + block.row, curvature_.data() + block.row);
      J += block.size();
    }
  }
}

template <class S>
void NodeKernel<S>::add_constraints(const CompiledStage& stage, const S* targets,
                                    const double* times, bool expand) {
  const int nz = problem_->layout.nz();
  if (expand) {
    std::fill_n(rows.begin(), stage.coefficient_rows * nz, S(0.0));
    std::fill_n(curvatures.begin(), stage.curvature_rows * nz, S(0.0));
  }
  for (const CompiledTerm& term : stage.constraints()) {
    const bool differentiate = expand && term.first_coefficients >= 0;
    const bool curved = differentiate && term.first_curvature >= 0;
    residual(stage, term, targets, times,
             {.r = row_values.data() + term.first_row,
              .J = differentiate ? jacobian_.data() : nullptr,
              .curvatures = curved ? curvatures_.data() : nullptr});
    if (!differentiate) continue;
    store_rows(term);
    if (curved) store_curvatures(term);
  }
}

/// Writes the Jacobian of a constraint to all columns of z.
template <class S>
void NodeKernel<S>::store_rows(const CompiledTerm& term) {
  const int nz = problem_->layout.nz();
  const S* J = jacobian_.data();
  for (const JacobianBlock& block : term.blocks) {
    const int columns = static_cast<int>(block.columns.size());
    for (int i = 0; i < block.rows; ++i) {
      S* const row = rows.data() + (term.first_coefficients + block.row + i) * nz;
      if (block.diagonal) {
        row[block.columns[i]] = J[i];
      } else {
        for (int k = 0; k < columns; ++k) row[block.columns[k]] = J[i * columns + k];
      }
    }
    J += block.size();
  }
}

/// Writes the curvature vectors of a constraint to all columns of z. A constraint with curvature
/// has one Jacobian block.
template <class S>
void NodeKernel<S>::store_curvatures(const CompiledTerm& term) {
  const int nz = problem_->layout.nz();
  const std::vector<int>& all = term.blocks[0].columns;
  const int columns = static_cast<int>(all.size());
  for (int i = 0; i < term.curvature_rows; ++i)
    for (int k = 0; k < columns; ++k)
      curvatures[(term.first_curvature + i) * nz + all[k]] = curvatures_[i * columns + k];
}

template <class S>
void NodeKernel<S>::filter_torque(const S* x, const S* u, const S& decay, S* out) const {
  const StateLayout& layout = problem_->layout;
  const S gain = S(1.0) - decay;
  for (int i = 0; i < layout.filtered; ++i) {
    const int entry = layout.nq + layout.nv + i;
    out[entry] = u == nullptr ? x[entry] : x[entry] * decay + u[i] * gain;
  }
}

template <class S>
void NodeKernel<S>::euler(const KnotTime<S>& when, const S* x, const S* u) {
  const StateLayout& layout = problem_->layout;
  const S h = when.step;
  const S* const a = dynamics_.acceleration();
  for (int k = 0; k < layout.nv; ++k) {
    const S v = x[layout.nq + k] + h * a[k];
    next[layout.nq + k] = v;
    step_[k] = h * v;
  }
  integrate_configuration(problem_->tree, x, step_.data(), next.data());
  filter_torque(x, u, when.decay, next.data());
}

template <class S>
void NodeKernel<S>::euler_derivative(const S& h) {
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz();
  const S* const by_z = dynamics_.derivative();
  for (int i = 0; i < nv * nz; ++i) dynamics_by_z[i] = h * by_z[i];
  for (int k = 0; k < nv; ++k) dynamics_by_z[k * nz + layout.column_v() + k] += S(1.0);
  S* out = tangent_blocks.data();
  for (const TangentBlock& block : problem_->blocks) {
    const int size = block.size * block.size;
    integrate_jacobians(block, step_.data() + block.first, out, out + size);
    out += 2 * size;
  }
}

/// Computes F, the derivative of the next state by z, for a semi-implicit Euler step of length h.
/// The step gives dv' = dv + h da and d(offset) = h dv'.
template <class S>
void NodeKernel<S>::euler_dense_derivative(const KnotTime<S>& when) {
  const StateLayout& layout = problem_->layout;
  const int nv = layout.nv, nz = layout.nz();
  const S h = when.step;
  const S* const by_z = dynamics_.derivative();
  S* const F = dynamics_by_z.data();
  for (int i = 0; i < nv * nz; ++i) {
    const S dv = h * by_z[i];
    F[nv * nz + i] = dv;
    F[i] = h * dv;
  }
  for (int k = 0; k < nv; ++k) F[k * nz + layout.column_v() + k] += h;
  close_point(when.decay, step_.data(), F);
}

template <class S>
void NodeKernel<S>::store_force_states(const CompiledStage& stage) {
  const StateLayout& layout = problem_->layout;
  const ConstrainedDynamics<S>& dynamics = dynamics_.contact_dynamics();
  S* const out = next.data() + layout.nq + layout.nv + layout.filtered;
  for (const ForceState& force : problem_->force_states) {
    if (stage.active[to_size(force.contact)] == 0) {
      std::fill_n(out + force.first, force.rows, S(0.0));
    } else {
      const int row = dynamics.active().first_row[force.contact];
      std::copy_n(dynamics.lambda.data() + row, force.rows, out + force.first);
    }
  }
}

template <class S>
void NodeKernel<S>::store_force_state_derivatives(const CompiledStage& stage) {
  const StateLayout& layout = problem_->layout;
  const int nz = layout.nz();
  const S* const by_z = dynamics_.knot().dlambda_dz;
  S* const out = dynamics_by_z.data() + (2 * layout.nv + layout.filtered) * nz;
  for (const ForceState& force : problem_->force_states) {
    if (stage.active[to_size(force.contact)] == 0) {
      std::fill_n(out + force.first * nz, force.rows * nz, S(0.0));
    } else {
      const int row = dynamics_.contact_dynamics().active().first_row[force.contact];
      std::copy_n(by_z + row * nz, force.rows * nz, out + force.first * nz);
    }
  }
}

template <class S>
void NodeKernel<S>::jump(const CompiledStage& stage, const S* x, bool with_derivatives) {
  const StateLayout& layout = problem_->layout;
  dynamics_.impact(stage, with_derivatives);
  std::copy_n(x, layout.nx(), next.data());
  std::copy_n(dynamics_.velocity_after(), layout.nv, next.data() + layout.nq);
  if (!with_derivatives) return;
  std::copy_n(dynamics_.derivative(), layout.nv * layout.nz(), dynamics_by_z.data());
  S* out = tangent_blocks.data();
  for (const TangentBlock& block : problem_->blocks)
    for (int which = 0; which < 2; ++which)
      for (int i = 0; i < block.size; ++i)
        for (int j = 0; j < block.size; ++j) *out++ = S(i == j ? 1.0 : 0.0);
}

template <class S>
void NodeKernel<S>::load_status() {
  for (int l = 0; l < Lanes<S>::count; ++l) status_[l] = dynamics_.status(l);
}

template <class S>
void NodeKernel<S>::values(const CompiledStage& stage, const S* x, const S* u, const S* targets,
                           const KnotTime<S>& when) {
  load(stage, targets, when);
  dynamics_.values(stage, x, u);
  add_costs(stage, targets, when, false);
  if (stage.rows() > 0) [[unlikely]]
    add_constraints(stage, targets, when.times, false);
  if (stage.impact) {
    jump(stage, x, false);
  } else if (!stage.terminal) {
    store_force_states(stage);
    if (stage.integrator == Integrator::RungeKutta4) {
      load_status();
      runge_kutta(stage, when, x, u, false);
      check_finite(stage, false);
      return;
    }
    euler(when, x, u);
  }
  load_status();
  check_finite(stage, false);
}

template <class S>
void NodeKernel<S>::expand(const CompiledStage& stage, const S* x, const S* u, const S* targets,
                           const KnotTime<S>& when) {
  load(stage, targets, when);
  dynamics_.values(stage, x, u);
  dynamics_.derivatives(stage);
  std::fill(gradient.begin(), gradient.end(), S(0.0));
  std::fill(hessian.begin(), hessian.end(), S(0.0));
  add_costs(stage, targets, when, true);
  if (stage.rows() > 0) [[unlikely]]
    add_constraints(stage, targets, when.times, true);
  load_status();
  if (stage.impact) {
    jump(stage, x, true);
    load_status();
  } else if (!stage.terminal) {
    store_force_states(stage);
    store_force_state_derivatives(stage);
    if (stage.integrator == Integrator::RungeKutta4) {
      runge_kutta(stage, when, x, u, true);
    } else {
      euler(when, x, u);
      if (stage.dense)
        euler_dense_derivative(when);
      else
        euler_derivative(when.step);
    }
  }
  check_finite(stage, true);
}

template <class S>
void NodeKernel<S>::check_finite(const CompiledStage& stage, bool expanded) {
  // 0 * x is zero for finite x and NaN otherwise.
  S zero = cost * S(0.0);
  if (!stage.terminal)
    for (const S& entry : next) zero += entry * S(0.0);
  if (expanded)
    for (const S& entry : gradient) zero += entry * S(0.0);
  if (const int limited = stage.rows(); limited > 0) [[unlikely]] {
    for (int i = 0; i < limited; ++i) zero += row_values[i] * S(0.0);
    if (expanded)
      for (int i = 0; i < stage.coefficient_rows * problem_->layout.nz(); ++i)
        zero += rows[i] * S(0.0);
  }
  const auto bad = mask_not(less(absolute(zero), S(1.0)));
  if (!any(bad)) [[likely]]
    return;
  for (int l = 0; l < Lanes<S>::count; ++l)
    if (lane_of(bad, l)) status_[l] = worst(status_[l], Status::NotFinite);
}

template <class S>
KnotValue NodeKernel<S>::outcome(const CompiledStage& stage, int lane) const {
  KnotValue value{Lanes<S>::get(cost, lane), status(lane)};
  if (value.status != Status::NotFinite) [[likely]]
    return value;
  const auto first_bad = [&](const std::vector<S>& entries, int count) {
    for (int i = 0; i < count; ++i)
      if (!std::isfinite(Lanes<S>::get(entries[i], lane))) return i;
    return -1;
  };
  value.term = first_bad(term_costs, static_cast<int>(stage.costs));
  if (value.term < 0) value.row = first_bad(row_values, stage.rows());
  return value;
}

}  // namespace burnish::ocp

#include "ocp/runge_kutta.tpp"

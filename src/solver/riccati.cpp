#include "solver/riccati.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

using dense::Range;
using dense::Rows;
using dense::Update;

namespace {

/// Returns the range of `count` rows or columns that a worker computes, in groups of `size`. The
/// last group belongs to the leader, which has at most as many groups as the other workers.
Range worker_range(const ThreadTeam& team, int count, int size) {
  if (team.alone()) return {0, count};
  const int groups = (count + size - 1) / size;
  const auto border = [&](int worker) {
    return std::min((groups * worker + team.workers - 1) / team.workers, groups - 1) * size;
  };
  return {border(team.worker), team.leads() ? count : border(team.worker + 1)};
}

/// Returns the rows of a triangle for a worker. All workers have about equally many entries.
Range triangle_rows(const ThreadTeam& team, int count, int size) {
  if (team.alone()) return {0, count};
  const int groups = (count + size - 1) / size;
  const auto border = [&](int worker) {
    const double fraction = std::sqrt(static_cast<double>(worker) / team.workers);
    return std::min(count, static_cast<int>(std::lround(groups * fraction)) * size);
  };
  return {border(team.worker), border(team.worker + 1)};
}

Range common(const Range& a, const Range& b) {
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

}  // namespace

struct RiccatiRecursion::Knot {
  Knot(const RiccatiKnot& at, const StateShape& state, const ThreadTeam& who, Own& workspace)
      : e(at.expansion),
        next(at.next),
        team(who),
        own(workspace),
        nu(at.controls),
        nz(at.controls + state.ndx),
        through(std::min(at.controls, state.filtered)),
        columns(worker_range(team, nz, dense::group)),
        rows(triangle_rows(team, state.ndx, dense::group)),
        gains(worker_range(team, state.ndx + 1, dense::group)) {}

  const KnotExpansion& e;
  const ValueStorage& next;
  const ThreadTeam& team;
  Own& own;
  int nu, nz;
  int through;    ///< Number of controls that act through a torque filter
  Range columns;  ///< Columns of Y and G
  Range rows;     ///< Rows of Qxx
  Range gains;    ///< Columns of [K | k]
  int width() const { return columns.end - columns.begin; }
};

RiccatiLayout::RiccatiLayout(const StateShape& state, int max_controls)
    : expansion_stride(dense::round_up(state.ndx + max_controls)),
      expansion_rows(expansion_stride),
      value_stride(dense::round_up(state.ndx)),
      gain_stride(dense::round_up(state.ndx + 1)),
      spare(dense::spare) {}

RiccatiRecursion::RiccatiRecursion(const StateShape& state, int max_controls, int workers)
    : state_(state),
      layout_(state, max_controls),
      y_stride_(dense::round_up(max_controls + state.ndx + 1)),
      box_qp_(max_controls) {
  const int inner = state.nv;
  const int rows = std::max(1, dense::round_up(max_controls));
  y_ = Buffer(dense::block_size(rows, y_stride_));
  qxx_ = Buffer(dense::block_size(layout_.value_stride, layout_.value_stride));
  gradient_ = Buffer(dense::block_size(2, y_stride_));
  g_ = Buffer(dense::block_size(state.ndx, y_stride_));
  w_next_ = Buffer(dense::block_size(2, layout_.value_stride));
  box_lower_ = Buffer(dense::block_size(1, rows));
  box_upper_ = Buffer(dense::block_size(1, rows));
  column_ = Buffer(dense::block_size(rows, dense::lanes));
  if (workers > 1) l_ = Buffer(dense::block_size(rows, layout_.gain_stride));
  for (int w = 0; w < workers; ++w)
    own_.push_back({Buffer(dense::block_size(inner, layout_.value_stride)),
                    Buffer(dense::block_size(inner, dense::round_up(inner))),
                    Buffer(dense::block_size(inner, y_stride_)),
                    Buffer(dense::block_size(state.nv + state.filtered, layout_.value_stride)),
                    Buffer(dense::block_size(1, rows)),
                    workers > 1 ? Buffer(dense::block_size(rows, y_stride_)) : Buffer()});
}

double RiccatiRecursion::multiplications(int controls, DynamicsForm form) const {
  const double nu = controls;
  const double ndx = state_.ndx;
  const double nv = state_.nv;
  const double nz = nu + ndx;
  const double factor = nu * nu * (ndx + 0.5 * nu) + 0.5 * nu * ndx * ndx;
  if (form == DynamicsForm::Dense) return ndx * (ndx * nz + nu * nz + 0.5 * ndx * ndx) + factor;
  const double passing = nv * (0.5 * nv * nv + state_.filtered * (ndx + nz));
  return nv * (nv * nz + nu * nz + 0.5 * ndx * ndx) + passing + factor;
}

void RiccatiRecursion::terminal(const KnotExpansion& e, ValueStorage value) const {
  std::copy_n(e.gradient, state_.ndx, value.gradient);
  dense::mirror_lower({e.hessian, e.stride}, {0, state_.ndx},
                      {value.hessian, layout_.value_stride});
}

/// Loads the knot's cost: Y <- [Huu | Hux], Qxx <- Hxx.
void RiccatiRecursion::load_cost(const Knot& knot) {
  const KnotExpansion& e = knot.e;
  const int first = knot.columns.begin;
  dense::transpose_copy({e.hessian + first * e.stride, e.stride}, knot.width(), knot.nu,
                        {y_.data() + first, y_stride_});
  for (int i = knot.rows.begin; i < knot.rows.end; ++i)
    dense::copy(e.hessian + (knot.nu + i) * e.stride + knot.nu, i + 1,
                qxx_.data() + i * layout_.value_stride);
}

/// Computes U^T = step B^T Vq + Vv from the rows Vq and Vv of Vxx', then W and M (riccati.hpp).
void RiccatiRecursion::project_value(const Knot& knot) {
  project_rows(state_, knot.e, knot.next.hessian, layout_.value_stride, knot.own.u.data());
  project_steps(knot);
}

/// Computes the products W = U^T T and M = U^T E (riccati.hpp).
void RiccatiRecursion::project_steps(const Knot& knot) {
  const KnotExpansion& e = knot.e;
  const int nv = state_.nv;
  const int nu = knot.nu;
  Own& mine = knot.own;
  for (int i = 0; i < nv; ++i) {
    const double* u = mine.u.data() + i * layout_.value_stride;
    double* w = mine.w.data() + i * dense::round_up(nv);
    double* m = mine.m.data() + i * y_stride_;
    std::fill_n(m, knot.nz, 0.0);
    for (int c = 0; c < knot.through; ++c) m[c] = u[2 * nv + c] * (1.0 - e.decay[c]);
    std::copy_n(u, nv, m + nu);
    for (int c = 0; c < state_.filtered; ++c) m[nu + 2 * nv + c] = u[2 * nv + c] * e.decay[c];
    if (state_.blocks.empty()) {
      dense::sum_scaled(u + nv, e.step, u, nv, w);
      continue;
    }
    double* moved = mine.passed.data();
    std::copy_n(u, nv, moved);
    transform_tangent(state_, e.tangent_blocks, true, moved);
    dense::sum_scaled(u + nv, e.step, moved, nv, w);
    transform_tangent(state_, e.tangent_blocks, false, m + nu);
  }
}

/// Computes G, and adds to Y the rows of F^T V F that belong to controls (riccati.hpp).
void RiccatiRecursion::add_to_controls(const Knot& knot) {
  const KnotExpansion& e = knot.e;
  const int nv = state_.nv;
  const int first = knot.columns.begin;
  const int width = knot.width();
  const double* m = knot.own.m.data();
  const Rows f{e.dynamics + first, e.stride};
  const Rows g{g_.data() + first, y_stride_};
  double* y = y_.data() + first;
  if (e.form == DynamicsForm::Dense) {
    const int ndx = state_.ndx;
    dense::product<Update::Set>({knot.next.hessian, layout_.value_stride, 1}, f, ndx, ndx, width,
                                {g_.data() + first, y_stride_});
    dense::product<Update::Add>({e.dynamics, e.stride, 1}, g, ndx, knot.nu, width, {y, y_stride_});
    return;
  }
  for (int i = 0; i < nv; ++i)
    dense::copy(m + i * y_stride_ + first, width, g_.data() + i * y_stride_ + first);
  dense::product<Update::Add>({knot.own.w.data(), dense::round_up(nv), 1}, f, nv, nv, width,
                              {g_.data() + first, y_stride_});
  dense::product<Update::Add>({e.dynamics, e.stride, 1}, g, nv, knot.nu, width, {y, y_stride_});
  if (knot.through == 0) return;
  dense::product<Update::Add>({m, y_stride_, 1}, f, nv, knot.through, width, {y, y_stride_});
  add_passed_to_controls(knot);
}

/// Adds E^T V E, the contribution of the torque filter, to Y. Leaves rows of V E in `passed`.
void RiccatiRecursion::add_passed_to_controls(const Knot& knot) {
  const KnotExpansion& e = knot.e;
  const int nv = state_.nv;
  const int vs = layout_.value_stride;
  const Range controls = common(knot.columns, {0, knot.through});
  const Range states = common(knot.columns, {knot.nu, knot.nz});
  for (int c = 0; c < knot.through; ++c) {
    const double* v = knot.next.hessian + (2 * nv + c) * vs;
    double* y = y_.data() + c * y_stride_;
    const double through = 1.0 - e.decay[c];
    for (int j = controls.begin; j < controls.end; ++j)
      y[j] += through * v[2 * nv + j] * (1.0 - e.decay[j]);
    const double* row = pass_filtered(knot, c);
    for (int j = states.begin; j < states.end; ++j) y[j] += through * row[j - knot.nu];
  }
}

/// Returns the row of V E that belongs to the filtered torque c, in columns of dx.
const double* RiccatiRecursion::pass_filtered(const Knot& knot, int c) {
  const int nv = state_.nv;
  const int vs = layout_.value_stride;
  double* row = knot.own.passed.data() + (nv + c) * vs;
  std::copy_n(knot.next.hessian + (2 * nv + c) * vs, state_.ndx, row);
  transform_tangent(state_, knot.e.tangent_blocks, false, row);
  std::fill_n(row + nv, nv, 0.0);
  for (int j = 0; j < state_.filtered; ++j) row[2 * nv + j] *= knot.e.decay[j];
  return row;
}

/// Computes the gradient of the next value function after the gap, w = vx' + Vxx' gap.
void RiccatiRecursion::cross_gap(const Knot& knot, const double* gap, double* hessian_gap,
                                 RiccatiStep& result) {
  const int ndx = state_.ndx;
  const int vs = layout_.value_stride;
  std::fill_n(hessian_gap, vs, 0.0);
  dense::add_row_times(gap, {knot.next.hessian, vs}, ndx, ndx, hessian_gap);
  result.gap_slope = dense::dot(knot.next.gradient, gap, ndx);
  result.gap_curvature = dense::dot(hessian_gap, gap, ndx);
  dense::sum_scaled(knot.next.gradient, 1.0, hessian_gap, ndx, w_next_.data());
}

/// Computes the gradient q = h + F^T w of the knot, and writes its control part qu to Y.
void RiccatiRecursion::add_gradient(const Knot& knot, const double* gradient) {
  double* q = gradient_.data();
  dense::copy(gradient, knot.nz, q);
  add_transposed(state_, knot.e, knot.nu, w_next_.data(), knot.own.passed.data(), q);
  double* y = y_.data();
  for (int i = 0; i < knot.nu; ++i) y[i * y_stride_ + knot.nz] = q[i];
}

/// Adds the cost of constraint rows: C^T w C to Quu, Qux and Qxx.
void RiccatiRecursion::add_rows(const Knot& knot, const WeightedRows& rows) {
  const int first = knot.columns.begin;
  if (rows.count > 0) {
    dense::product<Update::Add>({rows.weighted, rows.stride, 1}, {rows.rows + first, rows.stride},
                                rows.count, knot.nu, knot.width(), {y_.data() + first, y_stride_});
    dense::lower_product<Update::Add>({rows.weighted + knot.nu, rows.stride, 1},
                                      {rows.rows + knot.nu, rows.stride}, rows.count, knot.rows,
                                      {qxx_.data(), layout_.value_stride});
  }
  if (rows.diagonal == nullptr) return;
  for (int i = first; i < std::min(knot.nu, knot.columns.end); ++i)
    y_.data()[i * y_stride_ + i] += rows.diagonal[i];
  for (int i = knot.rows.begin; i < knot.rows.end; ++i)
    qxx_.data()[i * layout_.value_stride + i] += rows.diagonal[knot.nu + i];
}

/// Adds P^T G + M^T P (riccati.hpp) to Qxx. M^T P is nonzero only in the rows of dq and dtau, which
/// pass through.
void RiccatiRecursion::add_to_states(const Knot& knot) {
  const KnotExpansion& e = knot.e;
  const int nv = state_.nv;
  const int nu = knot.nu;
  const int ndx = state_.ndx;
  const int qs = layout_.value_stride;
  const double* m = knot.own.m.data() + nu;
  double* qxx = qxx_.data();
  const bool is_dense = e.form == DynamicsForm::Dense;
  const Rows px{e.dynamics + nu, e.stride};
  dense::lower_product<Update::Add>({px.data, px.stride, 1}, {g_.data() + nu, y_stride_},
                                    is_dense ? ndx : nv, knot.rows, {qxx, qs});
  if (is_dense) return;
  dense::lower_product<Update::Add>({m, y_stride_, 1}, px, nv, common(knot.rows, {0, nv}),
                                    {qxx, qs});
  const Range filter = common(knot.rows, {2 * nv, ndx});
  if (filter.begin < filter.end)
    dense::product<Update::Add>({m + filter.begin, y_stride_, 1}, px, nv, filter.end - filter.begin,
                                ndx, {qxx + filter.begin * qs, qs});
  add_passed_to_states(knot);
  add_passed_controls_to_states(knot);
}

/// Adds to Qxx the rows of E^T V E that belong to dq.
void RiccatiRecursion::add_passed_to_states(const Knot& knot) {
  const int qs = layout_.value_stride;
  const double* v = knot.next.hessian;
  const Range rows = common(knot.rows, {0, state_.nv});
  if (state_.blocks.empty()) {
    for (int i = rows.begin; i < rows.end; ++i)
      dense::add_scaled(1.0, v + i * qs, i + 1, qxx_.data() + i * qs);
    return;
  }
  double* passed = knot.own.passed.data();
  const auto pass = [&](int i) {
    std::copy_n(v + i * qs, state_.nv, passed + i * qs);
    transform_tangent(state_, knot.e.tangent_blocks, false, passed + i * qs);
  };
  int done = rows.begin;
  const auto add_rows = [&](int end) {
    for (; done < end; ++done) {
      pass(done);
      dense::add_scaled(1.0, passed + done * qs, done + 1, qxx_.data() + done * qs);
    }
  };
  const double* tangent_blocks = knot.e.tangent_blocks;
  for (const NonEuclideanBlock& b : state_.blocks) {
    add_rows(std::min(b.first, rows.end));
    const Range part = common(rows, {b.first, b.first + b.size});
    if (part.begin < part.end)
      for (int k = 0; k < b.size; ++k) pass(b.first + k);
    for (int i = part.begin; i < part.end; ++i)
      for (int k = 0; k < b.size; ++k)
        dense::add_scaled(tangent_blocks[k * b.size + i - b.first], passed + (b.first + k) * qs,
                          i + 1, qxx_.data() + i * qs);
    done = std::max(done, std::min(b.first + b.size, rows.end));
    tangent_blocks += 2 * b.size * b.size;
  }
  add_rows(rows.end);
}

/// Adds to Qxx the rows of E^T V E that belong to filtered torques.
void RiccatiRecursion::add_passed_controls_to_states(const Knot& knot) {
  const int nv = state_.nv;
  const int qs = layout_.value_stride;
  const Range rows = common(knot.rows, {2 * nv, state_.ndx});
  for (int i = rows.begin; i < rows.end; ++i) {
    const int c = i - 2 * nv;
    const double* row =
        c < knot.through ? knot.own.passed.data() + (nv + c) * qs : pass_filtered(knot, c);
    dense::add_scaled(knot.e.decay[c], row, state_.ndx, qxx_.data() + i * qs);
  }
}

/// Solves the knot's box QP. Then changes the system in Y so that it has the solution of the box
/// QP: a clamped control gets a unit row, no gain, and its step k_i as right-hand side.
void RiccatiRecursion::clamp(const Knot& knot, const ControlBox& box, double* k,
                             RiccatiStep& result) {
  const int nu = knot.nu;
  const int nz = knot.nz;
  double* y = y_.data();
  double* qu = y + nz;
  for (int i = 0; i < nu; ++i) {
    box_lower_.data()[i] = box.lower[i] - box.u[i];
    box_upper_.data()[i] = box.upper[i] - box.u[i];
  }
  const BoxQpResult solved =
      box_qp_.solve({nu, y, y_stride_, qu, y_stride_, box_lower_.data(), box_upper_.data()}, k);
  if (!solved.positive_definite) return;
  const auto quu = [&](int i, int j) {
    return i < j ? y[i * y_stride_ + j] : y[j * y_stride_ + i];
  };
  for (int i = 0; i < nu; ++i) {
    result.slope += qu[i * y_stride_] * k[i];
    for (int j = 0; j < nu; ++j) result.curvature += k[i] * quu(i, j) * k[j];
  }
  for (int c = 0; c < nu; ++c) {
    if (!box_qp_.clamped(c)) continue;
    for (int i = 0; i < nu; ++i)
      if (!box_qp_.clamped(i)) qu[i * y_stride_] += quu(i, c) * k[c];
    dense::add_scaled(k[c], y + c * y_stride_ + nu, state_.ndx, gradient_.data() + nu);
  }
  for (int c = 0; c < nu; ++c) {
    if (!box_qp_.clamped(c)) continue;
    for (int i = 0; i < c; ++i) y[i * y_stride_ + c] = 0.0;
    std::fill_n(y + c * y_stride_ + c, nz - c, 0.0);
    y[c * y_stride_ + c] = 1.0;
    qu[c * y_stride_] = -k[c];
  }
}

/// Computes R, and a worker's columns of [L | l] and [K | k]. Returns the first control that fails,
/// or -1.
int RiccatiRecursion::factorize(const Knot& knot, const PolicyStorage& policy) {
  const int nu = knot.nu;
  double* inverse = knot.own.inverse_diagonal.data();
  const int first = nu + knot.gains.begin;
  const int width = knot.gains.end - knot.gains.begin;
  double* y = y_.data();
  Range columns{0, knot.nz + 1};
  if (!knot.team.alone()) {
    y = knot.own.factor.data();
    columns = {first, nu + knot.gains.end};
    const int left = dense::round_down(first);
    for (int i = 0; i < nu; ++i) {
      const double* from = y_.data() + i * y_stride_;
      double* to = y + i * y_stride_;
      dense::copy(from, nu, to);
      if (width > 0) dense::copy(from + left, columns.end - left, to + left);
    }
  }
  const int failed = dense::partial_cholesky(y, y_stride_, nu, columns, inverse);
  if (failed >= 0 || width == 0) return failed;
  dense::solve_gains({y, y_stride_, inverse}, {y + first, y_stride_}, nu, width,
                     {policy.gain + knot.gains.begin, layout_.gain_stride});
  if (!knot.team.alone())
    for (int i = 0; i < nu; ++i)
      dense::copy(y + i * y_stride_ + first, width,
                  l_.data() + i * layout_.gain_stride + knot.gains.begin);
  return -1;
}

/// Computes the value function: Vxx = Qxx - L^T L, vx = qx - L^T l.
void RiccatiRecursion::reduce(const Knot& knot, const ValueStorage& value) {
  const int vs = layout_.value_stride;
  const int ndx = state_.ndx;
  const bool alone = knot.team.alone();
  const Rows l =
      alone ? Rows{y_.data() + knot.nu, y_stride_} : Rows{l_.data(), layout_.gain_stride};
  dense::lower_product<Update::Subtract>({l.data, l.stride, 1}, l, knot.nu, knot.rows,
                                         {qxx_.data(), vs});
  dense::mirror_lower({qxx_.data(), vs}, knot.rows, {value.hessian, vs});
  const Range part = worker_range(knot.team, ndx, dense::lanes);
  const int width = part.end - part.begin;
  const int nu = knot.nu;
  double* gradient = value.gradient + part.begin;
  std::copy_n(gradient_.data() + nu + part.begin, width, gradient);
  for (int i = 0; i < nu; ++i) {
    const double* row = l.data + i * l.stride;
    dense::add_scaled(-row[ndx], row + part.begin, width, gradient);
  }
}

/// Writes the feedforward, and the change of cost that the quadratic model predicts for it.
void RiccatiRecursion::conclude(const Knot& knot, bool bounded, const PolicyStorage& policy,
                                RiccatiStep& result) {
  const bool alone = knot.team.alone();
  const double* l = alone ? y_.data() + knot.nz : l_.data() + state_.ndx;
  const int stride = alone ? y_stride_ : layout_.gain_stride;
  const int gain_stride = layout_.gain_stride;
  const double* gain = policy.gain + state_.ndx;
  const int nu = knot.nu;
  double saved = 0.0;
  for (int i = 0; i < nu; ++i) {
    policy.feedforward[i] = gain[i * gain_stride];
    saved += l[i * stride] * l[i * stride];
  }
  if (bounded) return;
  result.slope = -saved;
  result.curvature = saved;
}

RiccatiStep RiccatiRecursion::step(const RiccatiKnot& at, const RiccatiTerms& terms,
                                   const ThreadTeam& team) {
  RiccatiStep result;
  const KnotExpansion& e = at.expansion;
  const int controls = at.controls;
  const ControlBox& box = terms.box;
  const Knot knot(at, state_, team, own_[to_size(team.worker)]);
  const bool bounded = box.lower != nullptr && box.upper != nullptr && controls > 0;

  if (team.leads()) cross_gap(knot, at.gap, at.hessian_gap, result);
  load_cost(knot);
  if (terms.rows != nullptr) add_rows(knot, *terms.rows);
  if (e.form == DynamicsForm::SecondOrder) project_value(knot);
  add_to_controls(knot);
  for (int i = knot.columns.begin; i < std::min(controls, knot.columns.end); ++i)
    y_.data()[i * y_stride_ + i] += terms.regularization;
  if (team.leads()) add_gradient(knot, terms.rows != nullptr ? terms.rows->gradient : e.gradient);
  team.meet();
  if (bounded) {
    if (team.leads()) clamp(knot, box, at.policy.feedforward, result);
    team.meet();
  }
  add_to_states(knot);
  result.failed_control = factorize(knot, at.policy);
  if (result.failed_control >= 0) return result;
  team.meet();
  reduce(knot, at.value);
  if (team.leads()) conclude(knot, bounded, at.policy, result);
  team.meet();
  return result;
}

}  // namespace burnish

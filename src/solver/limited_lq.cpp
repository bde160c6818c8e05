#include "solver/limited_lq.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/to_size.hpp"
#include "solver/dense.hpp"
#include "solver/linear_dynamics.hpp"

namespace burnish {

using dense::Lane;
using dense::lanes;
using dense::load;
using dense::store;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

double largest_lane(const Lane& of) {
  double largest = of.lane(0);
  for (int l = 1; l < lanes; ++l) largest = std::max(largest, of.lane(l));
  return largest;
}

/// Returns the arguments of a recursion step at knot `k`.
RiccatiKnot riccati_knot(const LqHorizon& h, int k) {
  const auto i = to_size(k);
  const int next = (k + 1) * h.gap_stride;
  return {h.expansions[i], h.controls[i], h.gaps + next,        h.values[i + 1],
          h.policies[i],   h.values[i],   h.hessian_gaps + next};
}

}  // namespace

LimitedLq::LimitedLq(const StateShape& state, int knots, int max_controls, int max_rows)
    : state_(state),
      N_(knots),
      max_controls_(max_controls),
      max_rows_(max_rows),
      first_row_(dense::round_up(max_controls + state.ndx)),
      row_count_(first_row_ + dense::round_up(max_rows)),
      stride_(RiccatiLayout(state, max_controls).expansion_stride),
      row_stride_(dense::round_up(std::max(1, max_rows))),
      control_stride_(dense::round_up(std::max(1, max_controls))),
      velocity_stride_(dense::round_up(std::max(1, state.nv))),
      interior_(row_count_ * (knots + 1)) {
  const int nz = max_controls + state.ndx;
  const int padded = dense::round_up(nz);
  const int row_vectors = 15;
  const int of_knot = 3 * padded + row_vectors * row_count_ + control_stride_ * control_stride_ +
                      control_stride_ + padded * row_stride_ + padded * velocity_stride_ +
                      dense::round_up(state.ndx) * control_stride_;
  memory_ = Buffer(to_size(of_knot + 2 * lanes) * to_size(N_ + 1));
  double* next = memory_.data();
  const auto take = [&](int size) { return std::exchange(next, next + size); };
  for (int k = 0; k <= N_; ++k) {
    Knot knot;
    knot.z = take(padded);
    knot.z_before = take(padded);
    knot.z_kept = take(padded);
    for (double** row :
         {&knot.y, &knot.y_before, &knot.multiplier, &knot.multiplier_kept, &knot.piece_kept,
          &knot.lower, &knot.upper, &knot.scale, &knot.weight, &knot.l1_weight, &knot.beyond,
          &knot.slope, &knot.offset, &knot.piece, &knot.found})
      *row = take(row_count_);
    knot.factor = take(control_stride_ * control_stride_);
    knot.inverse_diagonal = take(control_stride_);
    knot.transposed_rows = take(padded * row_stride_);
    knot.transposed_dynamics = take(padded * velocity_stride_);
    knot.transposed_gain = take(dense::round_up(state.ndx) * control_stride_);
    take(lanes);  // Spare entries for reads past the end of a row
    knots_.push_back(knot);
  }
  chosen_ = Buffer(dense::block_size(std::max(1, max_rows), stride_));
  weighted_ = Buffer(dense::block_size(std::max(1, max_rows), stride_));
  gradient_ = Buffer(dense::block_size(2, stride_));
  scratch_ = Buffer(dense::block_size(4, stride_));
}

LimitedLq::Rows LimitedLq::rows(int knot) {
  const Knot& k = knot_at(knot);
  return {k.lower, k.upper, k.scale, k.weight, k.l1_weight, k.beyond, k.multiplier};
}

void LimitedLq::forget() noexcept {
  for (const Knot& k : knots_)
    for (double* of_rows : {k.multiplier, k.piece, k.found}) std::fill_n(of_rows, row_count_, 0.0);
}

void LimitedLq::shift(std::span<const int> controls) noexcept {
  for (int k = 0; k < N_; ++k) take_over(controls, k, k + 1);
}

void LimitedLq::shift(std::span<const int> controls, std::span<const int> from) noexcept {
  const int count = std::min(N_, static_cast<int>(from.size()));
  for (int k = 0; k < count; ++k) {
    const int source = std::clamp(from[to_size(k)], k, N_ - 1);
    if (source != k) take_over(controls, k, source);
  }
}

void LimitedLq::take_over(std::span<const int> controls, int knot, int source) noexcept {
  // Rows at knots with different numbers of controls have different indices.
  if (controls[to_size(knot)] != controls[to_size(source)]) return;
  const Knot &to = knot_at(knot), &from = knot_at(source);
  dense::copy(from.multiplier, row_count_, to.multiplier);
  dense::copy(from.piece, row_count_, to.piece);
  dense::copy(from.transposed_gain, state_.ndx * control_stride_, to.transposed_gain);
}

/// Transposes the dynamics and the rows with coefficients, so that follow_policy() computes whole
/// SIMD vectors of results.
void LimitedLq::transpose(const LqHorizon& h) {
  for (int k = 0; k <= N_; ++k) {
    const auto i = to_size(k);
    const KnotExpansion& e = h.expansions[i];
    const int nz = h.controls[i] + state_.ndx;
    const Knot& mine = knot_at(k);
    if (h.rows[i] > 0)
      dense::transpose_copy({e.rows, e.stride}, h.rows[i], nz, {mine.transposed_rows, row_stride_});
    if (k < N_ && e.form == DynamicsForm::SecondOrder)
      dense::transpose_copy({e.dynamics, e.stride}, state_.nv, nz,
                            {mine.transposed_dynamics, velocity_stride_});
  }
}

void LimitedLq::keep() {
  for (const Knot& k : knots_) {
    dense::copy(k.z, stride_, k.z_before);
    dense::copy(k.y, row_count_, k.y_before);
  }
}

void LimitedLq::row_values(const LqHorizon& h, int knot) {
  const auto i = to_size(knot);
  const Knot& mine = knot_at(knot);
  dense::copy(mine.z, h.controls[i] + state_.ndx, mine.y);
  if (h.rows[i] == 0) return;
  double* y = mine.y + first_row_;
  std::fill_n(y, row_stride_, 0.0);
  dense::add_row_times(mine.z, {mine.transposed_rows, row_stride_}, h.controls[i] + state_.ndx,
                       h.rows[i], y);
}

/// Computes z from the policies and the linear dynamics with gaps, then the values of the rows.
void LimitedLq::follow_policy(const LqHorizon& h) {
  const int ndx = state_.ndx;
  std::copy_n(h.gaps, ndx, knot_at(0).z + h.controls[0]);
  for (int k = 0; k <= N_; ++k) {
    const auto i = to_size(k);
    const int nu = h.controls[i];
    const Knot& mine = knot_at(k);
    if (k < N_ && nu > 0) {
      double* du = scratch_.data();
      std::copy_n(h.policies[i].feedforward, nu, du);
      dense::add_row_times(mine.z + nu, {mine.transposed_gain, control_stride_}, ndx, nu, du);
      std::copy_n(du, nu, mine.z);
    }
    row_values(h, k);
    if (k == N_) break;
    const KnotExpansion& e = h.expansions[i];
    double* next = knot_at(k + 1).z + h.controls[i + 1];
    if (e.form == DynamicsForm::SecondOrder) {
      double* dv = scratch_.data();
      std::fill_n(dv, velocity_stride_, 0.0);
      dense::add_row_times(mine.z, {mine.transposed_dynamics, velocity_stride_}, nu + ndx,
                           state_.nv, dv);
      std::copy_n(dv, state_.nv, next + state_.nv);
      complete_next(state_, e, nu, mine.z, scratch_.data(), next);
    } else {
      multiply(state_, e, nu, mine.z, scratch_.data(), next);
    }
    const double* gap = h.gaps + (k + 1) * h.gap_stride;
    for (int c = 0; c < ndx; ++c) next[c] += gap[c];
  }
}

int LimitedLq::vectors_end(const LqHorizon& h, int knot) const {
  const auto i = to_size(knot);
  return h.rows[i] > 0 ? first_row_ + h.rows[i] : h.controls[i] + state_.ndx;
}

/// Finds the linear piece (row_piece()) that contains each row's value. Returns the last knot with
/// a changed piece, or -1.
int LimitedLq::find_pieces(const LqHorizon& h) {
  int last = -1;
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    const RowArrays arrays = mine.arrays();
    Lane changed(0.0);
    for (int r = 0; r < vectors_end(h, k); r += lanes) {
      const Lane piece = row_piece(arrays, r, load(mine.y + r));
      store(mine.found + r, piece);
      changed += absolute(piece - load(mine.piece + r));
    }
    if (any(less(Lane(0.0), changed))) last = k;
  }
  return last;
}

void LimitedLq::keep_pieces() {
  for (Knot& k : knots_) std::swap(k.piece, k.found);
}

/// Sets the linear functions of the pieces, for the current multipliers.
void LimitedLq::take_pieces(const LqHorizon& h) {
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    const RowArrays arrays = mine.arrays();
    for (int r = 0; r < vectors_end(h, k); r += lanes) {
      const RowLines lines = row_lines(arrays, r, load(mine.piece + r));
      store(mine.slope + r, lines.slope);
      store(mine.offset + r, lines.offset);
    }
  }
}

/// Computes out = g + C^T offset, with the cost gradient g and the row coefficients C.
void LimitedLq::gradient(const LqHorizon& h, int knot, double* out) const {
  const auto i = to_size(knot);
  const KnotExpansion& e = h.expansions[i];
  const Knot& mine = knot_at(knot);
  const int nu = h.controls[i];
  dense::copy(e.gradient, nu + state_.ndx, out);
  for (int c = 0; c < nu + state_.ndx; ++c) out[c] += mine.offset[c];
  if (h.rows[i] > 0)
    dense::add_row_times(mine.offset + first_row_, {e.rows, e.stride}, h.rows[i], nu + state_.ndx,
                         out);
}

/// Collects the active rows of a knot.
WeightedRows LimitedLq::weigh(const LqHorizon& h, int knot) {
  const auto i = to_size(knot);
  const KnotExpansion& e = h.expansions[i];
  const Knot& mine = knot_at(knot);
  const int nz = h.controls[i] + state_.ndx;
  WeightedRows rows{chosen_.data(), weighted_.data(), stride_, 0, mine.slope, gradient_.data()};
  for (int r = 0; r < h.rows[i]; ++r) {
    const Lane weight(mine.slope[first_row_ + r]);
    if (mine.slope[first_row_ + r] == 0.0) continue;
    const double* from = e.rows + r * e.stride;
    double* chosen = chosen_.data() + rows.count * stride_;
    double* weighted = weighted_.data() + rows.count * stride_;
    for (int c = 0; c < nz; c += lanes) {
      const Lane entry = load(from + c);
      store(chosen + c, entry);
      store(weighted + c, weight * entry);
    }
    ++rows.count;
  }
  return rows;
}

/// Runs the recursion from knot `from` to the start; the results of later knots stay valid.
bool LimitedLq::factor(const LqHorizon& h, RiccatiRecursion& recursion, int from,
                       LimitedLqResult& result) {
  ++result.factorizations;
  for (int k = from; k >= 0; --k) {
    const auto i = to_size(k);
    gradient(h, k, gradient_.data());
    const WeightedRows rows = weigh(h, k);
    if (k == N_) {
      recursion.terminal(h.expansions[i], rows, h.values[i]);
      continue;
    }
    const int nu = h.controls[i];
    const RiccatiStep step =
        recursion.step(riccati_knot(h, k), {.regularization = h.regularization, .rows = &rows});
    if (step.failed_control >= 0) {
      result.failed_knot = k;
      result.failed_control = step.failed_control;
      return false;
    }
    const Knot& mine = knot_at(k);
    const dense::Factor factor = recursion.factor();
    for (int c = 0; c < nu; ++c)
      dense::copy(factor.r + c * factor.stride, nu, mine.factor + c * control_stride_);
    std::copy_n(factor.inverse_diagonal, nu, mine.inverse_diagonal);
    dense::transpose_copy({h.policies[i].gain, RiccatiLayout(state_, max_controls_).gain_stride},
                          nu, state_.ndx, {mine.transposed_gain, control_stride_});
  }
  return true;
}

/// Repeats the recursion for new multipliers, with the factors of the last factorization.
void LimitedLq::sweep(const LqHorizon& h, RiccatiRecursion& recursion) {
  for (int k = N_; k >= 0; --k) {
    const auto i = to_size(k);
    if (k == N_) {
      gradient(h, k, gradient_.data());
      std::copy_n(gradient_.data(), state_.ndx, h.values[i].gradient);
      continue;
    }
    const Knot& mine = knot_at(k);
    gradient(h, k, gradient_.data());
    recursion.resolve(riccati_knot(h, k), {mine.factor, control_stride_, mine.inverse_diagonal},
                      gradient_.data());
  }
}

/// Returns |next - multiplier| / (weight * scale) for a SIMD vector of rows; 0 for rows without
/// multipliers.
Lane LimitedLq::change_of(const Knot& mine, int r, const Lane& next) {
  const Lane weight = load(mine.weight + r), zero(0.0);
  const auto has_one = mask_and(less(zero, weight), less(zero, load(mine.l1_weight + r)));
  const Lane unit = select(has_one, weight * load(mine.scale + r), Lane(1.0));
  return select(has_one, absolute(next - load(mine.multiplier + r)) / unit, zero);
}

/// Updates the multipliers. Returns the largest change (see change_of()). A multiplier whose change
/// exceeds `jump_threshold` jumps to its L1 weight.
double LimitedLq::update_multipliers(const LqHorizon& h, double jump_threshold) {
  Lane largest(0.0);
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    for (int r = 0; r < vectors_end(h, k); r += lanes) {
      const Lane next = load(mine.slope + r) * load(mine.y + r) + load(mine.offset + r);
      const Lane change = change_of(mine, r, next);
      const Lane l1_weight = load(mine.l1_weight + r);
      const auto goes =
          mask_and(less(Lane(jump_threshold), change), less(l1_weight, Lane(infinite_l1_weight)));
      const Lane at_l1_weight = select(less(next, Lane(0.0)), -l1_weight, l1_weight);
      const auto has_one =
          mask_and(less(Lane(0.0), load(mine.weight + r)), less(Lane(0.0), l1_weight));
      store(mine.multiplier + r,
            select(has_one, select(goes, at_l1_weight, next), load(mine.multiplier + r)));
      largest = larger(largest, change);
    }
  }
  return largest_lane(largest);
}

/// Returns the largest change that update_multipliers() would return, without updating.
double LimitedLq::residual_left(const LqHorizon& h) const {
  Lane largest(0.0);
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    const RowArrays arrays = mine.arrays();
    for (int r = 0; r < vectors_end(h, k); r += lanes)
      largest = larger(largest, change_of(mine, r, row_force(arrays, r, load(mine.y + r))));
  }
  return largest_lane(largest);
}

/// Raises the weights of the active rows by a factor of 10, so that multipliers converge faster.
void LimitedLq::raise_weights(const LqHorizon& h) {
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    for (int r = 0; r < vectors_end(h, k); ++r)
      if (mine.piece[r] != 0.0 && mine.l1_weight[r] > 0.0) mine.weight[r] *= 10.0;
  }
}

/// Detects multipliers that keep growing. In this case, the weights are too small for rows that
/// barely move, or the rows cannot all be satisfied and the L1 weights decide.
class LimitedLq::GrowthWatch {
 public:
  enum class Cure { None, Weights, Interior, Jump };
  /// Returns the remedy to apply. Called after each step that left all rows on their pieces.
  Cure look(const LimitedLqResult& result) {
    constexpr int patience = 10, most_raises = 3;
    slow_ = result.sweeps > 0 && result.residual > 0.99 * residual_before_ ? slow_ + 1 : 0;
    residual_before_ = result.residual;
    if (slow_ < patience) return Cure::None;
    slow_ = 0;
    if (raises_++ < most_raises) return Cure::Weights;
    return raises_ == most_raises + 1 ? Cure::Interior : Cure::Jump;
  }
  void pieces_changed() { slow_ = 0; }

 private:
  double residual_before_ = std::numeric_limits<double>::infinity();
  int slow_ = 0, raises_ = 0;
};

/// Computes the first factorization. A cold start begins with the rows that are active at z = 0.
bool LimitedLq::begin(const LqHorizon& h, RiccatiRecursion& recursion, bool warm,
                      LimitedLqResult& result) {
  transpose(h);
  if (warm) {
    follow_policy(h);
    keep();
  } else {
    for (int k = 0; k <= N_; ++k) std::fill_n(knot_at(k).y, row_count_, 0.0);
    find_pieces(h);
    keep_pieces();
  }
  take_pieces(h);
  return factor(h, recursion, N_, result);
}

/// Updates the multipliers after a step that changed no piece, and computes new policies.
/// Returns false if the solve has ended.
bool LimitedLq::update(const LqHorizon& h, RiccatiRecursion& recursion,
                       const LimitedLqBudget& budget, GrowthWatch& growth, bool& whole,
                       LimitedLqResult& result) {
  using Cure = GrowthWatch::Cure;
  const Cure cure = growth.look(result);
  result.residual = update_multipliers(h, cure == Cure::Jump ? 0.5 * result.residual : no_limit);
  result.converged = result.residual <= budget.tolerance;
  if (result.converged || result.sweeps >= budget.sweeps) return false;
  if (cure == Cure::Interior && pays(budget, result)) return restart(h, recursion, whole, result);
  const bool heavier = cure == Cure::Weights && result.semismooth() < budget.factorizations;
  if (heavier) raise_weights(h);
  keep();
  take_pieces(h);
  if (heavier) return factor(h, recursion, N_, result);
  sweep(h, recursion);
  ++result.sweeps;
  return true;
}

LimitedLqResult LimitedLq::solve(const LqHorizon& h, RiccatiRecursion& recursion,
                                 const LimitedLqBudget& budget, bool warm) {
  LimitedLqResult result;
  GrowthWatch growth;
  bool approached = !warm && budget.interior_after == 0 && pays(budget, result);
  if (approached) transpose(h);
  const bool done = approached && approach(h, recursion, result);
  if (!(done ? factor_pieces(h, recursion, result) : begin(h, recursion, warm, result)))
    return result;
  bool whole = !warm;  // A cold start has no last trajectory for shorten()
  for (;;) {
    follow_policy(h);
    int from = find_pieces(h);
    if (from >= 0 && !whole) {
      shorten(h);
      from = find_pieces(h);
    }
    whole = false;
    if (from < 0) {
      if (!update(h, recursion, budget, growth, whole, result)) return result;
      continue;
    }
    if (result.semismooth() >= budget.factorizations) {
      cut_short(h, recursion, result);
      return result;
    }
    growth.pieces_changed();
    if (!approached && result.factorizations >= budget.interior_after && pays(budget, result)) {
      approached = true;
      if (!restart(h, recursion, whole, result)) return result;
      continue;
    }
    keep_pieces();
    keep();
    take_pieces(h);
    if (!factor(h, recursion, from, result)) return result;
  }
}

/// Ends a solve whose budget is used up. If the interior-point solution has a smaller residual,
/// takes this solution, with the policies of its pieces.
void LimitedLq::cut_short(const LqHorizon& h, RiccatiRecursion& recursion,
                          LimitedLqResult& result) {
  result.residual = residual_left(h);
  if (!result.approached || result.interior_residual >= result.residual) return;
  take_kept(h);
  result.residual = result.interior_residual;
  take_pieces(h);
  if (factor(h, recursion, N_, result)) return;
  result.failed_knot = result.failed_control = -1;
}

/// Returns whether the remaining budget is large enough for the interior-point method.
bool LimitedLq::pays(const LimitedLqBudget& budget, const LimitedLqResult& result) {
  return budget.factorizations - result.semismooth() >= min_interior_budget;
}

/// Takes pieces and multipliers from the interior-point method; `whole` is true if it converged. If
/// it did not converge, the current multipliers stay.
bool LimitedLq::restart(const LqHorizon& h, RiccatiRecursion& recursion, bool& whole,
                        LimitedLqResult& result) {
  whole = approach(h, recursion, result);
  if (!whole) {
    find_pieces(h);
    keep_pieces();
  }
  return factor_pieces(h, recursion, result);
}

/// Factorizes with the current pieces.
bool LimitedLq::factor_pieces(const LqHorizon& h, RiccatiRecursion& recursion,
                              LimitedLqResult& result) {
  keep();
  take_pieces(h);
  return factor(h, recursion, N_, result);
}

}  // namespace burnish

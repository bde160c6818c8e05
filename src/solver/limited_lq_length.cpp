// Step length of the linear-quadratic problem with limits: exact minimum along the step.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "solver/dense.hpp"
#include "solver/limited_lq.hpp"

namespace burnish {

using dense::Lane;
using dense::lanes;
using dense::load;
using dense::store;

/// Returns the derivative of the rows' cost with respect to the step length: the sum over the rows
/// of the gradient e (row_force.hpp) times the change of the row's value along the step. `length`
/// is 0 at the last trajectory and 1 at the current one.
double LimitedLq::force_along(const LqHorizon& h, double length) const {
  const Lane fraction(length);
  Lane sum(0.0);
  for (int k = 0; k <= N_; ++k) {
    const Knot& mine = knot_at(k);
    const RowArrays arrays = mine.arrays();
    for (int r = 0; r < vectors_end(h, k); r += lanes) {
      const Lane before = load(mine.y_before + r);
      const Lane change = load(mine.y + r) - before;
      sum += row_force(arrays, r, before + fraction * change) * change;
    }
  }
  double total = 0.0;
  for (int l = 0; l < lanes; ++l) total += sum.lane(l);
  return total;
}

/// Objective along a step of the recursion: slope at the start, and curvature of the cost alone.
struct LimitedLq::Line {
  double slope = 0.0, cost_curvature = 0.0;
};

/// Computes the objective along the step d = (du, dx). The current trajectory minimises the
/// quadratic objective of the pieces. With its Hessian H, the gains K and the factors R of Quu, the
/// slope of this quadratic objective at length 0 is
///   -d^T H d = -sum |R (du - K dx)|^2.
/// The true objective has another slope there, because some rows are on other pieces at length 0.
LimitedLq::Line LimitedLq::line(const LqHorizon& h) {
  double curvature = 0.0, of_rows = 0.0, elsewhere = 0.0;
  const int ndx = state_.ndx;
  double* dx = scratch_.data();
  double* off = dx + stride_;
  for (int k = 0; k <= N_; ++k) {
    const auto i = to_size(k);
    const int nu = h.controls[i];
    const Knot& mine = knot_at(k);
    if (nu > 0) {
      for (int c = 0; c < ndx; ++c) dx[c] = mine.z_before[nu + c] - mine.z[nu + c];
      std::fill_n(off, control_stride_, 0.0);
      dense::add_row_times(dx, {mine.transposed_gain, control_stride_}, ndx, nu, off);
      for (int c = 0; c < nu; ++c) off[c] = mine.z[c] - mine.z_before[c] + off[c];
      for (int c = 0; c < nu; ++c) {
        const double entry = dense::dot(mine.factor + c * control_stride_ + c, off + c, nu - c);
        curvature += entry * entry;
      }
    }
    for (int r = 0; r < vectors_end(h, k); ++r) {
      const double change = mine.y[r] - mine.y_before[r];
      of_rows += mine.slope[r] * change * change;
      elsewhere -= (mine.slope[r] * mine.y_before[r] + mine.offset[r]) * change;
    }
  }
  elsewhere += force_along(h, 0.0);
  return {elsewhere - curvature, curvature - of_rows};
}

/// Moves to the trajectory of least objective between the last and the current trajectory.
void LimitedLq::shorten(const LqHorizon& h) {
  const Line line = this->line(h);
  const double at_begin = force_along(h, 0.0);
  const auto slope = [&](double length) {
    return line.slope + length * line.cost_curvature + force_along(h, length) - at_begin;
  };
  double length = 1.0;
  if (!(line.slope < 0.0)) {
    length = 0.0;
  } else if (double above = slope(1.0); above > 1e-9 * -line.slope) {
    double low = 0.0, high = 1.0, below = line.slope;
    for (int i = 0; i < 30; ++i) {
      length = i % 3 == 2 ? 0.5 * (low + high) : low - below * (high - low) / (above - below);
      const double here = slope(length);
      if (std::abs(here) < 1e-6 * -line.slope) break;
      (here < 0.0 ? low : high) = length;
      (here < 0.0 ? below : above) = here;
    }
  } else {
    return;
  }
  blend(length);
}

/// Interpolates between the last trajectory (`length` 0) and the current one (`length` 1).
void LimitedLq::blend(double length) {
  const Lane fraction(length);
  for (const Knot& k : knots_) {
    for (int c = 0; c < stride_; c += lanes) {
      const Lane before = load(k.z_before + c);
      store(k.z + c, before + fraction * (load(k.z + c) - before));
    }
    for (int r = 0; r < row_count_; r += lanes) {
      const Lane before = load(k.y_before + r);
      store(k.y + r, before + fraction * (load(k.y + r) - before));
    }
  }
}

}  // namespace burnish

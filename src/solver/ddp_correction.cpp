// A second-order correction of a whole step that the merit refuses: dynamics and rows bend, and the
// trial says by how much. The linear-quadratic problem is solved once more with what the trial left
// of gaps and rows in place of their linear models, and its step is tried (Nocedal and Wright,
// Numerical Optimization (2006), section 15.6). Without it steps zigzag along limits that bend.
#include <algorithm>

#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::allocate_correction() {
  const auto places = static_cast<std::size_t>((N + 2) * value_stride);
  corrected_gaps = Buffer(places);
  kept_dxs = Buffer(places);
  kept_dus = Buffer(static_cast<std::size_t>((N + 1) * control_stride));
}

void DdpSolver::Impl::swap_step() {
  std::swap(dxs, kept_dxs);
  std::swap(dus, kept_dus);
}

/// The trial of a whole step has been refused, and the expansions are those of the iterate. Whether
/// the corrected one is taken; if not, the step is as it was.
bool DdpSolver::Impl::corrected_trial() {
  const int factors = limited_result.factors;
  if (factors >= options.limits.max_factors) return false;
  const int ndx_padded = (N + 1) * value_stride;
  for (int i = 0; i < ndx_padded; ++i)
    corrected_gaps.data()[i] = current.gaps.data()[i] + trial.gaps.data()[i];
  set_row_limits();
  set_row_weights();
  for_each_row([&](int k, int /*row*/, std::size_t i, double, double) {
    const LimitedLq::Rows& rows = row_views[static_cast<std::size_t>(k)];
    const int at = row_slots[i];
    const double bend = trial.rows[i] - current.rows[i] - limited->values(k)[at];
    rows.lower[at] -= bend;
    rows.upper[at] -= bend;
  });
  const Clock::time_point from = Clock::now();
  const bool solved =
      solve_limited_with(corrected_gaps.data(), options.limits.max_factors - factors);
  summary.seconds.backward += since(from);
  limited_result.factors += factors;
  if (!solved) {
    summary.knot = summary.control = -1;  // the step that there is goes on
    return false;
  }
  swap_step();
  take_limited_step();
  if (shooting_trial(1.0, false) && accept_limited(1.0)) return true;
  swap_step();
  point_policies();
  return false;
}

}  // namespace burnish

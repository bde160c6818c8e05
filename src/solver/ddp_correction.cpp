// Second-order correction of a whole step that the merit function rejects. The linear models of
// dynamics and rows have errors, which the trial measures. The linear-quadratic problem is solved
// once more with these errors added, and the corrected step is tried (Nocedal and Wright, Numerical
// Optimization (2006), section 15.6). Without the correction, steps zigzag along curved
// constraints.
#include <algorithm>

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::allocate_correction() {
  const auto places = to_size((N + 2) * value_stride);
  corrected_gaps = Buffer(places);
  kept_dxs = Buffer(places);
  kept_dus = Buffer(to_size((N + 1) * control_stride));
}

void DdpSolver::Impl::swap_step() {
  std::swap(dxs, kept_dxs);
  std::swap(dus, kept_dus);
}

/// Tries the corrected step after a rejected whole step. Returns whether the corrected step was
/// accepted; if not, restores the step. Requires that the expansions belong to the current iterate.
bool DdpSolver::Impl::corrected_trial() {
  const int factorizations = limited_result.factorizations;
  if (factorizations >= options.limits.max_factorizations) return false;
  const int ndx_padded = (N + 1) * value_stride;
  for (int i = 0; i < ndx_padded; ++i)
    corrected_gaps.data()[i] = current.gaps.data()[i] + trial.gaps.data()[i];
  set_row_limits();
  set_row_weights();
  for_each_row([&](int k, int /*row*/, std::size_t i, double, double) {
    const LimitedLq::Rows& rows = row_views[to_size(k)];
    const int at = row_slots[i];
    const double curvature = trial.rows[i] - current.rows[i] - limited->values(k)[at];
    rows.lower[at] -= curvature;
    rows.upper[at] -= curvature;
  });
  const Clock::time_point from = Clock::now();
  const bool solved =
      solve_limited_with(corrected_gaps.data(), options.limits.max_factorizations - factorizations);
  summary.seconds.backward += since(from);
  limited_result.factorizations += factorizations;
  if (!solved) {
    summary.knot = summary.control = -1;  // Not a failure: the uncorrected step remains in use
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

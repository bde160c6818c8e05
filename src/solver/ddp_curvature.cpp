// Curvature of constraint rows. The linear-quadratic problem of an iteration contains only the
// linearized rows. In the Hessian of the Lagrangian, the curvature of an active row is
//   multiplier * d2(row)/dz2,
// with the multiplier of the previous iteration, or zero in the first iteration. This curvature is
// added to the Hessian of the cost. Problems provide curvature with its sign (RowCurvature). Only
// positive contributions are added, so the Hessian stays as definite as it was.

#include "base/to_size.hpp"
#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::allocate_curvatures() {
  const int max_count = problem.max_curvatures();
  if (max_count == 0) return;
  const int stride = recursion.layout().expansion_stride;
  for (int k = 0; k <= N; ++k) {
    curvature_memory.emplace_back(to_size(max_count) * to_size(stride));
    expansions[to_size(k)].curvatures = curvature_memory.back().data();
  }
}

/// Returns the multiplier of a row, positive at the upper limit. For rows with a quadratic penalty
/// only, returns the derivative of the penalty.
double DdpSolver::Impl::multiplier_estimate(int knot, int row) const {
  const auto k = to_size(knot);
  const auto i = to_size(knot * rows_max + row);
  if (is_fixed(knot, row)) return 0.0;
  const bool hard = is_hard(row_l1_weights[i]);
  const bool quadratic_only = hard ? elastic.on : row_l1_weights[i] == 0.0;
  const double multiplier_size = quadratic_only ? 0.0 : row_views[k].multiplier[row_slots[i]];
  if (hard && !elastic.on) return multiplier_size;
  return multiplier_size + quadratic_weight_of(i) * signed_violation_of(current.rows[i],
                                                                        row_lowers[k][row],
                                                                        row_uppers[k][row]);
}

/// Adds the rows' curvature to the Hessians, unless a previous recursion has already done so.
void DdpSolver::Impl::add_curvatures() {
  if (has_curvature) return;
  has_curvature = true;
  // Weights of rows are relative to the curvature of the cost without constraint curvature.
  cost_unit = curvature_unit();
  if (!options.limits.curvature) return;
  for (int k = 0; k <= N; ++k) {
    const auto at = to_size(k);
    const KnotExpansion& e = expansions[at];
    const int nz = controls[at] + ndx;
    for (const RowCurvature& curvature : problem.row_curvatures(k)) {
      const double multiplier_size = curvature.sign * multiplier_estimate(k, curvature.row);
      if (!(multiplier_size > 0.0)) continue;
      for (int i = curvature.first; i < curvature.first + curvature.count; ++i) {
        const double* b = e.curvatures + i * e.stride;
        for (int r = 0; r < nz; ++r) {
          const double scaled = multiplier_size * b[r];
          if (scaled == 0.0) continue;
          for (int c = 0; c <= r; ++c) e.hessian[r * e.stride + c] += scaled * b[c];
        }
      }
    }
  }
}

}  // namespace burnish

// How rows with limits bend: the linear-quadratic problem of an iteration has their tangents only,
// and what a limit that pushes adds to the Hessian of the Lagrangian,
//   multiplier * d2(row)/dz2,
// goes into the cost's. The multiplier is the one of the iteration before, zero in the first one.
// Rows say what they know of their bend by its sign (RowBend), and it is added where it is
// positive: the Hessian stays as definite as it was.

#include "solver/ddp_impl.hpp"

namespace burnish {

void DdpSolver::Impl::allocate_bends() {
  const int most = problem.max_bends();
  if (most == 0) return;
  const int stride = recursion.layout().expansion_stride;
  for (int k = 0; k <= N; ++k) {
    bend_memory.emplace_back(static_cast<std::size_t>(most) * static_cast<std::size_t>(stride));
    expansions[static_cast<std::size_t>(k)].bends = bend_memory.back().data();
  }
}

/// What a row of a knot is pushed with, above zero by its upper limit: its multiplier, or where
/// violations cost squares alone what those push with.
double DdpSolver::Impl::push_of(int knot, int row) const {
  const auto k = static_cast<std::size_t>(knot);
  const auto i = static_cast<std::size_t>(knot * rows_max + row);
  if (is_fixed(knot, row)) return 0.0;
  const bool hard = is_hard(row_prices[i]);
  const bool squares_alone = hard ? elastic.on : row_prices[i] == 0.0;
  const double push = squares_alone ? 0.0 : row_views[k].multiplier[row_slots[i]];
  if (hard && !elastic.on) return push;
  return push +
         square_of(i) * signed_outside_of(current.rows[i], row_lowers[k][row], row_uppers[k][row]);
}

/// Once per expansion: the recursion may be repeated.
void DdpSolver::Impl::add_bends() {
  if (bent) return;
  bent = true;
  // Weights of limits are shares of what the cost bends by, and not of what they add themselves.
  cost_unit = curvature_unit();
  if (!options.limits.bends) return;
  for (int k = 0; k <= N; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const KnotExpansion& e = expansions[at];
    const int nz = controls[at] + ndx;
    for (const RowBend& bend : problem.row_bends(k)) {
      const double push = bend.sign * push_of(k, bend.row);
      if (!(push > 0.0)) continue;
      for (int i = bend.first; i < bend.first + bend.count; ++i) {
        const double* b = e.bends + i * e.stride;
        for (int r = 0; r < nz; ++r) {
          const double scaled = push * b[r];
          if (scaled == 0.0) continue;
          for (int c = 0; c <= r; ++c) e.hessian[r * e.stride + c] += scaled * b[c];
        }
      }
    }
  }
}

}  // namespace burnish

// Residuals of entries of the state and the control.
#pragma once

#include <algorithm>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

template <class S>
void StateDifference::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const int nv = tree->nv;
  difference_configuration(*tree, target, knot.q, r);
  for (int i = 0; i < nv; ++i) r[nv + i] = knot.v[i] - target[nq + i];
  for (int i = 0; i < beside; ++i) r[2 * nv + i] = knot.torque_state[i] - target[nq + nv + i];
  if (J == nullptr) return;
  J = std::fill_n(J, diagonal_rows.size(), S(1.0));
  for (const TangentBlock& block : tangent) {
    S by_target[36];
    difference_jacobians(block, r + block.first, by_target, J);
    J += block.size * block.size;
  }
}

template <class S>
void Selection::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const S* const from = source == Source::Q             ? knot.q
                        : source == Source::V           ? knot.v
                        : source == Source::TorqueState ? knot.torque_state
                                                        : knot.u;
  for (std::size_t i = 0; i < entries.size(); ++i) r[i] = from[entries[i]] - target[i];
  if (J != nullptr) std::fill_n(J, entries.size(), S(1.0));
}

template <class S>
void TorqueRate::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const S rate = by_step ? knot.per_second : S(per_second);
  for (std::size_t i = 0; i < entries.size(); ++i)
    r[i] = rate * (knot.u[entries[i]] - knot.torque_state[entries[i]]) - target[i];
  if (J == nullptr) return;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    J[2 * i] = rate;
    J[2 * i + 1] = -rate;
  }
}

}  // namespace burnish::ocp

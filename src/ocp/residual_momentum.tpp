// Residuals of the whole robot's centre of mass and momentum.
#pragma once

#include <algorithm>

#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

template <class S>
void ComError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const Vec3<S>& c = knot.momentum->com;
  r[0] = c.x - target[0];
  r[1] = c.y - target[1];
  r[2] = c.z - target[2];
  if (J != nullptr) std::copy_n(knot.momentum_derivatives->com_dq.data(), 3 * knot.layout->nv, J);
}

template <class S>
void SupportMargin::evaluate(const KnotState<S>& knot, const S* /*target*/, S* r, S* J) const {
  const Vec3<S>& c = knot.momentum->com;
  for (const Edge& edge : edges) *r++ = S(edge.x) * c.x + S(edge.y) * c.y - S(edge.offset);
  if (J == nullptr) return;
  const int nv = knot.layout->nv;
  const S* const by_q = knot.momentum_derivatives->com_dq.data();
  for (const Edge& edge : edges)
    for (int k = 0; k < nv; ++k) *J++ = S(edge.x) * by_q[k] + S(edge.y) * by_q[nv + k];
}

template <class S>
void MomentumError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const Force<S>& h = knot.momentum->centroidal;
  const S values[6] = {h.linear.x, h.linear.y, h.linear.z, h.angular.x, h.angular.y, h.angular.z};
  for (int i = 0; i < 6; ++i) r[i] = values[i] - target[i];
  if (J == nullptr) return;
  const int nv = knot.layout->nv;
  const MomentumDerivatives<S>& d = *knot.momentum_derivatives;
  for (int i = 0; i < 6; ++i) {
    std::copy_n(d.centroidal_dq.data() + i * nv, nv, J + i * 2 * nv);
    std::copy_n(d.centroidal_dv.data() + i * nv, nv, J + i * 2 * nv + nv);
  }
}

}  // namespace burnish::ocp

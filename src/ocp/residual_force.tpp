// Residuals of contact forces. Their Jacobians have all columns of z.
#pragma once

#include "contact/contact_kinematics.tpp"
#include "dynamics/columns.hpp"
#include "ocp/compiled_residual.hpp"

namespace burnish::ocp {

/// Even if lambda is constant, the wrench of the contact moves with the contact's own reference. In
/// another reference, its components therefore change with q; wrench_rate() is this rate.
template <class S>
void WrenchView::evaluate(const KnotState<S>& knot, S* w, S* J) const {
  const ConstrainedDynamics<S>& dynamics = *knot.dynamics;
  const CompiledContact& compiled = dynamics.set().contacts()[contact];
  const int first = dynamics.active().first_row[contact];
  const int rows = static_cast<int>(compiled.directions.size());
  ContactState<S> state = dynamics.contact_states[contact];
  set_contact_force(compiled, dynamics.lambda.data() + first, state);
  const ReferencePose<S> pose =
      reference ? reference->pose(knot) : ReferencePose<S>{state.axes, state.origin};
  store_column(in_reference(pose, state.force_world), w, 1);
  if (J == nullptr) return;

  S map[36];  // wrench of a unit force of each contact row
  ContactState<S> unit = state;
  for (int r = 0; r < rows; ++r) {
    S lambda[6];
    for (int i = 0; i < rows; ++i) lambda[i] = S(i == r ? 1.0 : 0.0);
    set_contact_force(compiled, lambda, unit);
    store_column(in_reference(pose, unit.force_world), map + r, 6);
  }
  const StateLayout& layout = *knot.layout;
  const int nz = layout.nz();
  for (int d = 0; d < 6; ++d)
    for (int c = 0; c < nz; ++c) {
      S sum(0.0);
      for (int r = 0; r < rows; ++r) sum += map[d * 6 + r] * knot.dlambda_dz[(first + r) * nz + c];
      J[d * nz + c] = sum;
    }
  for (const WrenchEntry& entry : entries)
    add_column(wrench_rate(compiled, pose, entry, state, dynamics.kinematics(), Force<S>::zero()),
               J + layout.column_q() + entry.v, nz);
  if (!compiled.has_friction) return;
  for (const ContactSupport& entry : compiled.support)
    add_column(
        wrench_rate_by_v(compiled, pose, entry, state, dynamics.kinematics(), Force<S>::zero()),
        J + layout.column_v() + entry.v, nz);
}

template <class S>
void OwnForceError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const int first = knot.dynamics->active().first_row[contact];
  for (int i = 0; i < rows; ++i) r[i] = knot.dynamics->lambda[first + i] - target[i];
  if (J == nullptr) return;
  const int nz = knot.layout->nz();
  std::copy_n(knot.dlambda_dz + first * nz, rows * nz, J);
}

template <class S>
void ForceRate::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  const int row = knot.dynamics->active().first_row[contact];
  const S* const lambda = knot.dynamics->lambda.data() + row;
  const S rate = knot.per_second;
  for (int i = 0; i < rows; ++i)
    r[i] = rate * (lambda[i] - knot.force_before[first + i]) - target[i];
  if (J == nullptr) return;
  const StateLayout& layout = *knot.layout;
  const int nz = layout.nz();
  for (int i = 0; i < rows * nz; ++i) J[i] = rate * knot.dlambda_dz[row * nz + i];
  for (int i = 0; i < rows; ++i) J[i * nz + layout.column_force() + first + i] -= rate;
}

template <class S>
void WrenchError::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  wrench.evaluate(knot, r, J);
  for (int i = 0; i < 6; ++i) r[i] -= target[i];
}

template <class S>
void ConeMargin::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J,
                          S* curvatures) const {
  S w[6];
  S* const dw = J == nullptr ? nullptr : knot.scratch;
  wrench.evaluate(knot, w, dw);
  const int t1 = (normal + 1) % 3, t2 = (normal + 2) % 3;
  const S smoothing(1e-6);  // (1e-3 N)^2, makes the length differentiable at zero
  const S length = square_root(S(w[t1] * w[t1] + w[t2] * w[t2] + smoothing));
  const S friction = target[0];
  r[0] = friction * w[normal] - length;
  r[1] = w[normal];
  if (J == nullptr) return;
  const int nz = knot.layout->nz();
  const S c1 = w[t1] / length, c2 = w[t2] / length;
  for (int c = 0; c < nz; ++c) {
    J[c] = friction * dw[normal * nz + c] - c1 * dw[t1 * nz + c] - c2 * dw[t2 * nz + c];
    J[nz + c] = dw[normal * nz + c];
  }
  if (curvatures == nullptr) return;
  // The length of the tangential force is curved perpendicular to the force. Its curvature along
  // the force comes only from the smoothing and is omitted.
  const S scale = S(1.0) / square_root(length);
  for (int c = 0; c < nz; ++c)
    curvatures[c] = scale * (c1 * dw[t2 * nz + c] - c2 * dw[t1 * nz + c]);
}

/// The largest pyramid of n sides inside the cone: its section is a polygon with corners on the
/// circle of radius friction * f_n. The distance of its sides from the centre is cos(pi / n) times
/// this radius. Source for four sides (friction / sqrt(2)): S. Caron, Q.-C. Pham and Y. Nakamura,
/// "Stability of surface contacts for humanoid robots", ICRA 2015, section II.
template <class S>
void PyramidMargin::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  S w[6];
  S* const dw = J == nullptr ? nullptr : knot.scratch;
  wrench.evaluate(knot, w, dw);
  const int t1 = (normal + 1) % 3, t2 = (normal + 2) % 3;
  const int nz = knot.layout->nz();
  const S slope = target[0] * S(inner);
  for (const Side& side : sides) {
    const S c(side.c), s(side.s);
    *r++ = slope * w[normal] - c * w[t1] - s * w[t2];
    if (J == nullptr) continue;
    for (int k = 0; k < nz; ++k)
      J[k] = slope * dw[normal * nz + k] - c * dw[t1 * nz + k] - s * dw[t2 * nz + k];
    J += nz;
  }
}

template <class S>
void PressureMargin::evaluate(const KnotState<S>& knot, const S* target, S* r, S* J) const {
  S w[6];
  S* const dw = J == nullptr ? nullptr : knot.scratch;
  wrench.evaluate(knot, w, dw);
  const S hx(half_x), hy(half_y);
  r[0] = hx * w[2] + w[4];
  r[1] = hx * w[2] - w[4];
  r[2] = hy * w[2] + w[3];
  r[3] = hy * w[2] - w[3];
  const int nz = knot.layout->nz();
  if (J != nullptr)
    for (int c = 0; c < nz; ++c) {
      const S fz = dw[2 * nz + c], mx = dw[3 * nz + c], my = dw[4 * nz + c];
      J[c] = hx * fz + my;
      J[nz + c] = hx * fz - my;
      J[2 * nz + c] = hy * fz + mx;
      J[3 * nz + c] = hy * fz - mx;
    }
  if (!has_friction) return;
  // Caron et al. 2015, equations 21 and 22. Each absolute value becomes two rows, one for each
  // sign.
  const S friction = target[0], about_middle = friction * (hx + hy);
  r += 4;
  if (J != nullptr) J += 4 * nz;
  for (const double side : {1.0, -1.0})
    for (const double by_x : {1.0, -1.0})
      for (const double by_y : {1.0, -1.0}) {
        const S fx(-by_x * half_y), fy(-by_y * half_x), mx = S(side * by_x) * friction,
                                                        my = S(side * by_y) * friction, mz(side);
        *r++ = fx * w[0] + fy * w[1] + about_middle * w[2] + mx * w[3] + my * w[4] + mz * w[5];
        if (J == nullptr) continue;
        for (int c = 0; c < nz; ++c)
          J[c] = fx * dw[c] + fy * dw[nz + c] + about_middle * dw[2 * nz + c] +
                 mx * dw[3 * nz + c] + my * dw[4 * nz + c] + mz * dw[5 * nz + c];
        J += nz;
      }
}

}  // namespace burnish::ocp

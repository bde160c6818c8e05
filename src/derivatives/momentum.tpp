// Definitions of momentum.hpp, for any scalar.
#pragma once

#include <algorithm>

#include "base/to_size.hpp"
#include "derivatives/momentum.hpp"
#include "dynamics/columns.hpp"
#include "dynamics/momentum.tpp"

namespace burnish {
template <class S>
MomentumDerivatives<S>::MomentumDerivatives(const Tree& tree) {
  const auto nv = to_size(tree.nv);
  for (auto* rows : {&com_dq, &com_velocity_dq}) rows->assign(3 * nv, S(0.0));
  for (auto* rows : {&total_dq, &total_dv, &centroidal_dq, &centroidal_dv})
    rows->assign(6 * nv, S(0.0));
  for (auto* row : {&kinetic_dq, &kinetic_dv, &potential_dq}) row->assign(nv, S(0.0));
}

namespace momentum_detail {

/// Writes the contribution of axis k to the column of its entry of v. Adds it if axes share
/// entries.
template <class S>
BURNISH_INLINE void put(const Tree& tree, const auto& column, int k, std::vector<S>& rows) {
  S* const out = rows.data() + tree.v_of_axis[k];
  if (tree.shares_entries())
    add_column(column, out, tree.nv);
  else
    store_column(column, out, tree.nv);
}
template <class S>
BURNISH_INLINE void put(const Tree& tree, const S& value, int k, std::vector<S>& row) {
  S& out = row[tree.v_of_axis[k]];
  out = tree.shares_entries() ? S(out + value) : value;
}

}  // namespace momentum_detail

template <class S>
void momentum_derivatives(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& m,
                          const S* v, MomentumDerivatives<S>& d) {
  using momentum_detail::put;
  const S inverse_mass(m.inverse_mass);
  const Vec3<S> gravity = lift<S>(tree.gravity);
  if (tree.shares_entries())
    for (auto* rows : {&d.com_dq, &d.com_velocity_dq, &d.total_dq, &d.total_dv, &d.centroidal_dq,
                       &d.centroidal_dv, &d.kinetic_dq, &d.kinetic_dv, &d.potential_dq})
      std::fill(rows->begin(), rows->end(), S(0.0));
  for (int k = 0; k < tree.axes; ++k) {
    const AxisState<S>& axis = kinematics.axes[k];
    const Inertia<S>& I = m.composite[tree.joint_of_axis[k]];
    const Force<S>& h = m.composite_momentum[tree.joint_of_axis[k]];
    const Force<S> by_v = I * axis.axis;
    const Force<S> by_q = cross(axis.axis, h) + I * axis.parent_rate;
    const Vec3<S> com_by_q = by_v.linear * inverse_mass;
    Force<S> centroidal_by_q = at_point(by_q, m.com);
    centroidal_by_q.angular -= cross(com_by_q, m.total.linear);
    put(tree, com_by_q, k, d.com_dq);
    put(tree, Vec3<S>(by_q.linear * inverse_mass), k, d.com_velocity_dq);
    put(tree, by_q, k, d.total_dq);
    put(tree, by_v, k, d.total_dv);
    put(tree, centroidal_by_q, k, d.centroidal_dq);
    put(tree, at_point(by_v, m.com), k, d.centroidal_dv);
    put(tree, S(dot(axis.parent_rate, h)), k, d.kinetic_dq);
    put(tree, S(dot(axis.axis, h) + S(tree.armature[k]) * v[tree.v_of_axis[k]]), k, d.kinetic_dv);
    put(tree, S(-dot(gravity, by_v.linear)), k, d.potential_dq);
  }
}

template <class S>
void gravity_torque(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& m,
                    S* out) {
  const Vec3<S> gravity = lift<S>(tree.gravity);
  std::fill_n(out, tree.nv, S(0.0));
  for (int k = 0; k < tree.axes; ++k) {
    const Force<S> by_v = m.composite[tree.joint_of_axis[k]] * kinematics.axes[k].axis;
    out[tree.v_of_axis[k]] -= dot(gravity, by_v.linear);
  }
}

}  // namespace burnish

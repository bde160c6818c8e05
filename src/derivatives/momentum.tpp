// Definitions of momentum.hpp, for any scalar.
#pragma once

#include "burnish/derivatives/momentum.hpp"
#include "dynamics/columns.hpp"
#include "dynamics/momentum.tpp"

namespace burnish {
template <class S>
MomentumDerivatives<S>::MomentumDerivatives(const Tree& tree) {
  const auto nv = static_cast<std::size_t>(tree.nv);
  for (auto* rows : {&com_dq, &com_velocity_dq}) rows->assign(3 * nv, S(0.0));
  for (auto* rows : {&total_dq, &total_dv, &centroidal_dq, &centroidal_dv})
    rows->assign(6 * nv, S(0.0));
  for (auto* row : {&kinetic_dq, &kinetic_dv, &potential_dq}) row->assign(nv, S(0.0));
}

template <class S>
void momentum_derivatives(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& m,
                          const S* v, MomentumDerivatives<S>& d) {
  const int n = tree.nv;
  const S inverse_mass(m.inverse_mass);
  const Vec3<S> gravity = lift<S>(tree.gravity);
  for (int k = 0; k < n; ++k) {
    const AxisState<S>& axis = kinematics.axes[k];
    const Inertia<S>& I = m.composite[tree.joint_of_v[k]];
    const Force<S>& h = m.composite_momentum[tree.joint_of_v[k]];
    const Force<S> by_v = I * axis.axis;
    const Force<S> by_q = cross(axis.axis, h) + I * axis.parent_rate;
    const Vec3<S> com_by_q = by_v.linear * inverse_mass;
    Force<S> centroidal_by_q = at_point(by_q, m.com);
    centroidal_by_q.angular -= cross(com_by_q, m.total.linear);
    store_column(com_by_q, &d.com_dq[k], n);
    store_column(by_q.linear * inverse_mass, &d.com_velocity_dq[k], n);
    store_column(by_q, &d.total_dq[k], n);
    store_column(by_v, &d.total_dv[k], n);
    store_column(centroidal_by_q, &d.centroidal_dq[k], n);
    store_column(at_point(by_v, m.com), &d.centroidal_dv[k], n);
    d.kinetic_dq[k] = dot(axis.parent_rate, h);
    d.kinetic_dv[k] = dot(axis.axis, h) + S(tree.armature[k]) * v[k];
    d.potential_dq[k] = -dot(gravity, by_v.linear);
  }
}

template <class S>
void gravity_torque(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& m,
                    S* out) {
  const Vec3<S> gravity = lift<S>(tree.gravity);
  for (int k = 0; k < tree.nv; ++k) {
    const Force<S> by_v = m.composite[tree.joint_of_v[k]] * kinematics.axes[k].axis;
    out[k] = -dot(gravity, by_v.linear);
  }
}

}  // namespace burnish

// Definitions of inverse_dynamics.hpp, for any scalar.
#pragma once

#include "derivatives/inverse_dynamics.hpp"
#include "dynamics/add_up.hpp"

namespace burnish {

template <class S>
void inverse_dynamics_derivatives(const Tree& tree, const Kinematics<S>& kinematics,
                                  const MassMatrix<S>& mass, InverseDynamics<S>& id, S* dtau_dq,
                                  S* dtau_dv) {
  const int n = tree.axes;
  const auto& parent = tree.parent_of_axis;
  S* const dq = tree.shares_entries() ? id.dq_by_axis.data() : dtau_dq;
  S* const dv = tree.shares_entries() ? id.dv_by_axis.data() : dtau_dv;
  const S two(2.0);
  for (int i = 0; i < tree.bodies(); ++i) {
    const BodyState<S>& body = kinematics.bodies[i];
    id.coriolis[i] = coriolis(body.inertia, body.v, body.momentum.linear);
  }
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const TreeJoint& joint = tree.joints[i];
    const Inertia<S>& I = mass.composite[i];
    const Coriolis<S> B = id.coriolis[i];
    const Force<S> f = id.force[i] + mass.composite_bias[i];
    for (int k = joint.axis; k < joint.axis + joint.nv; ++k) {
      const AxisState<S>& axis = kinematics.axes[k];
      const Motion<S>& psi_ddot = id.axis_acc[k];
      // Entry (j, k), for axes j above k: dtau/dq is S_j . (I psi''_k + 2 B psi'_k [+ S_k x* f]),
      // dtau/dv is S_j . (I (psi'_k + S'_k) + 2 B S_k). Entry (k, j): the formulas with j and k
      // exchanged, without S_k x* f.
      Force<S> by_q = B * (axis.parent_rate * two) + I * psi_ddot;
      const Force<S> by_v = B * (axis.axis * two) + I * axis.rate_sum;
      const Force<S> momentum = I * axis.axis;
      const Vec3<S> turning = B.transpose_times_angular(axis.axis) * two;
      const auto pair = [&](int j) {
        const AxisState<S>& above = kinematics.axes[j];
        dq[j * n + k] = dot(above.axis, by_q);
        dv[j * n + k] = dot(above.axis, by_v);
        if (j == k) return;
        dq[k * n + j] = dot(turning, above.parent_rate.angular) + dot(id.axis_acc[j], momentum);
        dv[k * n + j] = dot(turning, above.axis.angular) + dot(above.rate_sum, momentum);
      };
      int j = k;
      // A motion of one entry of a joint turns the joint's other axes together with the force. For
      // pairs of entries of one joint, S_k x* f therefore does not apply.
      for (; j >= joint.axis; j = parent[j]) pair(j);
      by_q += cross(axis.axis, f);
      for (; j >= 0; j = parent[j]) pair(j);
    }
    if (joint.parent >= 0) {
      id.coriolis[joint.parent] += B;
      id.force[joint.parent] += id.force[i];
    }
  }
  if (!tree.shares_entries()) return;
  add_up_square(tree, dq, dtau_dq);
  add_up_square(tree, dv, dtau_dv);
}

}  // namespace burnish

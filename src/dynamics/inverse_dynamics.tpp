// Definitions of the templates in inverse_dynamics.hpp.
#pragma once

#include "base/to_size.hpp"
#include "dynamics/add_up.hpp"
#include "dynamics/inverse_dynamics.hpp"

namespace burnish {

template <class S>
InverseDynamics<S>::InverseDynamics(const Tree& tree)
    : a_joint(tree.joints.size()),
      axis_acc(to_size(tree.axes) + tree.sums.size()),
      force(tree.joints.size()),
      tau(to_size(tree.nv), S(0.0)),
      coriolis(tree.joints.size()) {
  if (!tree.shares_entries()) return;
  tau_by_axis.assign(to_size(tree.axes), S(0.0));
  for (auto* matrix : {&dq_by_axis, &dv_by_axis})
    matrix->assign(to_size(tree.axes * tree.axes), S(0.0));
}

template <class S>
void accelerate(const Tree& tree, const Kinematics<S>& kinematics, const S* qdd,
                InverseDynamics<S>& id) {
  const Motion<S> minus_gravity{-lift<S>(tree.gravity), Vec3<S>::zero()};
  for (int i = 0; i < tree.bodies(); ++i) {
    const TreeJoint& joint = tree.joints[i];
    const BodyState<S>& body = kinematics.bodies[i];
    const bool at_root = joint.parent < 0;
    const Motion<S> a_parent =
        at_root ? minus_gravity : kinematics.bodies[joint.parent].a_bias + id.a_joint[joint.parent];
    Motion<S> sum = at_root ? Motion<S>::zero() : id.a_joint[joint.parent];
    const S* const own_qdd = qdd + joint.v;
    for (int e = 0; e < joint.nv; ++e) {
      const int k = joint.axis + e;
      const AxisState<S>& axis = kinematics.axes[k];
      id.axis_acc[k] = cross(a_parent, axis.axis);
      if (!at_root) id.axis_acc[k] += cross(kinematics.bodies[joint.parent].v, axis.parent_rate);
      sum += axis.axis * own_qdd[e];
    }
    id.a_joint[i] = sum;
    id.force[i] = body.inertia * sum;
  }
  for (std::size_t i = 0; i < tree.sums.size(); ++i)
    id.axis_acc[tree.axes + i] = id.axis_acc[tree.sums[i].own] + id.axis_acc[tree.sums[i].above];
}

template <class S>
void inverse_dynamics_sweep(const Tree& tree, const Kinematics<S>& kinematics,
                            const MassMatrix<S>& mass, const S* qdd, InverseDynamics<S>& id) {
  S* const tau = tree.shares_entries() ? id.tau_by_axis.data() : id.tau.data();
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const TreeJoint& joint = tree.joints[i];
    const Force<S> total = id.force[i] + mass.composite_bias[i];
    const S* const own_qdd = qdd + joint.v;
    for (int e = 0; e < joint.nv; ++e) {
      const int k = joint.axis + e;
      tau[k] = dot(kinematics.axes[k].axis, total) + S(tree.armature[k]) * own_qdd[e];
    }
    if (joint.parent >= 0) id.force[joint.parent] += id.force[i];
  }
  if (tree.shares_entries()) add_up(tree, tau, id.tau.data());
}

}  // namespace burnish

// Definitions of inverse_dynamics.hpp, for any scalar.
#pragma once

#include "burnish/dynamics/inverse_dynamics.hpp"

namespace burnish {

template <class S>
InverseDynamics<S>::InverseDynamics(const Tree& tree)
    : a_joint(tree.joints.size()),
      axis_acc(static_cast<std::size_t>(tree.nv)),
      force(tree.joints.size()),
      tau(static_cast<std::size_t>(tree.nv), S(0.0)) {}

template <class S>
void accelerate(const Tree& tree, const Kinematics<S>& kinematics, const S* qdd,
                InverseDynamics<S>& id) {
  const Motion<S> minus_gravity{-lift<S>(tree.gravity), Vec3<S>::zero()};
  for (int i = 0; i < tree.bodies(); ++i) {
    const TreeJoint& joint = tree.joints[i];
    const BodyState<S>& body = kinematics.bodies[i];
    const bool rooted = joint.parent < 0;
    const Motion<S> a_parent =
        rooted ? minus_gravity : kinematics.bodies[joint.parent].a_bias + id.a_joint[joint.parent];
    Motion<S> sum = rooted ? Motion<S>::zero() : id.a_joint[joint.parent];
    for (int k = joint.v; k < joint.v + joint.nv; ++k) {
      const AxisState<S>& axis = kinematics.axes[k];
      id.axis_acc[k] = cross(a_parent, axis.axis);
      if (!rooted) id.axis_acc[k] += cross(kinematics.bodies[joint.parent].v, axis.parent_rate);
      sum += axis.axis * qdd[k];
    }
    id.a_joint[i] = sum;
    id.force[i] = body.inertia * sum;
  }
}

template <class S>
void inverse_dynamics_sweep(const Tree& tree, const Kinematics<S>& kinematics,
                            const MassMatrix<S>& mass, const S* qdd, InverseDynamics<S>& id) {
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const TreeJoint& joint = tree.joints[i];
    const Force<S> total = id.force[i] + mass.composite_bias[i];
    for (int k = joint.v; k < joint.v + joint.nv; ++k)
      id.tau[k] = dot(kinematics.axes[k].axis, total) + S(tree.armature[k]) * qdd[k];
    if (joint.parent >= 0) id.force[joint.parent] += id.force[i];
  }
}

}  // namespace burnish

// Definitions of the templates in momentum.hpp.
#pragma once

#include "dynamics/momentum.hpp"

namespace burnish {

template <class S>
Momentum<S>::Momentum(const Tree& tree)
    : composite(tree.joints.size()), composite_momentum(tree.joints.size()) {
  set_mass(tree);
}

template <class S>
void Momentum<S>::set_mass(const Tree& tree) {
  mass = 0.0;
  for (const TreeJoint& joint : tree.joints) mass += joint.mass;
  inverse_mass = mass > 0.0 ? 1.0 / mass : 0.0;
}

template <class S>
void update_momentum(const Tree& tree, const Kinematics<S>& kinematics, const S* v,
                     Momentum<S>& m) {
  m.kinetic = S(0.0);
  for (int i = 0; i < tree.bodies(); ++i) {
    const BodyState<S>& body = kinematics.bodies[i];
    m.composite[i] = body.inertia;
    m.composite_momentum[i] = body.momentum;
    m.kinetic += dot(body.v, body.momentum);
  }
  for (int k = 0; k < tree.axes; ++k) {
    const S& rate = v[tree.v_of_axis[k]];
    m.kinetic += S(tree.armature[k]) * rate * rate;
  }
  m.kinetic = m.kinetic * S(0.5);
  m.first_moment = Vec3<S>::zero();
  m.total = Force<S>::zero();
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const int parent = tree.joints[i].parent;
    if (parent >= 0) {
      m.composite[parent] += m.composite[i];
      m.composite_momentum[parent] += m.composite_momentum[i];
    } else {
      m.first_moment += m.composite[i].moment;
      m.total += m.composite_momentum[i];
    }
  }
  const S inverse_mass(m.inverse_mass);
  m.com = m.first_moment * inverse_mass;
  m.com_velocity = m.total.linear * inverse_mass;
  m.centroidal = at_point(m.total, m.com);
  m.potential = -dot(lift<S>(tree.gravity), m.first_moment);
}

}  // namespace burnish

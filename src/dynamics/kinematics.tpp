// Definitions of the templates in kinematics.hpp.
#pragma once

#include "dynamics/kinematics.hpp"

namespace burnish {
namespace kinematics_detail {

/// Returns Rp turned about its z axis by the angle with sine s and cosine c.
template <class S>
BURNISH_INLINE Mat3<S> turned_about_z(const Mat3<S>& Rp, const S& s, const S& c) {
  return {Rp.c0 * c + Rp.c1 * s, Rp.c1 * c - Rp.c0 * s, Rp.c2};
}

template <class S>
BURNISH_INLINE Mat3<S> quaternion_matrix(const S& x, const S& y, const S& z, const S& w) {
  const S two(2.0), one(1.0);
  return {{one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
          {two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)},
          {two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)}};
}

template <class S>
BURNISH_INLINE Motion<S> rotation_axis(const Vec3<S>& p, const Vec3<S>& direction) {
  return {cross(p, direction), direction};
}
template <class S>
BURNISH_INLINE Motion<S> translation_axis(const Vec3<S>& direction) {
  return {direction, Vec3<S>::zero()};
}

/// Computes the placement of a body and the axes S_k of its joint.
template <class S>
BURNISH_INLINE void place(const TreeJoint& joint, const BodyState<S>* parent, const S* q,
                          BodyState<S>& body, AxisState<S>* axes) {
  Mat3<S> Rj = lift<S>(joint.R);
  Vec3<S> pj = lift<S>(joint.p);
  if (parent != nullptr) {
    pj = parent->p + parent->R * pj;
    Rj = parent->R * Rj;
  }
  switch (joint.kind) {
    case JointKind::Revolute: {
      S s, c;
      sine_cosine(q[0], s, c);
      body.R = turned_about_z(Rj, s, c);
      body.p = pj;
      axes[0].axis = rotation_axis(pj, Rj.c2);
      break;
    }
    case JointKind::Continuous:
      body.R = turned_about_z(Rj, q[1], q[0]);
      body.p = pj;
      axes[0].axis = rotation_axis(pj, Rj.c2);
      break;
    case JointKind::Prismatic:
      body.R = Rj;
      body.p = pj + Rj.c2 * q[0];
      axes[0].axis = translation_axis(Rj.c2);
      break;
    case JointKind::Planar:
      body.R = turned_about_z(Rj, q[3], q[2]);
      body.p = pj + Rj.c0 * q[0] + Rj.c1 * q[1];
      axes[0].axis = translation_axis(body.R.c0);
      axes[1].axis = translation_axis(body.R.c1);
      axes[2].axis = rotation_axis(body.p, Rj.c2);
      break;
    case JointKind::FreeFlyer:
      body.R = Rj * quaternion_matrix(q[3], q[4], q[5], q[6]);
      body.p = pj + Rj * Vec3<S>{q[0], q[1], q[2]};
      for (int k = 0; k < 3; ++k) {
        axes[k].axis = translation_axis(column(body.R, k));
        axes[3 + k].axis = rotation_axis(body.p, column(body.R, k));
      }
      break;
    case JointKind::Ball:
      body.R = Rj * quaternion_matrix(q[0], q[1], q[2], q[3]);
      body.p = pj;
      for (int k = 0; k < 3; ++k) axes[k].axis = rotation_axis(pj, column(body.R, k));
      break;
  }
}

/// Inertia of the body about the world's origin.
template <class S>
BURNISH_INLINE Inertia<S> world_inertia(const TreeJoint& joint, const BodyState<S>& body) {
  const Mat3<S>& R = body.R;
  const Sym3<double>& I = joint.inertia;
  const Vec3<S> c = body.p + R * lift<S>(joint.com);
  const Vec3<S> mc = c * S(joint.mass);
  const Vec3<S> t0 = R.c0 * S(I.xx) + R.c1 * S(I.xy) + R.c2 * S(I.xz);
  const Vec3<S> t1 = R.c0 * S(I.xy) + R.c1 * S(I.yy) + R.c2 * S(I.yz);
  const Vec3<S> t2 = R.c0 * S(I.xz) + R.c1 * S(I.yz) + R.c2 * S(I.zz);
  const S xx = mc.x * c.x, yy = mc.y * c.y, zz = mc.z * c.z;
  Inertia<S> r;
  r.mass = S(joint.mass);
  r.moment = mc;
  r.second.xx = t0.x * R.c0.x + t1.x * R.c1.x + t2.x * R.c2.x + yy + zz;
  r.second.xy = t0.x * R.c0.y + t1.x * R.c1.y + t2.x * R.c2.y - mc.x * c.y;
  r.second.xz = t0.x * R.c0.z + t1.x * R.c1.z + t2.x * R.c2.z - mc.x * c.z;
  r.second.yy = t0.y * R.c0.y + t1.y * R.c1.y + t2.y * R.c2.y + xx + zz;
  r.second.yz = t0.y * R.c0.z + t1.y * R.c1.z + t2.y * R.c2.z - mc.y * c.z;
  r.second.zz = t0.z * R.c0.z + t1.z * R.c1.z + t2.z * R.c2.z + xx + yy;
  return r;
}

/// Computes the twist and the bias acceleration of a body, and the rates of its axes.
template <class S>
BURNISH_INLINE void move(const TreeJoint& joint, const Motion<S>& v_parent,
                         const Motion<S>& a_parent, const S* v, BodyState<S>& body,
                         AxisState<S>* axes) {
  body.v = v_parent;
  body.a_bias = a_parent;
  for (int k = 0; k < joint.nv; ++k) {
    axes[k].parent_rate = cross(v_parent, axes[k].axis);
    body.v += axes[k].axis * v[k];
  }
  if (joint.nv == 1) {
    // S x S = 0, so the rate v x S is equal for the twists v of the parent and of the body.
    axes[0].rate_sum = axes[0].parent_rate + axes[0].parent_rate;
    body.a_bias += axes[0].parent_rate * v[0];
    return;
  }
  for (int k = 0; k < joint.nv; ++k) {
    const Motion<S> rate = cross(body.v, axes[k].axis);
    axes[k].rate_sum = axes[k].parent_rate + rate;
    body.a_bias += rate * v[k];
  }
}

/// Computes the coordinates of a follower whose leader is at q. For Continuous joints, multiplying
/// the angle means raising the complex number (cos, sin) to a power.
template <class S>
void follow(const TreeFollower& follower, JointKind kind, const S* q, S* own) {
  if (kind != JointKind::Continuous) {
    own[0] = S(follower.multiplier) * q[0] + S(follower.offset);
    return;
  }
  const bool back = follower.multiplier < 0.0;
  own[0] = S(follower.cosine);
  own[1] = S(follower.sine);
  S c = q[0], s = back ? S(-q[1]) : q[1];
  for (auto power = static_cast<long>(back ? -follower.multiplier : follower.multiplier); power > 0;
       power /= 2) {
    if (power % 2 == 1) {
      const S x = own[0] * c - own[1] * s;
      own[1] = own[1] * c + own[0] * s;
      own[0] = x;
    }
    const S cosine = c * c - s * s;
    s = S(2.0) * c * s;
    c = cosine;
  }
}

/// Computes the placement of a follower's body, and the axis scaled by the multiplier.
template <class S>
void place_follower(const TreeFollower& follower, const TreeJoint& joint,
                    const BodyState<S>* parent, const S* q, BodyState<S>& body,
                    AxisState<S>* axes) {
  S own[2];
  follow(follower, joint.kind, q, own);
  place(joint, parent, own, body, axes);
  axes[0].axis = axes[0].axis * S(follower.multiplier);
}

}  // namespace kinematics_detail

template <class S>
void update_kinematics(const Tree& tree, const S* q, const S* v, Kinematics<S>& kinematics) {
  using namespace kinematics_detail;
  const Motion<S> at_rest = Motion<S>::zero();
  const Motion<S> minus_gravity{-lift<S>(tree.gravity), Vec3<S>::zero()};
  for (int i = 0; i < tree.bodies(); ++i) {
    const TreeJoint& joint = tree.joints[i];
    BodyState<S>& body = kinematics.bodies[i];
    AxisState<S>* axes = &kinematics.axes[joint.axis];
    const BodyState<S>* parent = joint.parent < 0 ? nullptr : &kinematics.bodies[joint.parent];
    if (joint.follower < 0)
      place(joint, parent, q + joint.q, body, axes);
    else
      place_follower(tree.followers[joint.follower], joint, parent, q + joint.q, body, axes);
    move(joint, parent == nullptr ? at_rest : parent->v,
         parent == nullptr ? minus_gravity : parent->a_bias, v + joint.v, body, axes);
    body.inertia = world_inertia(joint, body);
    body.momentum = body.inertia * body.v;
    body.force_bias = body.inertia * body.a_bias + cross(body.v, body.momentum);
  }
  for (std::size_t i = 0; i < tree.sums.size(); ++i) {
    const AxisState<S>& own = kinematics.axes[tree.sums[i].own];
    const AxisState<S>& above = kinematics.axes[tree.sums[i].above];
    kinematics.axes[tree.axes + i] = {own.axis + above.axis, own.parent_rate + above.parent_rate,
                                      own.rate_sum + above.rate_sum};
  }
}

}  // namespace burnish

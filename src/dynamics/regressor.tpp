// Definitions of the templates in regressor.hpp.
#pragma once

#include "dynamics/inverse_dynamics.tpp"
#include "dynamics/regressor.hpp"

namespace burnish {
namespace regressor_detail {

/// Motion of a body, in body axes at its origin.
template <class S>
struct BodyMotion {
  Vec3<S> v;      ///< Angular velocity [rad/s]
  Vec3<S> turn;   ///< Angular acceleration [rad/s^2]
  Vec3<S> accel;  ///< Classical acceleration of the origin minus gravity [m/s^2]
};

template <class S>
BodyMotion<S> motion_of(const BodyState<S>& body, const Motion<S>& a_joint) {
  const Motion<S> v = at_point(body.v, body.p);
  const Motion<S> a = at_point(body.a_bias + a_joint, body.p);
  return {transpose_times(body.R, v.angular), transpose_times(body.R, a.angular),
          transpose_times(body.R, Vec3<S>(a.linear + cross(v.angular, v.linear)))};
}

/// Adds to `out` the products of the axis with the ten columns of the body's force. The columns for
/// the mass, for the first moments (j = x, y, z) and for the moments of inertia (i = 1 ... 6) are
///   [ accel   turn x e_j + w x (w x e_j)   0                          ]
///   [ 0       e_j x accel                  E_i turn + w x (E_i w)     ],
/// with force above moment. E_i are the symmetric unit matrices.
template <class S>
void add_row(const Motion<S>& axis, const BodyMotion<S>& m, S* out) {
  const Vec3<S>&l = axis.linear, &r = axis.angular, &w = m.v, &t = m.turn;
  out[0] += dot(l, m.accel);
  // For a unit vector e: l . (t x e + w x (w x e)) + r . (e x accel)
  //   = e . (l x t + (w . l) w - (w . w) l + accel x r).
  const Vec3<S> first = cross(l, t) + w * dot(w, l) - l * dot(w, w) + cross(m.accel, r);
  out[1] += first.x;
  out[2] += first.y;
  out[3] += first.z;
  // For a symmetric unit matrix E: r . (E t + w x (E w)) = r . E t + (r x w) . E w.
  const Vec3<S> s = cross(r, w);
  out[4] += r.x * t.x + s.x * w.x;
  out[5] += r.x * t.y + r.y * t.x + s.x * w.y + s.y * w.x;
  out[6] += r.x * t.z + r.z * t.x + s.x * w.z + s.z * w.x;
  out[7] += r.y * t.y + s.y * w.y;
  out[8] += r.y * t.z + r.z * t.y + s.y * w.z + s.z * w.y;
  out[9] += r.z * t.z + s.z * w.z;
}

}  // namespace regressor_detail

template <class S>
void body_regressor(const Tree& tree, const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                    int body, S* out, int stride) {
  const BodyState<S>& state = kinematics.bodies[body];
  const auto motion = regressor_detail::motion_of(state, id.a_joint[body]);
  const TreeJoint& joint = tree.joints[body];
  for (int k = joint.axis + joint.nv - 1; k >= 0; k = tree.parent_of_axis[k]) {
    const Motion<S> at_body = at_point(kinematics.axes[k].axis, state.p);
    const Motion<S> axis{transpose_times(state.R, at_body.linear),
                         transpose_times(state.R, at_body.angular)};
    regressor_detail::add_row(axis, motion, out + tree.v_of_axis[k] * stride);
  }
}

}  // namespace burnish

// Definitions of the templates in integration.hpp.
#pragma once

#include "dynamics/integration.hpp"
#include "dynamics/joint_twist.hpp"
#include "math/exponential.hpp"
#include "math/logarithm.hpp"

namespace burnish {
namespace integration_detail {

/// Returns the vector v turned by a unit quaternion.
template <class S>
BURNISH_INLINE Vec3<S> turned(const Quaternion<S>& by, const Vec3<S>& v) {
  const Vec3<S> twice = cross(by.vector, v) * S(2.0);
  return v + twice * by.w + cross(by.vector, twice);
}

template <class S>
BURNISH_INLINE Quaternion<S> conjugate(const Quaternion<S>& a) {
  return {-a.vector, a.w};
}

template <class S>
BURNISH_INLINE Quaternion<S> operator*(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {b.vector * a.w + a.vector * b.w + cross(a.vector, b.vector),
          a.w * b.w - dot(a.vector, b.vector)};
}

template <class S>
BURNISH_INLINE Quaternion<S> load_quaternion(const S* q) {
  return {{q[0], q[1], q[2]}, q[3]};
}

/// Multiplies the unit pair (cos, sin) by (c, s) as complex numbers, in place, and normalizes it.
template <class S>
BURNISH_INLINE void turn_pair(const S& c, const S& s, S* pair) {
  const S x = pair[0] * c - pair[1] * s, y = pair[1] * c + pair[0] * s;
  const S scale = S(1.0) / square_root(S(x * x + y * y));
  pair[0] = x * scale;
  pair[1] = y * scale;
}

template <class S>
BURNISH_INLINE void integrate_planar(const S* dq, S* q) {
  const S& w = dq[2];
  const Vec3<S> turn{S(0.0), S(0.0), w};
  const Vec3<S> moved =
      exp_position(exp_coefficients(absolute(w)), turn, Vec3<S>{dq[0], dq[1], S(0.0)});
  q[0] += q[2] * moved.x - q[3] * moved.y;
  q[1] += q[3] * moved.x + q[2] * moved.y;
  S s, c;
  sine_cosine(w, s, c);
  turn_pair(c, s, q + 2);
}

/// Turns the unit quaternion q (x, y, z, w) by the rotation vector w of length theta, in place.
template <class S>
BURNISH_INLINE void turn_quaternion(const Vec3<S>& w, const S& theta, S* q) {
  const Quaternion<S> after = load_quaternion(q) * exp_rotation(w, theta);
  const S scale = S(1.0) / square_root(S(dot(after.vector, after.vector) + after.w * after.w));
  q[0] = after.vector.x * scale;
  q[1] = after.vector.y * scale;
  q[2] = after.vector.z * scale;
  q[3] = after.w * scale;
}

template <class S>
BURNISH_INLINE void integrate_free_flyer(const S* dq, S* q) {
  const Vec3<S> v{dq[0], dq[1], dq[2]}, w{dq[3], dq[4], dq[5]};
  const S theta = rotation_angle(w);
  const Vec3<S> moved = turned(load_quaternion(q + 3), exp_position(exp_coefficients(theta), w, v));
  q[0] += moved.x;
  q[1] += moved.y;
  q[2] += moved.z;
  turn_quaternion(w, theta, q + 3);
}

template <class S>
BURNISH_INLINE void integrate_ball(const S* dq, S* q) {
  const Vec3<S> w{dq[0], dq[1], dq[2]};
  turn_quaternion(w, rotation_angle(w), q);
}

template <class S>
BURNISH_INLINE void difference_planar(const S* q0, const S* q1, S* dq) {
  const S w = angle_between(q0 + 2, q1 + 2);
  const S x = q1[0] - q0[0], y = q1[1] - q0[1];
  const Vec3<S> moved{q0[2] * x + q0[3] * y, q0[2] * y - q0[3] * x, S(0.0)};
  const Motion<S> xi =
      log_placement(log_coefficients(absolute(w)), Vec3<S>{S(0.0), S(0.0), w}, moved);
  dq[0] = xi.linear.x;
  dq[1] = xi.linear.y;
  dq[2] = w;
}

template <class S>
BURNISH_INLINE void difference_free_flyer(const S* q0, const S* q1, S* dq) {
  const Quaternion<S> from = load_quaternion(q0 + 3), back = conjugate(from);
  S theta;
  const Vec3<S> w = log_quaternion(back * load_quaternion(q1 + 3), theta);
  const Vec3<S> apart{q1[0] - q0[0], q1[1] - q0[1], q1[2] - q0[2]};
  const Motion<S> xi = log_placement(log_coefficients(theta), w, turned(back, apart));
  dq[0] = xi.linear.x;
  dq[1] = xi.linear.y;
  dq[2] = xi.linear.z;
  dq[3] = xi.angular.x;
  dq[4] = xi.angular.y;
  dq[5] = xi.angular.z;
}

template <class S>
BURNISH_INLINE void difference_ball(const S* q0, const S* q1, S* dq) {
  S theta;
  const Vec3<S> w = log_quaternion(conjugate(load_quaternion(q0)) * load_quaternion(q1), theta);
  dq[0] = w.x;
  dq[1] = w.y;
  dq[2] = w.z;
}

/// For every entry k of a block, calls visit(k, twist) with the twist at a unit rate of entry k.
template <class S>
BURNISH_INLINE void for_each_entry(const TangentBlock& block, const auto& visit) {
  for (int k = 0; k < block.size; ++k) {
    S unit[6] = {S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
    unit[k] = S(1.0);
    visit(k, load_twist(block.kind, unit));
  }
}

}  // namespace integration_detail

template <class S>
void integrate_configuration(const Tree& tree, const S* q, const S* dq, S* out) {
  using namespace integration_detail;
  if (out != q)
    for (int i = 0; i < tree.nq; ++i) out[i] = q[i];
  for (const TreeJoint& joint : tree.joints) {
    if (joint.follower >= 0) continue;
    const S* const step = dq + joint.v;
    S* const x = out + joint.q;
    switch (joint.kind) {
      case JointKind::Revolute:
      case JointKind::Prismatic:
        x[0] += step[0];
        break;
      case JointKind::Continuous: {
        S s, c;
        sine_cosine(step[0], s, c);
        turn_pair(c, s, x);
        break;
      }
      case JointKind::Planar:
        integrate_planar(step, x);
        break;
      case JointKind::FreeFlyer:
        integrate_free_flyer(step, x);
        break;
      case JointKind::Ball:
        integrate_ball(step, x);
        break;
    }
  }
}

template <class S>
void difference_configuration(const Tree& tree, const S* q0, const S* q1, S* dq) {
  using namespace integration_detail;
  for (const TreeJoint& joint : tree.joints) {
    if (joint.follower >= 0) continue;
    const S* const from = q0 + joint.q;
    const S* const to = q1 + joint.q;
    S* const x = dq + joint.v;
    switch (joint.kind) {
      case JointKind::Revolute:
      case JointKind::Prismatic:
        x[0] = to[0] - from[0];
        break;
      case JointKind::Continuous:
        x[0] = angle_between(from, to);
        break;
      case JointKind::Planar:
        difference_planar(from, to, x);
        break;
      case JointKind::FreeFlyer:
        difference_free_flyer(from, to, x);
        break;
      case JointKind::Ball:
        difference_ball(from, to, x);
        break;
    }
  }
}

template <class S>
void integrate_jacobians(const TangentBlock& block, const S* dq, S* by_q, S* by_dq) {
  using namespace integration_detail;
  const Motion<S> xi = load_twist(block.kind, dq);
  const S theta = rotation_angle(xi.angular);
  const ExpCoefficients<S> c = exp_coefficients(theta);
  const Quaternion<S> back = conjugate(exp_rotation(xi.angular, theta));
  const Vec3<S> p = exp_position(c, xi.angular, xi.linear);
  for_each_entry<S>(block, [&](int k, const Motion<S>& m) {
    const Motion<S> there = at_point(m, p);
    store_twist(block.kind, Motion<S>{turned(back, there.linear), turned(back, there.angular)},
                by_q + k, block.size);
    store_twist(block.kind, d_exp_placement(c, xi, m), by_dq + k, block.size);
  });
}

template <class S>
void difference_jacobians(const TangentBlock& block, const S* dq, S* by_q0, S* by_q1) {
  using namespace integration_detail;
  const Motion<S> xi = load_twist(block.kind, dq);
  const LogCoefficients<S> c = log_coefficients(rotation_angle(xi.angular));
  for_each_entry<S>(block, [&](int k, const Motion<S>& m) {
    store_twist(block.kind, -d_log_placement(c, -xi, m), by_q0 + k, block.size);
    store_twist(block.kind, d_log_placement(c, xi, m), by_q1 + k, block.size);
  });
}

}  // namespace burnish

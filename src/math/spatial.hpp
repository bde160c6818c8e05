// Spatial motions, forces and inertias as distinct types, with the linear part first. Operands must
// be in the same coordinate system, which the names of variables state. Algebra: R. Featherstone,
// Rigid Body Dynamics Algorithms, chapter 2.
#pragma once

#include "math/vec3.hpp"

namespace burnish {

/// Twist or spatial acceleration. A twist's linear part is the velocity of the body at the origin.
template <class S>
struct Motion {
  Vec3<S> linear, angular;

  BURNISH_INLINE friend Motion operator+(const Motion& a, const Motion& b) {
    return {a.linear + b.linear, a.angular + b.angular};
  }
  BURNISH_INLINE friend Motion operator-(const Motion& a, const Motion& b) {
    return {a.linear - b.linear, a.angular - b.angular};
  }
  BURNISH_INLINE Motion operator-() const { return {-linear, -angular}; }
  BURNISH_INLINE Motion& operator+=(const Motion& b) {
    linear += b.linear;
    angular += b.angular;
    return *this;
  }
  BURNISH_INLINE friend Motion operator*(const Motion& a, const S& s) {
    return {a.linear * s, a.angular * s};
  }
  BURNISH_INLINE static Motion zero() { return {Vec3<S>::zero(), Vec3<S>::zero()}; }
};

/// Wrench: force, and moment about the origin.
template <class S>
struct Force {
  Vec3<S> linear, angular;

  BURNISH_INLINE friend Force operator+(const Force& a, const Force& b) {
    return {a.linear + b.linear, a.angular + b.angular};
  }
  BURNISH_INLINE friend Force operator-(const Force& a, const Force& b) {
    return {a.linear - b.linear, a.angular - b.angular};
  }
  BURNISH_INLINE Force operator-() const { return {-linear, -angular}; }
  BURNISH_INLINE Force& operator+=(const Force& b) {
    linear += b.linear;
    angular += b.angular;
    return *this;
  }
  BURNISH_INLINE Force& operator-=(const Force& b) {
    linear -= b.linear;
    angular -= b.angular;
    return *this;
  }
  BURNISH_INLINE friend Force operator*(const Force& a, const S& s) {
    return {a.linear * s, a.angular * s};
  }
  BURNISH_INLINE static Force zero() { return {Vec3<S>::zero(), Vec3<S>::zero()}; }
};

/// Power of a force on a motion.
template <class S>
BURNISH_INLINE S dot(const Motion<S>& m, const Force<S>& f) {
  return dot(m.linear, f.linear) + dot(m.angular, f.angular);
}
/// Returns m x n: rate of a motion n that is carried by the motion m.
template <class S>
BURNISH_INLINE Motion<S> cross(const Motion<S>& m, const Motion<S>& n) {
  return {cross(m.angular, n.linear) + cross(m.linear, n.angular), cross(m.angular, n.angular)};
}
/// Returns m x* f: rate of a force f that is carried by the motion m.
template <class S>
BURNISH_INLINE Force<S> cross(const Motion<S>& m, const Force<S>& f) {
  return {cross(m.angular, f.linear), cross(m.angular, f.angular) + cross(m.linear, f.linear)};
}
/// Returns the motion with its linear part taken at the point p, measured from the old origin.
template <class S>
BURNISH_INLINE Motion<S> at_point(const Motion<S>& m, const Vec3<S>& p) {
  return {m.linear + cross(m.angular, p), m.angular};
}
/// Returns the wrench with its moment taken about the point p, measured from the old origin.
template <class S>
BURNISH_INLINE Force<S> at_point(const Force<S>& f, const Vec3<S>& p) {
  return {f.linear, f.angular - cross(p, f.linear)};
}

/// Spatial inertia about the origin: mass, first moment m c, second moment about the origin.
template <class S>
struct Inertia {
  S mass;
  Vec3<S> moment;
  Sym3<S> second;

  BURNISH_INLINE Force<S> operator*(const Motion<S>& m) const {
    return {m.linear * mass - cross(moment, m.angular),
            cross(moment, m.linear) + second * m.angular};
  }
  BURNISH_INLINE Inertia& operator+=(const Inertia& b) {
    mass += b.mass;
    moment += b.moment;
    second += b.second;
    return *this;
  }
};

/// Articulated-body inertia about the origin: inertia of a body with its free-moving descendants
/// (Featherstone, chapter 7). It has all 21 entries of a symmetric 6 x 6 matrix.
template <class S>
struct ArticulatedInertia {
  Sym3<S> linear;    ///< Force per linear acceleration [kg]
  Mat3<S> coupling;  ///< Force per angular acceleration [kg m]
  Sym3<S> angular;   ///< Moment per angular acceleration [kg m^2]

  BURNISH_INLINE static ArticulatedInertia of(const Inertia<S>& inertia) {
    const S zero(0.0);
    const Vec3<S>& c = inertia.moment;
    return {{inertia.mass, zero, zero, inertia.mass, zero, inertia.mass},
            {{zero, -c.z, c.y}, {c.z, zero, -c.x}, {-c.y, c.x, zero}},
            inertia.second};
  }
  BURNISH_INLINE Force<S> operator*(const Motion<S>& m) const {
    return {linear * m.linear + coupling * m.angular,
            transpose_times(coupling, m.linear) + angular * m.angular};
  }
  BURNISH_INLINE ArticulatedInertia& operator+=(const ArticulatedInertia& b) {
    linear += b.linear;
    coupling += b.coupling;
    angular += b.angular;
    return *this;
  }
  /// Subtracts f f^T. With f = I S / sqrt(S . I S), this removes the inertia along an axis S that
  /// moves freely.
  BURNISH_INLINE void release(const Force<S>& f) {
    linear.subtract_square(f.linear);
    coupling.c0 -= f.linear * f.angular.x;
    coupling.c1 -= f.linear * f.angular.y;
    coupling.c2 -= f.linear * f.angular.z;
    angular.subtract_square(f.angular);
  }
};

/// Operator B(v) = 1/2 [(v x*) I - I (v x) + (I v) xbar*] in the derivatives of I a + v x* I v
/// (Singh, Russell, Wensing, "Efficient Analytical Derivatives of Rigid-Body Dynamics using Spatial
/// Vector Algebra", 2022). Its left half is zero about any origin, so 12 numbers store it:
/// B = [0, -h x; 0, D].
template <class S>
struct Coriolis {
  Vec3<S> momentum;  ///< Linear momentum h
  Mat3<S> angular;   ///< Lower right block D

  BURNISH_INLINE Force<S> operator*(const Motion<S>& m) const {
    return {cross(m.angular, momentum), angular * m.angular};
  }
  /// Angular part of transpose(B) * m; the linear part is zero.
  BURNISH_INLINE Vec3<S> transpose_times_angular(const Motion<S>& m) const {
    return cross(momentum, m.linear) + transpose_times(angular, m.angular);
  }
  BURNISH_INLINE Coriolis& operator+=(const Coriolis& b) {
    momentum += b.momentum;
    angular += b.angular;
    return *this;
  }
};

/// Coriolis operator of a body with inertia I and twist v; `momentum` is the linear part of I v.
template <class S>
BURNISH_INLINE Coriolis<S> coriolis(const Inertia<S>& inertia, const Motion<S>& v,
                                    const Vec3<S>& momentum) {
  // D = -[mc][v] + [(tr(I)/2 - I) w] - I [w], where [a] is the matrix of the cross product with a,
  // and [a][b] = b a^T - (a.b) 1.
  const Sym3<S>& J = inertia.second;
  const Vec3<S>& c = inertia.moment;
  const Vec3<S>& w = v.angular;
  const Vec3<S>& l = v.linear;
  const Vec3<S> u = w * S((J.xx + J.yy + J.zz) * S(0.5)) - J * w;
  const S cl = dot(c, l);
  const Vec3<S> Jx{J.xx, J.xy, J.xz}, Jy{J.xy, J.yy, J.yz}, Jz{J.xz, J.yz, J.zz};
  const Vec3<S> k0 = Jy * w.z - Jz * w.y;  // columns of I [w]
  const Vec3<S> k1 = Jz * w.x - Jx * w.z;
  const Vec3<S> k2 = Jx * w.y - Jy * w.x;
  Coriolis<S> B;
  B.momentum = momentum;
  B.angular.c0 = {cl - l.x * c.x - k0.x, u.z - l.y * c.x - k0.y, -u.y - l.z * c.x - k0.z};
  B.angular.c1 = {-u.z - l.x * c.y - k1.x, cl - l.y * c.y - k1.y, u.x - l.z * c.y - k1.z};
  B.angular.c2 = {u.y - l.x * c.z - k2.x, -u.x - l.y * c.z - k2.y, cl - l.z * c.z - k2.z};
  return B;
}

}  // namespace burnish

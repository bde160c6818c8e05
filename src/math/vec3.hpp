// Vectors and matrices of dimension three for any scalar. They are plain structs, which compilers
// keep in registers even with packs. Expression templates would use memory.
#pragma once

#include <Eigen/Core>

#include "math/scalar.hpp"

namespace burnish {

template <class S>
struct Vec3 {
  S x, y, z;

  BURNISH_INLINE friend Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  BURNISH_INLINE friend Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  BURNISH_INLINE Vec3 operator-() const { return {-x, -y, -z}; }
  BURNISH_INLINE Vec3& operator+=(const Vec3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  BURNISH_INLINE Vec3& operator-=(const Vec3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  BURNISH_INLINE friend Vec3 operator*(const Vec3& a, const S& s) {
    return {a.x * s, a.y * s, a.z * s};
  }
  BURNISH_INLINE static Vec3 zero() { return {S(0.0), S(0.0), S(0.0)}; }
};

template <class S>
BURNISH_INLINE Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S>
BURNISH_INLINE S dot(const Vec3<S>& a, const Vec3<S>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// 3 x 3 matrix, stored by columns.
template <class S>
struct Mat3 {
  Vec3<S> c0, c1, c2;

  BURNISH_INLINE friend Vec3<S> operator*(const Mat3& m, const Vec3<S>& v) {
    return {m.c0.x * v.x + m.c1.x * v.y + m.c2.x * v.z, m.c0.y * v.x + m.c1.y * v.y + m.c2.y * v.z,
            m.c0.z * v.x + m.c1.z * v.y + m.c2.z * v.z};
  }
  BURNISH_INLINE friend Mat3 operator*(const Mat3& a, const Mat3& b) {
    return {a * b.c0, a * b.c1, a * b.c2};
  }
  BURNISH_INLINE Mat3& operator+=(const Mat3& b) {
    c0 += b.c0;
    c1 += b.c1;
    c2 += b.c2;
    return *this;
  }
  BURNISH_INLINE static Mat3 identity() {
    return {{S(1.0), S(0.0), S(0.0)}, {S(0.0), S(1.0), S(0.0)}, {S(0.0), S(0.0), S(1.0)}};
  }
};

template <class S>
BURNISH_INLINE const Vec3<S>& column(const Mat3<S>& m, int k) {
  return k == 0 ? m.c0 : k == 1 ? m.c1 : m.c2;
}
/// Returns transpose(m) * v.
template <class S>
BURNISH_INLINE Vec3<S> transpose_times(const Mat3<S>& m, const Vec3<S>& v) {
  return {dot(m.c0, v), dot(m.c1, v), dot(m.c2, v)};
}
/// Returns transpose(a) * b.
template <class S>
BURNISH_INLINE Mat3<S> transpose_times(const Mat3<S>& a, const Mat3<S>& b) {
  return {transpose_times(a, b.c0), transpose_times(a, b.c1), transpose_times(a, b.c2)};
}

template <class S>
BURNISH_INLINE Mat3<S> transposed(const Mat3<S>& m) {
  return {{m.c0.x, m.c1.x, m.c2.x}, {m.c0.y, m.c1.y, m.c2.y}, {m.c0.z, m.c1.z, m.c2.z}};
}

/// Symmetric 3 x 3 matrix.
template <class S>
struct Sym3 {
  S xx, xy, xz, yy, yz, zz;

  BURNISH_INLINE Vec3<S> operator*(const Vec3<S>& v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
            xz * v.x + yz * v.y + zz * v.z};
  }
  BURNISH_INLINE Sym3& operator+=(const Sym3& b) {
    xx += b.xx;
    xy += b.xy;
    xz += b.xz;
    yy += b.yy;
    yz += b.yz;
    zz += b.zz;
    return *this;
  }
  /// Subtracts v v^T.
  BURNISH_INLINE void subtract_square(const Vec3<S>& v) {
    xx -= v.x * v.x;
    xy -= v.x * v.y;
    xz -= v.x * v.z;
    yy -= v.y * v.y;
    yz -= v.y * v.z;
    zz -= v.z * v.z;
  }
};

/// Converts constants of the model to the scalar of a kernel.
template <class S>
BURNISH_INLINE Vec3<S> lift(const Vec3<double>& v) {
  return {S(v.x), S(v.y), S(v.z)};
}
template <class S>
BURNISH_INLINE Mat3<S> lift(const Mat3<double>& m) {
  return {lift<S>(m.c0), lift<S>(m.c1), lift<S>(m.c2)};
}

inline Vec3<double> from_eigen(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Mat3<double> from_eigen(const Eigen::Matrix3d& m) {
  return {from_eigen(Eigen::Vector3d(m.col(0))), from_eigen(Eigen::Vector3d(m.col(1))),
          from_eigen(Eigen::Vector3d(m.col(2)))};
}
inline Eigen::Vector3d to_eigen(const Vec3<double>& v) { return {v.x, v.y, v.z}; }
inline Eigen::Matrix3d to_eigen(const Mat3<double>& m) {
  Eigen::Matrix3d r;
  r << to_eigen(m.c0), to_eigen(m.c1), to_eigen(m.c2);
  return r;
}

}  // namespace burnish

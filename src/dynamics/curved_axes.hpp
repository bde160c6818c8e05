// Axes that follow the normal of a curved surface at a moving point. phi is the function of the
// surface (Quadric), with g = grad phi and H = Q at the point. For the velocity v of the point, the
// unit normal and its rate are
//   n = g / |g|,   n' = (H v - n (n . H v)) / |g|.
// The axes are the initial axes, with normal n0, turned by the smallest rotation T from n0 to n:
//   T y = y + c x y + c x (c x y) / (1 + n0 . n)   with c = n0 x n.
// T depends on n only. The angular velocity of T has no component along n0 + n, so it is
//   w = n x n' - n (n0 . (n x n')) / (1 + n0 . n).
// All vectors are either in axes of the surface frame or in world axes.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Coefficients of a Quadric, for kernels.
template <class S>
struct CurvedSurface {
  Mat3<S> Q;
  Vec3<S> b;
};

/// Axes at one position and velocity of the moving point.
template <class S>
struct CurvedAxes {
  Vec3<S> n, n0;
  Mat3<S> H;
  S per_gradient;      ///< 1 / |g|
  S inverse_sum;       ///< 1 / (1 + n0 . n)
  Vec3<S> Hv, n_rate;  ///< H v and n'
  Vec3<S> swing;       ///< n x n'
  S spin;              ///< (n0 . swing) * inverse_sum
  Vec3<S> w;           ///< Angular velocity of the axes [rad/s]

  /// Change dn of the normal for a displacement dx of the point. With dx = v, this is n'.
  BURNISH_INLINE Vec3<S> normal_change(const Vec3<S>& dx) const {
    const Vec3<S> Hx = H * dx;
    return (Hx - n * dot(n, Hx)) * per_gradient;
  }
  /// Rotation of the axes for a change dn of the normal [rad].
  BURNISH_INLINE Vec3<S> turn(const Vec3<S>& dn) const {
    const Vec3<S> tilt = cross(n, dn);
    return tilt - n * (dot(n0, tilt) * inverse_sum);
  }
  /// Change of w for a displacement dx of the point, the resulting change dn of the normal, and a
  /// change dv of the point's velocity.
  BURNISH_INLINE Vec3<S> turn_rate_change(const Vec3<S>& dx, const Vec3<S>& dn,
                                          const Vec3<S>& dv) const {
    const Vec3<S> H_dv = H * dv;
    const S along = dot(n, Hv);
    const Vec3<S> dn_rate =
        (H_dv - dn * along - n * (dot(dn, Hv) + dot(n, H_dv)) - n_rate * dot(n, H * dx)) *
        per_gradient;
    const Vec3<S> dswing = cross(dn, n_rate) + cross(n, dn_rate);
    const S dspin = (dot(n0, dswing) - spin * dot(n0, dn)) * inverse_sum;
    return dswing - dn * spin - n * dspin;
  }
};

/// Returns T y: turns y by the smallest rotation from n0 to n. `inverse_sum` is 1 / (1 + n0 . n).
template <class S>
BURNISH_INLINE Vec3<S> least_rotation(const Vec3<S>& n0, const Vec3<S>& n, const S& inverse_sum,
                                      const Vec3<S>& y) {
  const Vec3<S> c = cross(n0, n), once = cross(c, y);
  return y + once + cross(c, once) * inverse_sum;
}

/// Returns the axes at the point x. Does not fill the members that depend on the velocity.
template <class S>
BURNISH_INLINE CurvedAxes<S> curved_axes(const CurvedSurface<S>& surface, const Vec3<S>& n0,
                                         const Vec3<S>& x) {
  CurvedAxes<S> at;
  const Vec3<S> g = surface.Q * x + surface.b;
  at.per_gradient = S(1.0) / square_root(dot(g, g));
  at.n = g * at.per_gradient;
  at.n0 = n0;
  at.inverse_sum = S(1.0) / (S(1.0) + dot(n0, at.n));
  at.H = surface.Q;
  return at;
}

/// Turns the vectors in `at` by R, for example from the surface frame to the world. Then fills the
/// members that depend on the velocity v of the point, with v given in the new axes.
template <class S>
BURNISH_INLINE void move_over(const Mat3<S>& R, const Vec3<S>& v, CurvedAxes<S>& at) {
  at.n = R * at.n;
  at.n0 = R * at.n0;
  at.H = R * transposed(R * at.H);  // R H R^T, H being symmetric
  at.Hv = at.H * v;
  at.n_rate = (at.Hv - at.n * dot(at.n, at.Hv)) * at.per_gradient;
  at.swing = cross(at.n, at.n_rate);
  at.spin = dot(at.n0, at.swing) * at.inverse_sum;
  at.w = at.swing - at.n * at.spin;
}

}  // namespace burnish

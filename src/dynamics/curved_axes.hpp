// Axes that follow a curved surface, at a point that moves over it. With phi the surface's function
// (Quadric), g = grad phi and H = Q at the point, the unit normal and its rate with the point's
// velocity v are
//   n = g / |g|,   n' = (H v - n (n . H v)) / |g|.
// The axes are those at a normal n0 turned by the least rotation that takes n0 to n, which depends
// on n alone: with c = n0 x n, T y = y + c x y + c x (c x y) / (1 + n0 . n). It turns with
//   w = n x n' - n (n0 . (n x n')) / (1 + n0 . n),
// since half way between n0 and n it does not spin: w . (n0 + n) = 0.
// All of it is in the axes of the frame that the surface is fixed in, or all of it in the world's.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// A Quadric as the kernels read it.
template <class S>
struct CurvedSurface {
  Mat3<S> Q;
  Vec3<S> b;
};

/// At a point and a velocity, which changes with both.
template <class S>
struct CurvedAxes {
  Vec3<S> n, n0;
  Mat3<S> H;
  S per_gradient;      ///< 1 / |g|
  S share;             ///< 1 / (1 + n0 . n)
  Vec3<S> Hv, n_rate;  ///< H v and n'
  Vec3<S> swing;       ///< n x n'
  S spin;              ///< (n0 . swing) share
  Vec3<S> w;           ///< of the axes, rad/s

  /// dn by a step of the point; n' where that is the velocity.
  BURNISH_INLINE Vec3<S> normal_change(const Vec3<S>& dx) const {
    const Vec3<S> Hx = H * dx;
    return (Hx - n * dot(n, Hx)) * per_gradient;
  }
  /// Angle by which the axes turn with dn.
  BURNISH_INLINE Vec3<S> turn(const Vec3<S>& dn) const {
    const Vec3<S> over = cross(n, dn);
    return over - n * (dot(n0, over) * share);
  }
  /// dw by a step dx of the point, with dn of the normal, and a change dv of its velocity.
  BURNISH_INLINE Vec3<S> turn_rate_change(const Vec3<S>& dx, const Vec3<S>& dn,
                                          const Vec3<S>& dv) const {
    const Vec3<S> H_dv = H * dv;
    const S along = dot(n, Hv);
    const Vec3<S> dn_rate =
        (H_dv - dn * along - n * (dot(dn, Hv) + dot(n, H_dv)) - n_rate * dot(n, H * dx)) *
        per_gradient;
    const Vec3<S> dswing = cross(dn, n_rate) + cross(n, dn_rate);
    const S dspin = (dot(n0, dswing) - spin * dot(n0, dn)) * share;
    return dswing - dn * spin - n * dspin;
  }
};

/// T y.
template <class S>
BURNISH_INLINE Vec3<S> least_rotation(const Vec3<S>& n0, const Vec3<S>& n, const S& share,
                                      const Vec3<S>& y) {
  const Vec3<S> c = cross(n0, n), once = cross(c, y);
  return y + once + cross(c, once) * share;
}

/// All but what the velocity has a part in.
template <class S>
BURNISH_INLINE CurvedAxes<S> curved_axes(const CurvedSurface<S>& surface, const Vec3<S>& n0,
                                         const Vec3<S>& x) {
  CurvedAxes<S> at;
  const Vec3<S> g = surface.Q * x + surface.b;
  at.per_gradient = S(1.0) / square_root(dot(g, g));
  at.n = g * at.per_gradient;
  at.n0 = n0;
  at.share = S(1.0) / (S(1.0) + dot(n0, at.n));
  at.H = surface.Q;
  return at;
}

/// The same in the axes that R leads to, and with the velocity there.
template <class S>
BURNISH_INLINE void move_over(const Mat3<S>& R, const Vec3<S>& v, CurvedAxes<S>& at) {
  at.n = R * at.n;
  at.n0 = R * at.n0;
  at.H = R * transposed(R * at.H);  // R H R^T, H being symmetric
  at.Hv = at.H * v;
  at.n_rate = (at.Hv - at.n * dot(at.n, at.Hv)) * at.per_gradient;
  at.swing = cross(at.n, at.n_rate);
  at.spin = dot(at.n0, at.swing) * at.share;
  at.w = at.swing - at.n * at.spin;
}

}  // namespace burnish

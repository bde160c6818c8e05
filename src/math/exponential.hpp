// Exponentials of rotation vectors and twists and their derivatives, without branches on values.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Coefficients at rotation angle theta, as polynomials in (w x) and in ad = (xi x):
///   displacement: V = 1 + so3_1 (w x) + so3_2 (w x)^2,
///   right Jacobian of SO(3): 1 - so3_1 (w x) + so3_2 (w x)^2,
///   right Jacobian of SE(3): 1 - se3_1 ad + se3_2 ad^2 - se3_3 ad^3 + se3_4 ad^4
/// (T. Barfoot, State Estimation for Robotics, chapter 7; his left Jacobians have plus signs).
template <class S>
struct ExpCoefficients {
  S so3_1, so3_2, se3_1, se3_2, se3_3, se3_4;
};

/// `theta` >= 0.
template <class S>
BURNISH_INLINE ExpCoefficients<S> exp_coefficients(const S& theta) {
  // All are sums of c_n = 1/n! - theta^2/(n + 2)! + theta^4/(n + 4)! - ..., which hang together by
  // c_n = 1/n! - theta^2 c_(n+2) from c_0 = cos(theta) and c_1 = sin(theta)/theta. Downwards that
  // loses no digits while theta is small, upwards none while it is not. At theta = 1 the first
  // term that the series omit is below 1e-18.
  const auto small = less(theta, S(1.0));
  const S y = -theta * theta;
  const S c4_series =
      S(1.0 / 24) +
      y * (S(1.0 / 720) +
           y * (S(1.0 / 40320) +
                y * (S(1.0 / 3628800) +
                     y * (S(1.0 / 479001600) +
                          y * (S(1.0 / 87178291200) + y * (S(1.0 / 20922789888000.0) +
                                                           y * S(1.0 / 6402373705728000.0)))))));
  const S c5_series =
      S(1.0 / 120) +
      y * (S(1.0 / 5040) +
           y * (S(1.0 / 362880) +
                y * (S(1.0 / 39916800) +
                     y * (S(1.0 / 6227020800) + y * (S(1.0 / 1307674368000) +
                                                     y * (S(1.0 / 355687428096000.0) +
                                                          y * S(1.0 / 121645100408832000.0)))))));
  const S c2_series = S(0.5) + y * c4_series, c3_series = S(1.0 / 6) + y * c5_series;
  const S safe = select(small, S(1.0), theta);
  S sine, cosine;
  sine_cosine(safe, sine, cosine);
  const S by_square = S(1.0) / (safe * safe);
  const S c1_exact = sine / safe;
  const S c2_exact = (S(1.0) - cosine) * by_square, c3_exact = (S(1.0) - c1_exact) * by_square;
  const S c1 = select(small, S(S(1.0) + y * c3_series), c1_exact);
  const S c2 = select(small, c2_series, c2_exact), c3 = select(small, c3_series, c3_exact);
  const S c4 = select(small, c4_series, S((S(0.5) - c2_exact) * by_square));
  const S c5 = select(small, c5_series, S((S(1.0 / 6) - c3_exact) * by_square));
  const S half(0.5);
  return {c2,
          c3,
          (S(4.0) * c2 - c1) * half,
          (S(5.0) * c3 - c2) * half,
          (c3 - S(2.0) * c4) * half,
          (c4 - S(3.0) * c5) * half};
}

/// Length of the rotation vector w; its derivative at zero is zero, not infinite.
template <class S>
BURNISH_INLINE S rotation_angle(const Vec3<S>& w) {
  const S square = dot(w, w);
  const auto none = less(square, S(1e-300));
  return select(none, S(0.0), square_root(select(none, S(1.0), square)));
}

/// A rotation as the unit quaternion (x, y, z, w).
template <class S>
struct Quaternion {
  Vec3<S> vector;  ///< x, y, z
  S w;
};

/// The rotation by the rotation vector w of length theta.
template <class S>
BURNISH_INLINE Quaternion<S> exp_rotation(const Vec3<S>& w, const S& theta) {
  // Series of sin(theta/2)/theta; at theta = 0.5 the first omitted term is below 1e-17.
  const auto small = less(theta, S(0.5));
  const S half = theta * S(0.5);
  const S y = -half * half;
  const S series =
      S(0.5) +
      y * (S(0.5 / 6) + y * (S(0.5 / 120) +
                             y * (S(0.5 / 5040) + y * (S(0.5 / 362880) + y * S(0.5 / 39916800)))));
  S sine, cosine;
  sine_cosine(half, sine, cosine);
  const S factor = select(small, series, S(sine / select(small, S(1.0), theta)));
  return {w * factor, cosine};
}

/// Where the origin goes, in the axes at the start, when the twist (v, w) is held for unit time:
/// V(w) v.
template <class S>
BURNISH_INLINE Vec3<S> exp_position(const ExpCoefficients<S>& c, const Vec3<S>& w,
                                    const Vec3<S>& v) {
  const Vec3<S> once = cross(w, v);
  return v + once * c.so3_1 + cross(w, once) * c.so3_2;
}

/// J_r(w) dw: angular velocity, in its own axes, of the rotation whose rotation vector w changes at
/// the rate dw.
template <class S>
BURNISH_INLINE Vec3<S> d_exp_rotation(const ExpCoefficients<S>& c, const Vec3<S>& w,
                                      const Vec3<S>& dw) {
  const Vec3<S> once = cross(w, dw);
  return dw - once * c.so3_1 + cross(w, once) * c.so3_2;
}

/// J_r(xi) dxi: twist, in its own axes, of the placement exp(xi) when xi changes at the rate dxi.
template <class S>
BURNISH_INLINE Motion<S> d_exp_placement(const ExpCoefficients<S>& c, const Motion<S>& xi,
                                         const Motion<S>& dxi) {
  const Motion<S> once = cross(xi, dxi);
  const Motion<S> twice = cross(xi, once);
  const Motion<S> thrice = cross(xi, twice);
  return dxi - once * c.se3_1 + twice * c.se3_2 - thrice * c.se3_3 + cross(xi, thrice) * c.se3_4;
}

}  // namespace burnish

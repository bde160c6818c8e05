// Exponentials of rotation vectors and twists, and their derivatives. The functions do not branch
// on values.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Coefficients of polynomials in (w x) or ad = (xi x), for a rotation vector w or a twist xi:
///   displacement: V = 1 + so3_1 (w x) + so3_2 (w x)^2,
///   right Jacobian of SO(3): 1 - so3_1 (w x) + so3_2 (w x)^2,
///   right Jacobian of SE(3): 1 - se3_1 ad + se3_2 ad^2 - se3_3 ad^3 + se3_4 ad^4
/// (T. Barfoot, State Estimation for Robotics, chapter 7; his left Jacobians have plus signs).
template <class S>
struct ExpCoefficients {
  S so3_1, so3_2, se3_1, se3_2, se3_3, se3_4;
};

/// Returns the coefficients at the rotation angle theta >= 0 [rad].
template <class S>
BURNISH_INLINE ExpCoefficients<S> exp_coefficients(const S& theta) {
  // All coefficients are combinations of c_n = 1/n! - theta^2/(n + 2)! + theta^4/(n + 4)! - ... The
  // recursion c_n = 1/n! - theta^2 c_(n+2) connects them, with c_0 = cos(theta) and
  // c_1 = sin(theta)/theta. For theta < 1, series give c_4 and c_5, and the recursion runs towards
  // smaller n without cancellation. For larger theta it runs towards larger n. At theta = 1, the
  // first omitted term of the series is below 1e-18.
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

/// Length of the rotation vector w [rad]. The derivative at w = 0 is set to zero.
template <class S>
BURNISH_INLINE S rotation_angle(const Vec3<S>& w) {
  const S square = dot(w, w);
  const auto none = less(square, S(1e-300));
  return select(none, S(0.0), square_root(select(none, S(1.0), square)));
}

/// Unit quaternion of a rotation.
template <class S>
struct Quaternion {
  Vec3<S> vector;  ///< x, y, z
  S w;
};

/// Rotation by the rotation vector w with length theta.
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

/// Displacement V(w) v of the origin under the constant twist (v, w) for unit time, in the initial
/// axes.
template <class S>
BURNISH_INLINE Vec3<S> exp_position(const ExpCoefficients<S>& c, const Vec3<S>& w,
                                    const Vec3<S>& v) {
  const Vec3<S> once = cross(w, v);
  return v + once * c.so3_1 + cross(w, once) * c.so3_2;
}

/// Returns J_r(w) dw: angular velocity, in body axes, of the rotation exp(w) if w has the rate dw.
template <class S>
BURNISH_INLINE Vec3<S> d_exp_rotation(const ExpCoefficients<S>& c, const Vec3<S>& w,
                                      const Vec3<S>& dw) {
  const Vec3<S> once = cross(w, dw);
  return dw - once * c.so3_1 + cross(w, once) * c.so3_2;
}

/// Returns J_r(xi) dxi: twist, in body axes, of the placement exp(xi) if xi has the rate dxi.
template <class S>
BURNISH_INLINE Motion<S> d_exp_placement(const ExpCoefficients<S>& c, const Motion<S>& xi,
                                         const Motion<S>& dxi) {
  const Motion<S> once = cross(xi, dxi);
  const Motion<S> twice = cross(xi, once);
  const Motion<S> thrice = cross(xi, twice);
  return dxi - once * c.se3_1 + twice * c.se3_2 - thrice * c.se3_3 + cross(xi, thrice) * c.se3_4;
}

}  // namespace burnish

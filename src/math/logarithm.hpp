// Logarithms of rotations and placements, and their derivatives. The functions do not branch on
// values.
#pragma once

#include "math/exponential.hpp"

namespace burnish {

/// Coefficients of the inverse right Jacobians of SO(3) and SE(3) at rotation angle theta, as
/// polynomials in ad = (xi x):
///   SO(3): J^-1 = 1 + ad/2 + so3 ad^2,
///   SE(3): J^-1 = 1 + ad/2 + se3_2 ad^2 + se3_4 ad^4.
/// The polynomials interpolate x/(1 - exp(-x)) at the eigenvalues of ad: 0 and +-i theta. In SE(3),
/// the eigenvalues +-i theta are double, so the slopes there are interpolated too.
template <class S>
struct LogCoefficients {
  S so3, se3_2, se3_4;
};

template <class S>
BURNISH_INLINE LogCoefficients<S> log_coefficients(const S& theta) {
  // Series (x/2) coth(x/2) = sum c_n x^2n, used for theta < 0.7, where the first omitted term is
  // below 1e-17.
  constexpr double c1 = 1.0 / 12, c2 = -1.0 / 720, c3 = 1.0 / 30240, c4 = -1.0 / 1209600,
                   c5 = 1.0 / 47900160, c6 = -691.0 / 1307674368000.0, c7 = 1.0 / 74724249600.0,
                   c8 = -3617.0 / 10670622842880000.0;
  const auto small = less(theta, S(0.7));
  const S y = -theta * theta;
  const S so3_series =
      S(c1) + y * (S(c2) + y * (S(c3) + y * (S(c4) + y * (S(c5) + y * (S(c6) + y * S(c7))))));
  // The series in s = x^2 is reduced modulo s (s - y)^2, because s is 0 or y = -theta^2 at the
  // eigenvalues of ad: s^n = (n-1) y^(n-2) s^2 - (n-2) y^(n-1) s.
  const S series_2 =
      S(c1) -
      y * y *
          (S(c3) +
           y * (S(2 * c4) + y * (S(3 * c5) + y * (S(4 * c6) + y * (S(5 * c7) + y * S(6 * c8))))));
  const S series_4 =
      S(c2) +
      y * (S(2 * c3) +
           y * (S(3 * c4) + y * (S(4 * c5) + y * (S(5 * c6) + y * (S(6 * c7) + y * S(7 * c8))))));
  const S safe = select(small, S(1.0), theta);
  S sine, cosine;
  sine_cosine(S(safe * S(0.5)), sine, cosine);
  const S half = safe * S(0.5);
  const S gamma = half * cosine / sine;  // (theta/2) cot(theta/2)
  const S square = safe * safe;
  // d(gamma)/dy, y = -theta^2
  const S slope = -(cosine / sine - half / (sine * sine)) / (S(4.0) * safe);
  const S exact_4 = (S(1.0) - gamma - slope * square) / (square * square);
  LogCoefficients<S> r;
  r.so3 = select(small, so3_series, S((S(1.0) - gamma) / square));
  r.se3_4 = select(small, series_4, exact_4);
  r.se3_2 = select(small, series_2, S(slope + S(2.0) * square * exact_4));
  return r;
}

/// Returns the rotation vector of a rotation matrix, and sets theta to its length, in [0, pi]. At
/// exactly pi, it returns one of the two possible axes.
template <class S>
Vec3<S> log_rotation(const Mat3<S>& R, S& theta) {
  // Selects the largest of the four quaternion components, so that no lane divides by a small
  // number.
  const S m00 = R.c0.x, m11 = R.c1.y, m22 = R.c2.z;
  const S tw = m00 + m11 + m22, tx = m00 - m11 - m22, ty = m11 - m00 - m22, tz = m22 - m00 - m11;
  const Vec3<S> axial{R.c1.z - R.c2.y, R.c2.x - R.c0.z, R.c0.y - R.c1.x};
  const S sxy = R.c1.x + R.c0.y, sxz = R.c2.x + R.c0.z, syz = R.c2.y + R.c1.z;
  const auto use_z = mask_and(less(tx, tz), less(ty, tz));
  const auto use_y = mask_and(less(tx, ty), mask_not(use_z));
  const S largest = select(use_z, tz, select(use_y, ty, tx));
  const auto use_w = less(largest, tw);
  // Row of the matrix 4 q q^T for the largest component.
  const S d = S(1.0) + select(use_w, tw, largest);
  S qw = select(use_w, d, select(use_z, axial.z, select(use_y, axial.y, axial.x)));
  S qx = select(use_w, axial.x, select(use_z, sxz, select(use_y, sxy, d)));
  S qy = select(use_w, axial.y, select(use_z, syz, select(use_y, d, sxy)));
  S qz = select(use_w, axial.z, select(use_z, d, select(use_y, syz, sxz)));
  const auto flip = less(qw, S(0.0));
  qw = select(flip, S(-qw), qw);
  Vec3<S> u{select(flip, S(-qx), qx), select(flip, S(-qy), qy), select(flip, S(-qz), qz)};
  const S square = dot(u, u);
  const S whole = square + qw * qw;
  // For a small vector part u of the quaternion, theta/|u| is 2/qw times a series in (|u|/qw)^2.
  const auto small = less(square, S(S(1e-6) * whole));
  const S length = square_root(select(small, S(1.0), square));
  const S angle = S(2.0) * arc_tangent2(length, select(small, S(1.0), qw));
  const S ratio2 = square / (select(small, S(qw * qw), S(1.0)));
  const S series = S(2.0) / select(small, qw, S(1.0)) *
                   (S(1.0) - ratio2 * (S(1.0 / 3) - ratio2 * (S(1.0 / 5) - ratio2 * S(1.0 / 7))));
  const S factor = select(small, series, S(angle / length));
  const S tiny = select(less(square, S(1e-300)), S(1.0), square);
  const S nonzero = select(less(square, S(1e-300)), S(0.0), square_root(tiny));
  theta = factor * nonzero;
  return u * factor;
}

/// Returns the rotation vector of a quaternion of any length, and sets theta to the length of the
/// rotation vector, in [0, pi].
template <class S>
BURNISH_INLINE Vec3<S> log_quaternion(const Quaternion<S>& rotation, S& theta) {
  const auto flip = less(rotation.w, S(0.0));
  const S sign = select(flip, S(-1.0), S(1.0));
  const Vec3<S> u = rotation.vector * sign;
  const S w = rotation.w * sign;
  const S square = dot(u, u);
  // 2 atan(t)/t with t = |u|/w; a series is used for small t.
  const auto small = less(square, S(S(1e-6) * w * w));
  const S ratio2 = square / select(small, S(w * w), S(1.0));
  const S series = S(2.0) / select(small, w, S(1.0)) *
                   (S(1.0) - ratio2 * (S(1.0 / 3) - ratio2 * (S(1.0 / 5) - ratio2 * S(1.0 / 7))));
  const S length = square_root(select(small, S(1.0), square));
  const S angle = S(2.0) * arc_tangent2(length, select(small, S(1.0), w));
  const Vec3<S> phi = u * select(small, series, S(angle / length));
  theta = rotation_angle(phi);
  return phi;
}

/// Angle from one (cos, sin) pair to another, in [-pi, pi] [rad].
template <class S>
BURNISH_INLINE S angle_between(const S* from, const S* to) {
  const S sine = from[0] * to[1] - from[1] * to[0], cosine = from[0] * to[0] + from[1] * to[1];
  const S angle = arc_tangent2(absolute(sine), cosine);
  return select(less(sine, S(0.0)), S(-angle), angle);
}

/// Returns J_r^-1(phi) w: rate of the rotation vector phi for the angular velocity w in body axes.
template <class S>
BURNISH_INLINE Vec3<S> d_log_rotation(const LogCoefficients<S>& c, const Vec3<S>& phi,
                                      const Vec3<S>& w) {
  const Vec3<S> once = cross(phi, w);
  return w + once * S(0.5) + cross(phi, once) * c.so3;
}

/// SE(3) logarithm of the placement (R, p), with phi = log(R).
template <class S>
BURNISH_INLINE Motion<S> log_placement(const LogCoefficients<S>& c, const Vec3<S>& phi,
                                       const Vec3<S>& p) {
  const Vec3<S> once = cross(phi, p);
  return {p - once * S(0.5) + cross(phi, once) * c.so3, phi};
}

/// Returns J_r^-1(xi) m: rate of the logarithm xi for the twist m in body axes.
template <class S>
BURNISH_INLINE Motion<S> d_log_placement(const LogCoefficients<S>& c, const Motion<S>& xi,
                                         const Motion<S>& m) {
  const Motion<S> once = cross(xi, m);
  const Motion<S> twice = cross(xi, once);
  const Motion<S> four = cross(xi, cross(xi, twice));
  return m + once * S(0.5) + twice * c.se3_2 + four * c.se3_4;
}

}  // namespace burnish

// Exact integration of an inertial measurement unit (IMU) over a tick in which its readings are
// constant. The rotation becomes R exp(phi). Velocity and position use the series
//   Gamma_1(phi) = sum phi^n/(n + 1)!,   Gamma_2(phi) = sum phi^n/(n + 2)!,   phi = w dt
// (Hartley, Ghaffari, Eustice, Grizzle, "Contact-aided invariant extended Kalman filtering for
// robot state estimation", 2020, appendix on discretization). The derivatives of Gamma_1 and
// Gamma_2 are derived here.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Coefficients c_n = sum (-theta^2)^k/(n + 2k)! of polynomials in the cross-product matrix of phi,
/// where theta = |phi|. They satisfy c_n = 1/n! - theta^2 c_(n+2), and have the derivatives
/// d(c_n) = (n c_(n+2) - c_(n+1)) phi^T d(phi).
template <class S>
struct RotationSeries {
  S c1, c2, c3, c4, c5, c6;
};

/// Computes the coefficients for one phi. The function branches on the angle, so that it cannot
/// process several states in one vector register.
template <class S>
RotationSeries<S> rotation_series(const Vec3<S>& phi) {
  using std::cos, std::sin, std::sqrt;
  RotationSeries<S> r;
  const S square = dot(phi, phi), y = -square;
  if (square < S(1.0)) {  // series; omitted terms are below 1e-17
    r.c5 = S(1.0 / 120) +
           y * (S(1.0 / 5040) +
                y * (S(1.0 / 362880) +
                     y * (S(1.0 / 39916800) +
                          y * (S(1.0 / 6227020800) +
                               y * (S(1.0 / 1307674368000) + y * S(1.0 / 355687428096000.0))))));
    r.c6 =
        S(1.0 / 720) +
        y * (S(1.0 / 40320) + y * (S(1.0 / 3628800) +
                                   y * (S(1.0 / 479001600) + y * (S(1.0 / 87178291200) +
                                                                  y * S(1.0 / 20922789888000.0)))));
    r.c4 = S(1.0 / 24) + y * r.c6;
    r.c3 = S(1.0 / 6) + y * r.c5;
    r.c2 = S(0.5) + y * r.c4;
    r.c1 = S(1.0) + y * r.c3;
    return r;
  }
  const S theta = sqrt(square), by_square = S(1.0) / square;
  r.c1 = sin(theta) / theta;
  r.c2 = (S(1.0) - cos(theta)) * by_square;
  r.c3 = (S(1.0) - r.c1) * by_square;
  r.c4 = (S(0.5) - r.c2) * by_square;
  r.c5 = (S(1.0 / 6) - r.c3) * by_square;
  r.c6 = (S(1.0 / 24) - r.c4) * by_square;
  return r;
}

/// Returns a I + b [phi]x + c [phi]x^2 with the identity I and the cross-product matrix [phi]x.
template <class S>
Mat3<S> rotation_polynomial(const Vec3<S>& phi, const S& a, const S& b, const S& c) {
  const S d = a - c * dot(phi, phi);
  const Vec3<S> u = phi * c, w = phi * b;
  return {{d + u.x * phi.x, u.x * phi.y + w.z, u.x * phi.z - w.y},
          {u.y * phi.x - w.z, d + u.y * phi.y, u.y * phi.z + w.x},
          {u.z * phi.x + w.y, u.z * phi.y - w.x, d + u.z * phi.z}};
}
template <class S>
Mat3<S> exp_matrix(const Vec3<S>& phi, const RotationSeries<S>& c) {
  return rotation_polynomial(phi, S(1.0), c.c1, c.c2);
}
template <class S>
Mat3<S> gamma_1(const Vec3<S>& phi, const RotationSeries<S>& c) {
  return rotation_polynomial(phi, S(1.0), c.c2, c.c3);
}
template <class S>
Mat3<S> gamma_2(const Vec3<S>& phi, const RotationSeries<S>& c) {
  return rotation_polynomial(phi, S(0.5), c.c3, c.c4);
}

template <class S>
struct InertialState {
  Mat3<S> R;     ///< Rotation from the axes of the IMU to the world.
  Vec3<S> v, p;  ///< Velocity and position of the IMU in the world [m/s, m].
};

/// Returns the state after `dt` [s]. `w`: angular velocity [rad/s]; `f`: specific force [m/s^2];
/// both are without bias, in the axes of the IMU. `gravity`: gravity vector in the world [m/s^2].
template <class S>
InertialState<S> strapdown(const InertialState<S>& x, const Vec3<S>& w, const Vec3<S>& f,
                           const Vec3<S>& gravity, const S& dt) {
  const Vec3<S> phi = w * dt;
  const RotationSeries<S> c = rotation_series(phi);
  InertialState<S> next;
  next.R = x.R * exp_matrix(phi, c);
  next.v = x.v + (gravity + x.R * (gamma_1(phi, c) * f)) * dt;
  next.p = x.p + (x.v + (gravity * S(0.5) + x.R * (gamma_2(phi, c) * f)) * dt) * dt;
  return next;
}

namespace strapdown_detail {
/// Returns the derivative d(b (phi x a) + c phi x (phi x a))/d(phi). The coefficients have the
/// derivatives d(b) = b_rate phi^T d(phi) and d(c) = c_rate phi^T d(phi).
inline Mat3<double> slope(const Vec3<double>& phi, const Vec3<double>& a, double b, double c,
                          double b_rate, double c_rate) {
  const Vec3<double> once = cross(phi, a), twice = cross(phi, once);
  const Vec3<double> radial = once * b_rate + twice * c_rate;
  const auto along = [&](const Vec3<double>& e, double phi_e) {
    return cross(e, a) * b + (cross(e, once) + cross(phi, cross(e, a))) * c + radial * phi_e;
  };
  return {along({1, 0, 0}, phi.x), along({0, 1, 0}, phi.y), along({0, 0, 1}, phi.z)};
}
}  // namespace strapdown_detail

/// Returns the derivative d(Gamma_1(phi) a)/d(phi).
inline Mat3<double> gamma_1_slope(const Vec3<double>& phi, const RotationSeries<double>& c,
                                  const Vec3<double>& a) {
  return strapdown_detail::slope(phi, a, c.c2, c.c3, 2.0 * c.c4 - c.c3, 3.0 * c.c5 - c.c4);
}
/// Returns the derivative d(Gamma_2(phi) a)/d(phi).
inline Mat3<double> gamma_2_slope(const Vec3<double>& phi, const RotationSeries<double>& c,
                                  const Vec3<double>& a) {
  return strapdown_detail::slope(phi, a, c.c3, c.c4, 3.0 * c.c5 - c.c4, 4.0 * c.c6 - c.c5);
}

}  // namespace burnish

// An inertial measurement unit integrated over a tick in which its readings are held, which is
// exact: R exp(phi), and velocities and positions with
//   Gamma_1(phi) = sum phi^n/(n + 1)!,   Gamma_2(phi) = sum phi^n/(n + 2)!,   phi = w dt
// (Hartley, Ghaffari, Eustice, Grizzle, "Contact-aided invariant extended Kalman filtering for
// robot state estimation", 2020, appendix on discretization). Their slopes are derived here.
#pragma once

#include "math/spatial.hpp"

namespace burnish {

/// Coefficients c_n = sum (-theta^2)^k/(n + 2k)! of powers of phi. They hang together by
/// c_n = 1/n! - theta^2 c_(n+2), and d(c_n) = (n c_(n+2) - c_(n+1)) phi^T d(phi).
template <class S>
struct RotationSeries {
  S c1, c2, c3, c4, c5, c6;
};

/// For one state at a time: it branches on the angle.
template <class S>
RotationSeries<S> rotation_series(const Vec3<S>& phi) {
  using std::cos, std::sin, std::sqrt;
  RotationSeries<S> r;
  const S square = dot(phi, phi), y = -square;
  if (square < S(1.0)) {  // the first terms that are omitted are below 1e-17
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

/// a exact + b (phi x) + c (phi x)^2.
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
  Mat3<S> R;     ///< unit -> world
  Vec3<S> v, p;  ///< of the unit in the world, m/s, m
};

/// dt s later; w: rad/s, f: specific force, m/s^2, both in the unit's axes and without bias;
/// gravity: world, m/s^2.
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
/// d(b (phi x a) + c phi x (phi x a))/d(phi), d(b) = b_rate phi^T d(phi), likewise of c.
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

/// d(Gamma_1(phi) a)/d(phi).
inline Mat3<double> gamma_1_slope(const Vec3<double>& phi, const RotationSeries<double>& c,
                                  const Vec3<double>& a) {
  return strapdown_detail::slope(phi, a, c.c2, c.c3, 2.0 * c.c4 - c.c3, 3.0 * c.c5 - c.c4);
}
/// d(Gamma_2(phi) a)/d(phi).
inline Mat3<double> gamma_2_slope(const Vec3<double>& phi, const RotationSeries<double>& c,
                                  const Vec3<double>& a) {
  return strapdown_detail::slope(phi, a, c.c3, c.c4, 3.0 * c.c5 - c.c4, 4.0 * c.c6 - c.c5);
}

}  // namespace burnish

// Tests of strapdown integration: IMU readings over a tick are integrated exactly, with exact
// derivatives.
#include "estimate/strapdown.hpp"

#include <gtest/gtest.h>

#include <random>

#include "estimate/truth.hpp"
#include "support/autodiff.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

InertialState<double> random_state(std::mt19937_64& generator) {
  return {from_eigen(exp3(normal3(generator, 1.0))), from_eigen(normal3(generator, 2.0)),
          from_eigen(normal3(generator, 3.0))};
}

/// Zero, and angles on both sides of the branch at 1 rad.
const std::vector<double> angles = {0.0, 1e-9, 1e-4, 0.02, 0.7, 0.9999999, 1.0000001, 2.5, 6.0};

Vec3<double> some_vector(std::mt19937_64& generator, double length) {
  return from_eigen(Vector3d(length * normal3(generator, 1.0).normalized()));
}

TEST(Strapdown, RotationSeries_EqualTheExponentialSeries) {
  std::mt19937_64 generator(1);
  for (const double angle : angles) {
    const Vec3<double> phi = some_vector(generator, angle);
    const RotationSeries<double> c = rotation_series(phi);
    Matrix3d power = Matrix3d::Identity(), e = Matrix3d::Zero(), g1 = e, g2 = e, cross = e;
    cross << 0.0, -phi.z, phi.y, phi.z, 0.0, -phi.x, -phi.y, phi.x, 0.0;
    double factorial = 1.0;
    for (int n = 0; n < 60; ++n) {
      e += power / factorial;
      g1 += power / (factorial * (n + 1));
      g2 += power / (factorial * (n + 1) * (n + 2));
      power *= cross;
      factorial *= n + 1;
    }
    EXPECT_LT((to_eigen(exp_matrix(phi, c)) - e).norm(), 1e-13) << angle;
    EXPECT_LT((to_eigen(gamma_1(phi, c)) - g1).norm(), 1e-13) << angle;
    EXPECT_LT((to_eigen(gamma_2(phi, c)) - g2).norm(), 1e-13) << angle;
  }
}

TEST(Strapdown, ConstantReadings_AreIntegratedExactly) {
  std::mt19937_64 generator(2);
  const Vec3<double> g = from_eigen(gravity);
  for (int trial = 0; trial < 20; ++trial) {
    const InertialState<double> start = random_state(generator);
    const Vec3<double> w = from_eigen(normal3(generator, 3.0)),
                       f = from_eigen(normal3(generator, 9.0));
    InertialState<double> small = start;
    for (int i = 0; i < 64; ++i) small = strapdown(small, w, f, g, 0.5 / 64);
    const InertialState<double> whole = strapdown(start, w, f, g, 0.5);
    EXPECT_LT((to_eigen(small.R) - to_eigen(whole.R)).norm(), 1e-12);
    EXPECT_LT((to_eigen(small.v) - to_eigen(whole.v)).norm(), 1e-11);
    EXPECT_LT((to_eigen(small.p) - to_eigen(whole.p)).norm(), 1e-11);
  }
}

TEST(Strapdown, Derivatives_AreExact) {
  std::mt19937_64 generator(3);
  for (const double angle : angles) {
    const Vec3<double> phi = some_vector(generator, angle), a = some_vector(generator, 9.0);
    const RotationSeries<double> c = rotation_series(phi);
    for (const bool second : {false, true}) {
      const auto turned = [&](const auto& angles_of, const auto& vector) {
        const auto series = rotation_series(angles_of);
        return (second ? gamma_2(angles_of, series) : gamma_1(angles_of, series)) * vector;
      };
      const Matrix3d slope = to_eigen(second ? gamma_2_slope(phi, c, a) : gamma_1_slope(phi, c, a));
      const Vec3<Dual> seeded{Dual(phi.x, 0), Dual(phi.y, 1), Dual(phi.z, 2)};
      const Vec3<Dual> differentiated = turned(seeded, lift<Dual>(a));
      constexpr double h = 1e-5;
      for (int k = 0; k < 3; ++k) {
        const Vector3d exact(differentiated.x.derivative(k), differentiated.y.derivative(k),
                             differentiated.z.derivative(k));
        EXPECT_LT((slope.col(k) - exact).norm(), 1e-12) << angle;
        const Vector3d step = h * Vector3d::Unit(k), at = to_eigen(phi);
        const Vector3d difference = (to_eigen(turned(from_eigen(Vector3d(at + step)), a)) -
                                     to_eigen(turned(from_eigen(Vector3d(at - step)), a))) /
                                    (2.0 * h);
        EXPECT_LT((slope.col(k) - difference).norm(), 1e-8) << angle;
      }
    }
  }
}

TEST(Strapdown, Errors_PropagateIndependentlyOfTheState) {
  // One step maps exp(xi) X to exp(Phi xi) X'. Phi depends only on gravity and time, to all orders:
  // the logarithm is linear (Hartley et al., theorem on log-linear errors).
  std::mt19937_64 generator(4);
  const Vec3<double> g = from_eigen(gravity);
  constexpr double dt = 0.3;
  for (int trial = 0; trial < 20; ++trial) {
    const InertialState<double> x = random_state(generator);
    const Vector3d turn = normal3(generator, 0.8), of_v = normal3(generator, 1.0),
                   of_p = normal3(generator, 1.0);
    const auto moved = [](const InertialState<double>& from, const Vector3d& xi_R,
                          const Vector3d& xi_v, const Vector3d& xi_p) {
      const Vec3<double> phi = from_eigen(xi_R);
      const RotationSeries<double> c = rotation_series(phi);
      const Mat3<double> E = exp_matrix(phi, c), J = gamma_1(phi, c);
      return InertialState<double>{E * from.R, E * from.v + J * from_eigen(xi_v),
                                   E * from.p + J * from_eigen(xi_p)};
    };
    const Vec3<double> w = from_eigen(normal3(generator, 3.0)),
                       f = from_eigen(normal3(generator, 9.0));
    const InertialState<double> a = strapdown(moved(x, turn, of_v, of_p), w, f, g, dt);
    const Vector3d of_v_after = of_v + dt * gravity.cross(turn);
    const Vector3d of_p_after = of_p + dt * of_v + 0.5 * dt * dt * gravity.cross(turn);
    const InertialState<double> b = moved(strapdown(x, w, f, g, dt), turn, of_v_after, of_p_after);
    EXPECT_LT((to_eigen(a.R) - to_eigen(b.R)).norm(), 1e-12);
    EXPECT_LT((to_eigen(a.v) - to_eigen(b.v)).norm(), 1e-12);
    EXPECT_LT((to_eigen(a.p) - to_eigen(b.p)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace burnish::test

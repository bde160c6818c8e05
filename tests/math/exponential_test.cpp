// Tests of the exponential maps of rotations and placements, and of their right Jacobians.
#include "math/exponential.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "math/logarithm.hpp"
#include "math/pack.hpp"
#include "support/dual.hpp"
#include "support/random_unit.hpp"

namespace burnish {
namespace {

using Real = long double;
template <int n>
using RealMatrix = Eigen::Matrix<Real, n, n>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

// Angles on both sides of 0.5 and 1, where the series end, and beyond half a turn [rad].
constexpr double all_angles[] = {
    0.0, 1e-160, 1e-12, 1e-6, 1e-3, 0.1, 0.499999, 0.5, 0.7, 0.999999999999,
    1.0, 1.3,    2.0,   3.0,  3.14, 4.0, 6.0,      9.0};

using test::random_unit;

Motion<double> random_twist(double angle, std::mt19937_64& generator) {
  return {from_eigen(Eigen::Vector3d(2.0 * random_unit(generator))),
          from_eigen(Eigen::Vector3d(angle * random_unit(generator)))};
}

RealMatrix<3> skew(const Vec3<double>& w) {
  RealMatrix<3> m;
  m << 0.0L, -Real(w.z), Real(w.y), Real(w.z), 0.0L, -Real(w.x), -Real(w.y), Real(w.x), 0.0L;
  return m;
}

/// Sum over k of x^k / (k + n)!: for n = 0 the exponential, for n = 1 (exp(x) - 1) / x.
template <int size>
RealMatrix<size> series(const RealMatrix<size>& x, int n) {
  RealMatrix<size> term = RealMatrix<size>::Identity(), sum = term;
  for (int k = 1; k < 90; ++k) {
    term = (term * x / Real(k + n)).eval();
    sum += term;
  }
  return sum;
}

RealMatrix<4> placement(const Motion<double>& xi) {
  RealMatrix<4> x = RealMatrix<4>::Zero();
  x.topLeftCorner<3, 3>() = skew(xi.angular);
  x.topRightCorner<3, 1>() = to_eigen(xi.linear).cast<Real>();
  return series<4>(x, 0);
}

RealMatrix<6> ad(const Motion<double>& xi) {
  RealMatrix<6> x = RealMatrix<6>::Zero();
  x.topLeftCorner<3, 3>() = x.bottomRightCorner<3, 3>() = skew(xi.angular);
  x.topRightCorner<3, 3>() = skew(xi.linear);
  return x;
}

Vector6 to_vector(const Motion<double>& m) {
  Vector6 x;
  x << to_eigen(m.linear), to_eigen(m.angular);
  return x;
}

/// Bound on rounding errors, which grow with the angle like the powers of ad.
double rounding(double angle) { return 4e-15 * (1.0 + angle * angle); }

TEST(ExpCoefficients, AllAngles_EqualExtendedPrecisionSums) {
  for (const double angle : all_angles) {
    const auto c_of = [&](int n) {
      Real term = 1.0L;
      for (int k = 2; k <= n; ++k) term /= Real(k);
      Real sum = term;
      for (int k = n + 2; k < 120; k += 2) {
        term *= -Real(angle) * Real(angle) / (Real(k - 1) * Real(k));
        sum += term;
      }
      return sum;
    };
    const ExpCoefficients<double> c = exp_coefficients(angle);
    const Real c1 = c_of(1), c2 = c_of(2), c3 = c_of(3), c4 = c_of(4), c5 = c_of(5);
    const Real want[] = {
        c2, c3, 2 * c2 - c1 / 2, (5 * c3 - c2) / 2, c3 / 2 - c4, (c4 - 3 * c5) / 2};
    const double got[] = {c.so3_1, c.so3_2, c.se3_1, c.se3_2, c.se3_3, c.se3_4};
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(got[i], static_cast<double>(want[i]), 1e-15) << angle << ", coefficient " << i;
  }
}

TEST(ExpCoefficients, SeriesAndClosedForm_AgreeAtTheSwitch) {
  const auto below = exp_coefficients(std::nextafter(1.0, 0.0)), above = exp_coefficients(1.0);
  EXPECT_NEAR(below.so3_1, above.so3_1, 1e-15);
  EXPECT_NEAR(below.so3_2, above.so3_2, 1e-15);
  EXPECT_NEAR(below.se3_1, above.se3_1, 1e-15);
  EXPECT_NEAR(below.se3_2, above.se3_2, 1e-15);
  EXPECT_NEAR(below.se3_3, above.se3_3, 1e-15);
  EXPECT_NEAR(below.se3_4, above.se3_4, 1e-15);
  const Vec3<double> w{1.0, 0.0, 0.0};
  EXPECT_NEAR(exp_rotation(w, std::nextafter(0.5, 0.0)).vector.x, exp_rotation(w, 0.5).vector.x,
              1e-15);
}

TEST(ExpRotation, AllAngles_EqualTheMatrixSeries) {
  std::mt19937_64 generator(1);
  for (const double angle : all_angles)
    for (int i = 0; i < 20; ++i) {
      const Vec3<double> w = random_twist(angle, generator).angular;
      const Quaternion<double> got = exp_rotation(w, rotation_angle(w));
      const Eigen::Quaterniond as_eigen(got.w, got.vector.x, got.vector.y, got.vector.z);
      EXPECT_NEAR(as_eigen.norm(), 1.0, 1e-15);
      const Eigen::Matrix3d want = series<3>(skew(w), 0).cast<double>();
      EXPECT_LE((as_eigen.toRotationMatrix() - want).norm(), rounding(angle)) << angle;
    }
}

TEST(ExpPosition, AllAngles_EqualThePlacementSeries) {
  std::mt19937_64 generator(2);
  for (const double angle : all_angles)
    for (int i = 0; i < 20; ++i) {
      const Motion<double> xi = random_twist(angle, generator);
      const ExpCoefficients<double> c = exp_coefficients(rotation_angle(xi.angular));
      const Eigen::Vector3d got = to_eigen(exp_position(c, xi.angular, xi.linear));
      const Eigen::Vector3d want = placement(xi).topRightCorner<3, 1>().cast<double>();
      EXPECT_LE((got - want).norm(), rounding(angle)) << angle;
    }
}

TEST(RightJacobian, AllAngles_EqualItsSeries) {
  std::mt19937_64 generator(3);
  for (const double angle : all_angles)
    for (int i = 0; i < 20; ++i) {
      const Motion<double> xi = random_twist(angle, generator), m = random_twist(1.0, generator);
      const ExpCoefficients<double> c = exp_coefficients(rotation_angle(xi.angular));
      const Vector6 want = series<6>(-ad(xi), 1).cast<double>() * to_vector(m);
      EXPECT_LE((to_vector(d_exp_placement(c, xi, m)) - want).norm(), 4.0 * rounding(angle))
          << angle;
      const Eigen::Vector3d want_3 =
          series<3>(-skew(xi.angular), 1).cast<double>() * to_eigen(m.angular);
      EXPECT_LE((to_eigen(d_exp_rotation(c, xi.angular, m.angular)) - want_3).norm(),
                rounding(angle))
          << angle;
    }
}

TEST(RightJacobian, LogarithmDerivative_IsItsInverse) {
  std::mt19937_64 generator(4);
  for (const double angle : all_angles) {
    if (angle > 3.1416) continue;
    for (int i = 0; i < 20; ++i) {
      const Motion<double> xi = random_twist(angle, generator), m = random_twist(1.0, generator);
      const double theta = rotation_angle(xi.angular);
      const Motion<double> back = d_log_placement(log_coefficients(theta), xi,
                                                  d_exp_placement(exp_coefficients(theta), xi, m));
      EXPECT_LE((to_vector(back) - to_vector(m)).norm(), 1e-13) << angle;
      const Vec3<double> back_3 =
          d_log_rotation(log_coefficients(theta), xi.angular,
                         d_exp_rotation(exp_coefficients(theta), xi.angular, m.angular));
      EXPECT_LE((to_eigen(back_3) - to_eigen(m.angular)).norm(), 1e-13) << angle;
    }
  }
}

TEST(RightJacobian, AllAngles_EqualAutomaticDifferentiation) {
  using test::Dual;
  std::mt19937_64 generator(5);
  for (const double angle : all_angles) {
    const Motion<double> xi = random_twist(angle, generator);
    const auto seeded = [](double value, int k) { return Dual(value, k); };
    const Vec3<Dual> v{seeded(xi.linear.x, 0), seeded(xi.linear.y, 1), seeded(xi.linear.z, 2)};
    const Vec3<Dual> w{seeded(xi.angular.x, 3), seeded(xi.angular.y, 4), seeded(xi.angular.z, 5)};
    const Dual theta = rotation_angle(w);
    const Vec3<Dual> p = exp_position(exp_coefficients(theta), w, v);
    const Quaternion<Dual> turn = exp_rotation(w, theta);
    const Eigen::Quaterniond R(turn.w.value(), turn.vector.x.value(), turn.vector.y.value(),
                               turn.vector.z.value());
    const ExpCoefficients<double> c = exp_coefficients(rotation_angle(xi.angular));
    for (int k = 0; k < 6; ++k) {
      // The twist in its own axes: R^T dp, and twice the vector part of conj(q) dq.
      const Eigen::Vector3d dp(p.x.derivative(k), p.y.derivative(k), p.z.derivative(k));
      const Eigen::Quaterniond dq(turn.w.derivative(k), turn.vector.x.derivative(k),
                                  turn.vector.y.derivative(k), turn.vector.z.derivative(k));
      Vector6 want;
      want << R.conjugate() * dp, 2.0 * (R.conjugate() * dq).vec();
      const Vector6 unit = Vector6::Unit(k);
      const Motion<double> m{from_eigen(Eigen::Vector3d(unit.head<3>())),
                             from_eigen(Eigen::Vector3d(unit.tail<3>()))};
      EXPECT_LE((to_vector(d_exp_placement(c, xi, m)) - want).norm(), 1e-13) << angle;
    }
  }
}

TEST(Exponential, PackLanes_EqualScalarResults) {
  std::mt19937_64 generator(6);
  constexpr double angle_of[] = {0.0, 1e-9, 0.49, 0.51, 0.99, 1.01, 3.1, 7.0};
  Motion<double> xi[8], m[8];
  Motion<Pack<8>> packed_xi, packed_m;
  const auto set_lane = [](Motion<Pack<8>>& pack, int lane, const Motion<double>& value) {
    const Vector6 x = to_vector(value);
    Pack<8>* entries[] = {&pack.linear.x,  &pack.linear.y,  &pack.linear.z,
                          &pack.angular.x, &pack.angular.y, &pack.angular.z};
    for (int i = 0; i < 6; ++i) entries[i]->v[lane] = x[i];
  };
  for (int l = 0; l < 8; ++l) {
    set_lane(packed_xi, l, xi[l] = random_twist(angle_of[l], generator));
    set_lane(packed_m, l, m[l] = random_twist(1.0, generator));
  }
  const Pack<8> theta = rotation_angle(packed_xi.angular);
  const ExpCoefficients<Pack<8>> c = exp_coefficients(theta);
  const Quaternion<Pack<8>> turn = exp_rotation(packed_xi.angular, theta);
  const Vec3<Pack<8>> p = exp_position(c, packed_xi.angular, packed_xi.linear);
  const Motion<Pack<8>> rate = d_exp_placement(c, packed_xi, packed_m);
  for (int l = 0; l < 8; ++l) {
    const double one = rotation_angle(xi[l].angular);
    const ExpCoefficients<double> one_c = exp_coefficients(one);
    const Quaternion<double> one_turn = exp_rotation(xi[l].angular, one);
    const Vec3<double> one_p = exp_position(one_c, xi[l].angular, xi[l].linear);
    const Motion<double> one_rate = d_exp_placement(one_c, xi[l], m[l]);
    const double bound = rounding(angle_of[l]);
    EXPECT_NEAR(turn.w.lane(l), one_turn.w, 2e-15);
    EXPECT_NEAR(turn.vector.x.lane(l), one_turn.vector.x, 2e-15);
    EXPECT_NEAR(turn.vector.z.lane(l), one_turn.vector.z, 2e-15);
    EXPECT_NEAR(p.x.lane(l), one_p.x, bound);
    EXPECT_NEAR(p.y.lane(l), one_p.y, bound);
    EXPECT_NEAR(rate.linear.x.lane(l), one_rate.linear.x, bound);
    EXPECT_NEAR(rate.linear.z.lane(l), one_rate.linear.z, bound);
    EXPECT_NEAR(rate.angular.y.lane(l), one_rate.angular.y, bound);
  }
}

}  // namespace
}  // namespace burnish

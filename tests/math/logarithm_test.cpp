// Tests of the logarithms of rotations and placements, and of their derivatives.
#include "math/logarithm.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "math/pack.hpp"
#include "support/random_unit.hpp"

namespace burnish {
namespace {

using test::random_unit;

Eigen::Matrix3d rotation(const Eigen::Vector3d& phi) {
  const double angle = phi.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, phi / angle).toRotationMatrix();
}

Eigen::Vector3d log_of(const Eigen::Matrix3d& R) {
  double theta = 0.0;
  return to_eigen(log_rotation(from_eigen(R), theta));
}

Motion<double> log_of(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  double theta = 0.0;
  const Vec3<double> phi = log_rotation(from_eigen(R), theta);
  return log_placement(log_coefficients(theta), phi, from_eigen(p));
}

/// Exponential of a twist by its power series: independent of the closed forms under test.
Eigen::Matrix4d exponential(const Motion<double>& xi) {
  Eigen::Matrix4d x = Eigen::Matrix4d::Zero();
  x.block<3, 3>(0, 0) << 0, -xi.angular.z, xi.angular.y, xi.angular.z, 0, -xi.angular.x,
      -xi.angular.y, xi.angular.x, 0;
  x.block<3, 1>(0, 3) = to_eigen(xi.linear);
  Eigen::Matrix4d sum = Eigen::Matrix4d::Identity(), term = sum;
  for (int k = 1; k < 60; ++k) {
    term = term * x / k;
    sum += term;
  }
  return sum;
}

TEST(LogRotation, AllAngles_InvertTheExponential) {
  std::mt19937_64 generator(1);
  for (const double angle :
       {0.0, 1e-12, 1e-8, 1e-5, 1e-3, 0.1, 0.69, 0.71, 1.0, 2.0, 3.0, 3.14, 3.1415926})
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d phi = angle * random_unit(generator);
      EXPECT_LE((log_of(rotation(phi)) - phi).norm(), 1e-12 + 1e-9 * (angle > 3.1 ? 1.0 : 0.0))
          << "angle " << angle;
    }
}

TEST(LogRotation, HalfATurn_IsFiniteAndOfLengthPi) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Matrix3d R = rotation(M_PI * Eigen::Vector3d::Unit(axis));
    EXPECT_NEAR(log_of(R).norm(), M_PI, 1e-12);
    EXPECT_NEAR(std::abs(log_of(R)[axis]), M_PI, 1e-12);
  }
}

TEST(LogRotation, Identity_IsZeroWithFiniteCoefficients) {
  double theta = 1.0;
  const Vec3<double> phi = log_rotation(Mat3<double>::identity(), theta);
  EXPECT_EQ(theta, 0.0);
  EXPECT_EQ(to_eigen(phi).norm(), 0.0);
  const auto c = log_coefficients(theta);
  EXPECT_DOUBLE_EQ(c.so3, 1.0 / 12);
  EXPECT_DOUBLE_EQ(c.se3_2, 1.0 / 12);
  EXPECT_DOUBLE_EQ(c.se3_4, -1.0 / 720);
}

TEST(LogCoefficients, SeriesAndClosedForm_AgreeAtTheSwitch) {
  const auto below = log_coefficients(0.7 - 1e-9), above = log_coefficients(0.7 + 1e-9);
  EXPECT_NEAR(below.so3, above.so3, 1e-10);
  EXPECT_NEAR(below.se3_2, above.se3_2, 1e-10);
  EXPECT_NEAR(below.se3_4, above.se3_4, 1e-10);
}

TEST(LogPlacement, AllAngles_InvertTheExponential) {
  std::mt19937_64 generator(2);
  for (const double angle : {1e-6, 0.3, 0.69, 0.71, 1.5, 3.0})
    for (int i = 0; i < 20; ++i) {
      const Motion<double> xi{from_eigen(Eigen::Vector3d(2.0 * random_unit(generator))),
                              from_eigen(Eigen::Vector3d(angle * random_unit(generator)))};
      const Eigen::Matrix4d M = exponential(xi);
      const Motion<double> back = log_of(M.topLeftCorner<3, 3>(), M.topRightCorner<3, 1>());
      EXPECT_LE((to_eigen(back.linear) - to_eigen(xi.linear)).norm(), 1e-11) << angle;
      EXPECT_LE((to_eigen(back.angular) - to_eigen(xi.angular)).norm(), 1e-11) << angle;
    }
}

/// d/dt log(M exp(t m)) at t = 0 by differences of fourth order.
Motion<double> rate_by_differences(const Eigen::Matrix4d& M, const Motion<double>& m) {
  const auto at = [&](double t) {
    const Eigen::Matrix4d moved = M * exponential(m * t);
    return log_of(moved.topLeftCorner<3, 3>(), moved.topRightCorner<3, 1>());
  };
  const double h = 1e-3;
  return ((at(h) - at(-h)) * (4.0 / 3.0) - (at(2 * h) - at(-2 * h)) * (1.0 / 6.0)) *
         (1.0 / (2 * h));
}

TEST(LogPlacement, Derivative_EqualsDifferencesOnBothSidesOfTheSwitch) {
  std::mt19937_64 generator(3);
  for (const double angle : {1e-9, 0.05, 0.4, 0.68, 0.72, 1.5, 2.8})
    for (int i = 0; i < 20; ++i) {
      const Motion<double> xi{from_eigen(Eigen::Vector3d(random_unit(generator))),
                              from_eigen(Eigen::Vector3d(angle * random_unit(generator)))};
      const Motion<double> m{from_eigen(random_unit(generator)),
                             from_eigen(random_unit(generator))};
      const Motion<double> got = d_log_placement(log_coefficients(angle), xi, m);
      const Motion<double> want = rate_by_differences(exponential(xi), m);
      EXPECT_LE((to_eigen(got.linear) - to_eigen(want.linear)).norm(), 1e-8) << angle;
      EXPECT_LE((to_eigen(got.angular) - to_eigen(want.angular)).norm(), 1e-8) << angle;
      // The angular part of SE(3) is SO(3) alone.
      const Vec3<double> alone = d_log_rotation(log_coefficients(angle), xi.angular, m.angular);
      EXPECT_LE((to_eigen(got.angular) - to_eigen(alone)).norm(), 1e-11) << angle;
    }
}

TEST(LogRotation, PackLanes_EqualScalarResults) {
  std::mt19937_64 generator(4);
  constexpr double angles[] = {0.0, 1e-9, 0.3, 0.7, 1.5, 2.5, 3.1, 3.14159};
  Mat3<Pack<8>> R;
  Eigen::Vector3d want[8];
  double want_theta[8];
  for (int l = 0; l < 8; ++l) {
    const Eigen::Matrix3d r = rotation(angles[l] * random_unit(generator));
    Vec3<Pack<8>>* columns[] = {&R.c0, &R.c1, &R.c2};
    for (int c = 0; c < 3; ++c) {
      columns[c]->x.v[l] = r(0, c);
      columns[c]->y.v[l] = r(1, c);
      columns[c]->z.v[l] = r(2, c);
    }
    want[l] = to_eigen(log_rotation(from_eigen(r), want_theta[l]));
  }
  Pack<8> theta;
  const Vec3<Pack<8>> phi = log_rotation(R, theta);
  for (int l = 0; l < 8; ++l) {
    EXPECT_NEAR(theta.lane(l), want_theta[l], 1e-14);
    EXPECT_NEAR(phi.x.lane(l), want[l].x(), 1e-14);
    EXPECT_NEAR(phi.y.lane(l), want[l].y(), 1e-14);
    EXPECT_NEAR(phi.z.lane(l), want[l].z(), 1e-14);
  }
}

}  // namespace
}  // namespace burnish

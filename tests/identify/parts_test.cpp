// Tests of the parts of identification: smoothing, and log-Cholesky coordinates of inertias.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "identify/log_cholesky.hpp"
#include "identify/smoothed_motion.hpp"
#include "identify/smoothing.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using identify_detail::LogCholesky;
using identify_detail::Matrix10;
using identify_detail::Smoother;

TEST(Smoothing, PolynomialOfDegreeFive_IsReproduced) {
  const double period = 1e-3;
  const Smoother smoother(40, period);
  Eigen::VectorXd signal(201);
  for (int i = 0; i < 201; ++i) {
    const double t = period * (i - 100);
    signal[i] = 1.0 + 2.0 * t - 3.0 * t * t + 40.0 * t * t * t - 500.0 * t * t * t * t +
                900.0 * t * t * t * t * t;
  }
  EXPECT_NEAR(smoother.at(signal, 100, 0), 1.0, 1e-12);
  EXPECT_NEAR(smoother.at(signal, 100, 1), 2.0, 1e-9);
  EXPECT_NEAR(smoother.at(signal, 100, 2), -6.0, 1e-7);
}

TEST(Smoothing, WhiteNoise_IsReducedByTheExpectedFactor) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> draw;
  const Smoother smoother(60, 1e-3);
  double square = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    Eigen::VectorXd noise(121);
    for (double& x : noise) x = draw(generator);
    square += std::pow(smoother.at(noise, 60, 0), 2);
  }
  // Variance of the smoothed noise: 225/64 / samples, for a fit of degree 4 or 5 at the middle.
  EXPECT_NEAR(std::sqrt(square / 400.0), std::sqrt(225.0 / 64.0 / 121.0), 0.03);
}

TEST(Smoothing, WindowMeans_PassLowFrequenciesOnly) {
  const int half = 50;
  const Eigen::VectorXd weights = identify_detail::bell(half);
  EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
  const auto left_of = [&](double turns_per_window) {
    double sum = 0.0;
    for (int i = -half; i <= half; ++i)
      sum += weights[i + half] * std::cos(M_PI * turns_per_window * i / half);
    return std::abs(sum);
  };
  EXPECT_GT(left_of(0.25), 0.95);
  for (double turns = 4.0; turns < 20.0; turns += 0.1) EXPECT_LT(left_of(turns), 1e-3) << turns;
}

TEST(LogCholesky, Inertia_RoundTripsWithExactDerivatives) {
  std::mt19937_64 generator(2);
  for (int trial = 0; trial < 20; ++trial) {
    const InertiaSpec solid = testing::random_inertia(generator);
    const Vector10 eta = LogCholesky::of(solid);
    EXPECT_TRUE(LogCholesky::parameters(eta).isApprox(inertia_parameters(solid), 1e-10));
    const Matrix10 D = LogCholesky::derivative(eta);
    for (int k = 0; k < 10; ++k) {
      const Vector10 h = 1e-6 * Vector10::Unit(k);
      const Vector10 by =
          (LogCholesky::parameters(eta + h) - LogCholesky::parameters(eta - h)) / 2e-6;
      EXPECT_LE((D.col(k) - by).cwiseAbs().maxCoeff(), 1e-7 * (1.0 + by.cwiseAbs().maxCoeff()));
    }
  }
}

TEST(LogCholesky, AnyCoordinates_GiveAPhysicalInertia) {
  std::mt19937_64 generator(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Vector10 theta = LogCholesky::parameters(random_vector(10, 2.0, generator));
    EXPECT_EQ(check_inertia(inertia_of(theta)), Status::Ok);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(pseudo_inertia(theta));
    EXPECT_GT(solver.eigenvalues()[0], 0.0);
  }
}

}  // namespace
}  // namespace burnish::test

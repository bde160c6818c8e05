// Tests of the surface estimated from the path of a tip that slides on it.
#include "burnish/estimate/surface_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "burnish/dynamics/reference.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using Kind = SurfaceShape::Kind;

constexpr double period = 5e-4, radius = 0.02, degree = std::numbers::pi / 180.0;

double angle(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Spherical tip that is pressed on the true surface and slides out to a circle and around it.
struct Slide {
  Surface truth;
  double compliance = 1e-5;  ///< compliance of the surface [m/N]
  double step = 5e-5;        ///< resolution of measured positions [m]
  double force_noise = 0.3;  ///< force noise before a filter of 50 Hz [N]
  double noise = 0.0;        ///< white noise of positions [m]
  double drift = 0.0;        ///< velocity of the surface along z [m/s]
  std::mt19937_64 generator{3};
  double force = 6.0;

  Vector3d center(double t, double pressed) const {
    const double s = std::clamp((t - 0.5) / 2.0, 0.0, 1.0), turn = t - 0.5;
    const double r = 0.07 * s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
    const Vector3d on = truth.along_normal({r * std::cos(turn), r * std::sin(turn), 0.0});
    return on + (radius - compliance * pressed) * truth.at(on).normal +
           drift * t * Vector3d::UnitZ();
  }
  /// Runs from `begin` to `end` [s]: half a second to press, then the sliding path.
  void run(SurfaceEstimator& estimator, double begin, double end) {
    std::normal_distribution<double> gaussian(0.0, 1.0);
    for (double t = begin; t < end; t += period) {
      const double pressed = 6.0 + 24.0 * std::min(1.0, t / 0.5);
      Vector3d p = center(t, pressed);
      for (double& x : p) x = step * std::round(x / step) + noise * gaussian(generator);
      force += 0.15 * (pressed + force_noise * gaussian(generator) - force);
      estimator.update(p, force, true);
    }
  }
  /// Returns the largest error of the normal between `begin` and `end` [rad].
  double worst(SurfaceEstimator& estimator, double begin, double end) {
    double result = 0.0;
    for (double t = begin; t < end; t += 0.02) {
      run(estimator, t, t + 0.02);
      result = std::max(result, error(estimator, t + 0.02));
    }
    return result;
  }
  double error(const SurfaceEstimator& estimator, double t) const {
    return angle(estimator.normal(),
                 truth.at(center(t, 30.0) - drift * t * Vector3d::UnitZ()).normal);
  }
};

Surface plane(const Vector3d& normal) { return {{}, Vector3d::Zero(), normal}; }

const Vector3d tilted = Vector3d(std::sin(6.0 * degree), -std::sin(4.0 * degree), 1.0).normalized();

TEST(SurfaceEstimate, TiltedPlane_IsFoundAfterAFewCentimetres) {
  SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, {}, period);
  Slide slide{.truth = plane(tilted)};
  slide.run(estimator, 0.0, 0.6);
  EXPECT_GT(estimator.normal_deviation(), 3.0 * degree);
  slide.run(estimator, 0.6, 1.9);  // 5 cm of travel
  EXPECT_LT(slide.error(estimator, 1.9), 0.3 * degree);
  EXPECT_LT(slide.worst(estimator, 1.9, 6.0), 0.3 * degree);
  EXPECT_LT(slide.error(estimator, 6.0), 2.0 * estimator.normal_deviation());
  EXPECT_LT(estimator.normal_deviation(), 1.0 * degree);
}

TEST(SurfaceEstimate, ExactlyGivenPlane_StaysAccurate) {
  const Surface exact = plane(tilted);
  SurfaceEstimator estimator(exact, radius, {}, period);
  Slide slide{.truth = exact};
  // Over the first millimetre, position steps of 50 um look like slopes of 50 mrad.
  EXPECT_LT(slide.worst(estimator, 0.0, 2.0), 2.0 * degree);
  EXPECT_LT(slide.worst(estimator, 2.0, 6.0), 0.15 * degree);
}

TEST(SurfaceEstimate, CurvatureWrongByAFifth_FollowsTheSurface) {
  const auto worst = [](SurfaceShape shape) {
    SurfaceEstimator estimator(Surface(shape, Vector3d::Zero(), Vector3d::UnitZ()), radius, {},
                               period);
    shape.radius *= 0.8;
    shape.ring *= 0.8;
    shape.curvature *= 1.2;
    Slide slide{.truth = Surface(shape, Vector3d::Zero(), tilted)};
    slide.run(estimator, 0.0, 2.5);
    return slide.worst(estimator, 2.5, 6.0) / degree;
  };
  EXPECT_LT(worst({.kind = Kind::Sphere, .radius = 0.3}), 0.5);
  EXPECT_LT(worst({.kind = Kind::Saddle, .curvature = {2.0, -3.0}}), 1.0);
  // A tilted cylinder is not a quadric over a whole circle: the estimate converges only in part.
  EXPECT_LT(worst({.kind = Kind::Cylinder, .radius = 0.3}), 2.5);
  EXPECT_LT(worst({.kind = Kind::Torus, .radius = 0.3}), 2.5);
}

TEST(SurfaceEstimate, MovingSurface_IsNotTakenForASlope) {
  for (const double drift : {-5e-3, 5e-3}) {
    const SurfaceEstimateOptions moves{.rate = 5e-3};
    SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, moves, period);
    Slide slide{.truth = plane(tilted), .drift = drift};
    slide.run(estimator, 0.0, 2.5);
    // At 70 mm/s, a surface that rises by 5 mm/s looks like a slope of 4 degrees.
    EXPECT_LT(slide.worst(estimator, 2.5, 6.0), 1.0 * degree) << drift;
    const Vector3d p = slide.center(6.0, 30.0);
    EXPECT_LT(std::abs(estimator.surface().value(p)), 1e-3) << drift;
  }
}

TEST(SurfaceEstimate, SoftSurface_GivesItsComplianceAndNormal) {
  for (const double compliance : {1e-6, 1e-4, 2e-3}) {
    SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, {}, period);
    Slide slide{.truth = plane(tilted), .compliance = compliance};
    slide.run(estimator, 0.0, 3.0);
    EXPECT_LT(slide.worst(estimator, 3.0, 6.0), (compliance < 1e-3 ? 0.3 : 1.0) * degree)
        << compliance;
    EXPECT_NEAR(estimator.compliance(), compliance, 2e-6 + 0.1 * compliance);
  }
}

TEST(SurfaceEstimate, PositionNoise_LeavesTheNormalAccurate) {
  for (const double noise : {1e-4, 7e-4}) {
    SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, {}, period);
    Slide slide{.truth = plane(tilted), .noise = noise};
    EXPECT_LT(slide.worst(estimator, 0.0, 3.0), 12.0 * degree);
    EXPECT_LT(slide.worst(estimator, 3.0, 6.0), 2.0 * degree) << noise;
  }
}

TEST(SurfaceEstimate, NoContactOrDisabled_KeepsTheAssumedSurface) {
  const Surface sphere({.kind = Kind::Sphere, .radius = 0.3}, Vector3d::Zero(), Vector3d::UnitZ());
  SurfaceEstimateOptions off;
  off.enabled = false;
  SurfaceEstimator air(sphere, radius, {}, period), blind(sphere, radius, off, period);
  for (double t = 0.0; t < 0.1; t += period) {
    const Vector3d p(t, 0.3 * t, 0.1);
    air.update(p, 0.0, false);
    blind.update(p, 30.0, true);
    EXPECT_EQ(air.normal(), sphere.at(p).normal);
    EXPECT_EQ(blind.normal(), sphere.at(p).normal);
    EXPECT_NEAR(air.surface().value(p), sphere.at(p).distance - radius, 1e-15);
  }
}

TEST(SurfaceEstimate, WildInput_KeepsTheEstimateFinite) {
  SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, {}, period);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937_64 generator(4);
  std::normal_distribution<double> wild(0.0, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d p = i % 7 == 0 ? Vector3d(nan, 0.0, 0.0)
                                  : Vector3d(wild(generator), wild(generator), wild(generator));
    estimator.update(p, i % 11 == 0 ? nan : 100.0 * wild(generator), i % 5 != 0);
    ASSERT_TRUE(estimator.surface().is_finite());
    ASSERT_NEAR(estimator.normal().norm(), 1.0, 1e-9);
  }
}

TEST(SurfaceEstimate, Update_AllocatesNothing) {
  SurfaceEstimator estimator(plane(Vector3d::UnitZ()), radius, {}, period);
  Slide slide{.truth = plane(tilted)};
  const Vector3d p = slide.center(1.0, 30.0);
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) estimator.update(p + i * 1e-5 * Vector3d::UnitX(), 30.0, true);
  EXPECT_EQ(guard.count(), 0);
}

TEST(SurfaceEstimate, ZeroDeviation_IsRefused) {
  SurfaceEstimateOptions options;
  options.tilt = 0.0;
  const std::string sentence = testing::refusal(
      [&] { SurfaceEstimator(plane(Vector3d::UnitZ()), radius, options, period); });
  EXPECT_NE(sentence.find("surface estimate: tilt"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace burnish::test

// Tests of the friction coefficient, estimated from tangential forces while a tool slides.
#include "burnish/estimate/friction_estimate.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;

/// Force on a tool that slides on a circle with Coulomb friction under a normal force of 30 N. The
/// noise is 0.3 N with a correlation time of 3 ms, typical of a force sensor.
struct Sliding {
  double coefficient = 0.3, speed = 0.07, rate = 1.0, noise = 0.3;
  std::mt19937_64 generator{7};
  Vector3d sensed = Vector3d::Zero();

  void run(FrictionEstimator& estimate, double seconds) {
    constexpr double dt = 5e-4;
    std::normal_distribution<double> normal(0.0, noise * std::sqrt(2.0 * 3e-3 / dt));
    for (double t = 0.0; t < seconds; t += dt) {
      const Vector3d along(std::cos(rate * t), std::sin(rate * t), 0.0);
      sensed += dt / 3e-3 * (Vector3d(normal(generator), normal(generator), 0.0) - sensed);
      const Vector3d force = speed > 0.0 ? Vector3d(-coefficient * 30.0 * along) : Vector3d::Zero();
      estimate.update(30.0, force + sensed, speed * along, dt);
    }
  }
};

TEST(FrictionEstimate, OneCentimetreOfSliding_FindsTheCoefficient) {
  for (const double coefficient : {0.0, 0.1, 0.3, 0.6}) {
    FrictionEstimator estimate{FrictionEstimateOptions{}};
    Sliding sliding{.coefficient = coefficient};
    sliding.run(estimate, 0.15);
    EXPECT_NEAR(estimate.coefficient(), coefficient, 0.02) << coefficient;
    sliding.run(estimate, 2.0);
    EXPECT_NEAR(estimate.coefficient(), coefficient, 0.01) << coefficient;
    EXPECT_LT(estimate.deviation(), 0.02);
  }
}

TEST(FrictionEstimate, ChangedSurface_IsFollowed) {
  FrictionEstimator estimate{FrictionEstimateOptions{}};
  Sliding dry{.coefficient = 0.5}, wet{.coefficient = 0.2};
  dry.run(estimate, 2.0);
  wet.run(estimate, 2.0);
  EXPECT_NEAR(estimate.coefficient(), 0.2, 0.03);
}

TEST(FrictionEstimate, ToolAtRest_KeepsTheAssumedCoefficient) {
  FrictionEstimator estimate({.coefficient = 0.2});
  Sliding still{.speed = 0.0};
  still.run(estimate, 2.0);
  EXPECT_EQ(estimate.coefficient(), 0.2);
  estimate.update(-1.0, Vector3d::UnitX(), Vector3d::UnitX(), 5e-4);
  estimate.update(30.0, Vector3d::Constant(std::nan("")), Vector3d::UnitX(), 5e-4);
  EXPECT_EQ(estimate.coefficient(), 0.2);
  Sliding{}.run(estimate, 1.0);
  EXPECT_NE(estimate.coefficient(), 0.2);
  estimate.reset();
  EXPECT_EQ(estimate.coefficient(), 0.2);
  FrictionEstimator disabled({.enabled = false, .coefficient = 0.2});
  Sliding{}.run(disabled, 1.0);
  EXPECT_EQ(disabled.coefficient(), 0.2);
}

TEST(FrictionEstimate, ForceAlongTheMotion_GivesNoNegativeCoefficient) {
  FrictionEstimator estimate{FrictionEstimateOptions{}};
  Sliding pushed{.coefficient = -0.5};
  pushed.run(estimate, 0.5);
  EXPECT_EQ(estimate.coefficient(), 0.0);
}

TEST(FrictionEstimate, OptionsOutOfRange_AreRefused) {
  const auto refused = [](const FrictionEstimateOptions& options) {
    return testing::refusal([&] { FrictionEstimator{options}; });
  };
  EXPECT_NE(refused({.coefficient = -0.1}).find("coefficient is -0.1"), std::string::npos);
  EXPECT_NE(refused({.deviation = 0.0}).find("deviation"), std::string::npos);
  EXPECT_NE(refused({.speed = 0.0}).find("speed is 0"), std::string::npos);
}

}  // namespace
}  // namespace burnish::test

// Tests of exact surfaces of every shape: distances, normals, curvature, texts and refusals.
#include "burnish/dynamics/surface_shape.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "burnish/dynamics/reference.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using Kind = SurfaceShape::Kind;

const Vector3d place(0.5, -0.3, 0.8), upwards(-0.3, 0.4, 1.2);

std::vector<SurfaceShape> shapes() {
  std::vector<SurfaceShape> all{
      {.kind = Kind::Plane},
      {.kind = Kind::Sphere, .radius = 0.3},
      {.kind = Kind::Cylinder, .radius = 0.25, .turn_deg = 30.0},
      {.kind = Kind::Cone, .radius = 0.3, .half_angle = 0.5},
      {.kind = Kind::Torus, .radius = 0.2, .ring = 0.5},
      {.kind = Kind::Ellipsoid, .semi_axes = {0.5, 0.3, 0.4}, .turn_deg = -20.0},
      {.kind = Kind::Saddle, .curvature = {1.5, -2.0}, .turn_deg = 10.0}};
  for (std::size_t i = 1; i + 1 < 7; ++i) {
    all.push_back(all[i]);
    all.back().hollow = true;
  }
  return all;
}

class SurfaceLaw : public ::testing::TestWithParam<SurfaceShape> {
 protected:
  Surface surface{GetParam(), place, upwards};
  Vector3d n = upwards.normalized();
  /// Random point near the surface.
  Vector3d near(std::mt19937_64& generator) const {
    std::uniform_real_distribution<double> across(-0.08, 0.08), above(-0.02, 0.05);
    const Eigen::Matrix3d axes = Reference::surface_with_normal(upwards).rotation;
    return surface.along_normal(place + across(generator) * axes.col(0) +
                                across(generator) * axes.col(1)) +
           above(generator) * n;
  }
};

TEST_P(SurfaceLaw, GivenPoint_HasZeroDistanceAndTheGivenNormal) {
  const SurfaceDistance at = surface.at(place);
  EXPECT_NEAR(at.distance, 0.0, 1e-15);
  EXPECT_LT((at.normal - n).norm(), 1e-14);
  EXPECT_GT(surface.at(place + 0.01 * n).distance, 0.0);
  EXPECT_LT(surface.at(place - 0.01 * n).distance, 0.0);
}

TEST_P(SurfaceLaw, NormalAndHessian_AreDerivativesOfTheDistance) {
  std::mt19937_64 generator(7);
  constexpr double h = 1e-5;
  for (int i = 0; i < 100; ++i) {
    const Vector3d x = near(generator);
    const SurfaceDistance at = surface.at(x);
    EXPECT_NEAR(at.normal.norm(), 1.0, 1e-14);
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = h * Vector3d::Unit(k);
      const SurfaceDistance more = surface.at(x + step), less = surface.at(x - step);
      EXPECT_NEAR((more.distance - less.distance) / (2.0 * h), at.normal[k], 1e-9);
      EXPECT_LT(((more.normal - less.normal) / (2.0 * h) - at.hessian.col(k)).norm(), 1e-7);
    }
    EXPECT_LT((at.hessian * at.normal).norm(), 1e-12);
    EXPECT_LT((at.hessian - at.hessian.transpose()).norm(), 1e-14);
  }
}

TEST_P(SurfaceLaw, Distance_LeadsToTheNearestPoint) {
  std::mt19937_64 generator(8);
  for (int i = 0; i < 100; ++i) {
    const Vector3d x = near(generator);
    const SurfaceDistance at = surface.at(x);
    const Vector3d foot = x - at.distance * at.normal;
    EXPECT_NEAR(surface.at(foot).distance, 0.0, 1e-13);
    for (int other = 0; other < 20; ++other)
      EXPECT_LE(std::abs(at.distance), (surface.along_normal(near(generator)) - x).norm() + 1e-12);
  }
}

TEST_P(SurfaceLaw, PointAlongTheNormal_IsOnTheSurface) {
  std::mt19937_64 generator(9);
  for (int i = 0; i < 50; ++i) {
    const Vector3d x = near(generator), on = surface.along_normal(x);
    EXPECT_NEAR(surface.at(on).distance, 0.0, 1e-13);
    EXPECT_LT((on - x).cross(n).norm(), 1e-14);
  }
}

TEST_P(SurfaceLaw, QuadricOfATip_MatchesTheDistanceToSecondOrder) {
  std::mt19937_64 generator(10);
  constexpr double radius = 0.02;
  for (int i = 0; i < 20; ++i) {
    const Vector3d x = near(generator);
    const Quadric quadric = surface.at(x).quadric(x, radius);
    EXPECT_NO_THROW(quadric.check("quadric"));
    EXPECT_NEAR(quadric.value(x), surface.at(x).distance - radius, 1e-15);
    const Vector3d step = 1e-4 * (near(generator) - x).normalized();
    EXPECT_NEAR(quadric.value(x + step), surface.at(x + step).distance - radius, 1e-9);
    EXPECT_LT((quadric.normal(x + step) - surface.at(x + step).normal).norm(), 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(shapes, SurfaceLaw, ::testing::ValuesIn(shapes()), [](const auto& test) {
  return std::string(test.param.hollow ? "hollow_" : "") + name_of(test.param.kind);
});

TEST(SurfaceCurvature, EveryShape_FollowsFromItsRadii) {
  const auto curvatures = [](const SurfaceShape& shape) {
    const Eigen::Matrix3d axes = Reference::surface_with_normal(upwards).rotation;
    const Eigen::Matrix3d curvature =
        axes.transpose() * Surface(shape, place, upwards).at(place).hessian * axes;
    return Eigen::Vector2d(curvature(0, 0), curvature(1, 1));
  };
  const auto near = [](const Eigen::Vector2d& a, double x, double y) {
    EXPECT_LT((a - Eigen::Vector2d(x, y)).norm(), 1e-12) << a.transpose();
  };
  near(curvatures({.kind = Kind::Sphere, .radius = 0.5}), 2.0, 2.0);
  near(curvatures({.kind = Kind::Sphere, .radius = 0.5, .hollow = true}), -2.0, -2.0);
  near(curvatures({.kind = Kind::Cylinder, .radius = 0.5}), 0.0, 2.0);
  near(curvatures({.kind = Kind::Torus, .radius = 0.25, .ring = 0.75}), 1.0, 4.0);
  near(curvatures({.kind = Kind::Ellipsoid, .semi_axes = {0.4, 0.5, 0.2}}), 0.2 / 0.16, 0.2 / 0.25);
  near(curvatures({.kind = Kind::Saddle, .curvature = {1.0, -3.0}}), -1.0, 3.0);
  near(curvatures({.kind = Kind::Cone, .radius = 0.5, .half_angle = 0.7}), 0.0, 2.0);
}

TEST(RidgeSurface, Distance_IsToTheNearerHalfPlane) {
  const Eigen::Matrix3d axes = Reference::surface_with_normal(upwards).rotation;
  constexpr double edge = 0.03, slope = 0.3;
  for (const bool hollow : {false, true}) {
    const SurfaceShape shape{
        .kind = Kind::Ridge, .edge = edge, .slope = slope, .hollow = hollow, .turn_deg = 25.0};
    const Surface surface(shape, place, upwards);
    const Eigen::AngleAxisd turn(25.0 * std::numbers::pi / 180.0, Vector3d::UnitZ());
    const Eigen::Matrix3d own = axes * turn.toRotationMatrix();
    const double rise = hollow ? std::tan(slope) : -std::tan(slope);
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> across(-0.06, 0.12), above(-0.05, 0.05);
    for (int i = 0; i < 200; ++i) {
      const double x = across(generator), z = above(generator);
      const SurfaceDistance at = surface.at(place + own * Vector3d(x, above(generator), z));
      const double height = x > edge ? rise * (x - edge) : 0.0;
      EXPECT_EQ(at.distance > 0.0, z > height);
      // Points on both half planes, 20 micrometres apart.
      double nearest = 1.0;
      for (double u = -0.3; u < 0.3; u += 2e-5)
        nearest = std::min(nearest, std::hypot(x - u, z - (u > edge ? rise * (u - edge) : 0.0)));
      EXPECT_NEAR(std::abs(at.distance), nearest, 1e-6 + 1e-5 * 1e-5 / std::max(nearest, 1e-6));
      EXPECT_NEAR(at.normal.norm(), 1.0, 1e-14);
    }
    EXPECT_LT((surface.at(place + own * Vector3d(0.1, 0.0, rise * (0.1 - edge))).normal -
               own * Vector3d(-rise, 0.0, 1.0).normalized())
                  .norm(),
              1e-12);
  }
}

TEST(SurfaceShape, InvalidDimension_IsRefused) {
  const auto refused = [](const SurfaceShape& shape, const char* words) {
    const std::string sentence = testing::refusal([&] { Surface(shape, place, upwards); });
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  refused({.kind = Kind::Sphere, .radius = -1.0}, "sphere: its radius is -1 m");
  refused({.kind = Kind::Torus, .radius = 0.5, .ring = 0.4}, "less than the radius of its ring");
  refused({.kind = Kind::Cone, .half_angle = 2.0}, "half angle is 2 rad");
  refused({.kind = Kind::Plane, .hollow = true}, "a plane cannot be hollow");
  refused({.kind = Kind::Saddle, .hollow = true}, "the signs of both curvatures changed");
  refused({.kind = Kind::Ridge, .slope = -0.1}, "its slope is -0.1 rad");
  refused({.kind = Kind::Ellipsoid, .semi_axes = {0.1, 0.0, 0.1}}, "semi-axis is 0 m");
  EXPECT_NE(testing::refusal([] { Surface({}, place, Vector3d::Zero()); }).find("normal"),
            std::string::npos);
}

TEST(SurfaceShape, Text_IsParsedAndInvalidTextIsRefused) {
  const SurfaceShape ball = SurfaceShape::parse("sphere:0.25:hollow");
  EXPECT_EQ(ball.text(), "hollow sphere of radius 0.25 m");
  EXPECT_EQ(SurfaceShape::parse("torus:0.1:0.6").text(),
            "torus of radius 0.1 m along a ring of 0.6 m");
  EXPECT_EQ(SurfaceShape::parse("cone:0.2:0.5").half_angle, 0.5);
  EXPECT_EQ(SurfaceShape::parse("ellipsoid:1:2:3").semi_axes, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(SurfaceShape::parse("saddle:1:-2").curvature, Eigen::Vector2d(1.0, -2.0));
  for (const std::string& name : surface_kinds())
    EXPECT_EQ(name_of(SurfaceShape::parse(name).kind), name);
  const auto refused = [](const std::string& text, const std::string& sentence) {
    EXPECT_EQ(testing::refusal([&] { SurfaceShape::parse(text); }),
              "surface '" + text + "': " + sentence);
  };
  refused("spere:1",
          "there is no shape 'spere'; wanted a shape such as sphere:0.3; did you mean 'sphere'?");
  refused("sphere:1:2", "sphere is followed by 2 numbers; wanted 1 or none");
  refused("cylinder:wide",
          "'wide' is not a number; wanted numbers as in cylinder:0.3 (with ':hollow' at the end if "
          "the tool touches the inner side)");
  refused("sphere:0", "sphere: its radius is 0 m; wanted a positive number");
  refused("plane:hollow", "plane: a plane cannot be hollow");
}

}  // namespace
}  // namespace burnish::test

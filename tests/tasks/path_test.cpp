// Paths on a surface: start, smoothness, extent, and refusals.
#include "burnish/tasks/polishing/path.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/refusal.hpp"

namespace burnish::polishing {
namespace {

using testing::expect_words;
using testing::refusal;

PathSpec spec_of(PathKind kind) {
  PathSpec spec;
  spec.kind = kind;
  spec.points = {{0.05, 0.0}, {0.05, 0.04}, {0.05, 0.04}, {-0.03, -0.02}};
  return spec;
}

class EveryPath : public ::testing::TestWithParam<PathKind> {};

TEST_P(EveryPath, Start_IsAtRestInTheCentre) {
  const Path path(spec_of(GetParam()));
  for (const double t : {-1.0, 0.0}) {
    EXPECT_EQ(path.at(t).p, Eigen::Vector2d(0.0, 0.0));
    EXPECT_EQ(path.at(t).v, Eigen::Vector2d(0.0, 0.0));
    EXPECT_EQ(path.at(t).a, Eigen::Vector2d(0.0, 0.0));
  }
  EXPECT_LT(path.at(1e-6).a.norm(), 1e-4);
}

TEST_P(EveryPath, Derivatives_MatchFiniteDifferences) {
  const Path path(spec_of(GetParam()));
  const double end = std::min(path.duration(), 60.0) + 1.0, h = 1e-4;
  double fastest = 0.0;
  for (double t = -0.01; t < end; t += 3.7e-3) {
    const PlanarPoint before = path.at(t - h), at = path.at(t), after = path.at(t + h);
    // Central differences; their error depends on the third derivative, which may jump.
    EXPECT_LT(((after.p - before.p) / (2.0 * h) - at.v).norm(), 1e-4) << t;
    EXPECT_LT(((after.v - before.v) / (2.0 * h) - at.a).norm(), 1e-2) << t;
    EXPECT_LT((after.a - before.a).norm(), 2e-2) << "acceleration jumps at " << t;
    fastest = std::max(fastest, at.v.norm());
  }
  EXPECT_GT(fastest, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Paths, EveryPath,
                         ::testing::Values(PathKind::Circle, PathKind::Spiral, PathKind::ZigZag,
                                           PathKind::Points),
                         [](const auto& test) { return name_of(test.param); });

TEST(Path, CircleAfterStartUp_HasConstantRadiusAndSpeed) {
  PathSpec spec = spec_of(PathKind::Circle);
  spec.rate = 2.0;
  const Path path(spec);
  EXPECT_TRUE(std::isinf(path.duration()));
  for (double t = spec.start_up; t < 10.0; t += 0.1) {
    const PlanarPoint at = path.at(t);
    EXPECT_NEAR(at.p.norm(), spec.radius, 1e-12);
    EXPECT_NEAR(at.v.norm(), spec.radius * spec.rate, 1e-12);
    EXPECT_NEAR(at.p.dot(at.v), 0.0, 1e-12);
    EXPECT_LT((at.a + spec.rate * spec.rate * at.p).norm(), 1e-12);
  }
  // A negative rate runs the circle backwards.
  spec.rate = -2.0;
  EXPECT_NEAR(Path(spec).at(5.0).p.y(), -path.at(5.0).p.y(), 1e-12);
}

TEST(Path, Spiral_GoesOutAndBackWithItsPitch) {
  PathSpec spec = spec_of(PathKind::Spiral);
  spec.start_up = 1.0;
  const Path path(spec);
  const double turn = 2.0 * std::numbers::pi / spec.rate;
  const double turns = spec.radius / spec.pitch;
  const double out = turns * turn + 0.5 * spec.start_up;
  EXPECT_NEAR(path.at(out).p.norm(), spec.radius, 1e-9);
  EXPECT_LT(path.at(2.0 * turns * turn + 0.5 * spec.start_up).p.norm(), 1e-9);
  double largest = 0.0, max_pitch = 0.0;
  for (double t = 0.0; t < out - turn; t += 0.05) {
    largest = std::max(largest, path.at(t).p.norm());
    max_pitch = std::max(max_pitch, path.at(t + turn).p.norm() - path.at(t).p.norm());
  }
  EXPECT_LE(largest, spec.radius);
  EXPECT_LT(max_pitch, 0.5 * std::numbers::pi * spec.pitch * 1.01);
  EXPECT_GT(max_pitch, spec.pitch);
}

TEST(Path, ZigZag_PassesThroughItsCorners) {
  PathSpec spec = spec_of(PathKind::ZigZag);
  spec.rows = 3;
  const Path path(spec);
  ASSERT_TRUE(std::isfinite(path.duration()));
  Eigen::Vector2d lower(1.0, 1.0), upper(-1.0, -1.0);
  double fastest = 0.0;
  int rests = 0;
  bool moving = true;
  for (double t = 0.0; t <= path.duration() + 0.1; t += 1e-3) {
    const PlanarPoint at = path.at(t);
    lower = lower.cwiseMin(at.p);
    upper = upper.cwiseMax(at.p);
    fastest = std::max(fastest, at.v.norm());
    const bool moves = at.v.norm() > 1e-3;
    rests += moving && !moves ? 1 : 0;
    moving = moves;
  }
  EXPECT_NEAR(upper.x(), 0.5 * spec.width, 1e-6);
  EXPECT_NEAR(lower.x(), -0.5 * spec.width, 1e-6);
  EXPECT_NEAR(upper.y(), 0.5 * spec.height, 1e-6);
  EXPECT_NEAR(lower.y(), -0.5 * spec.height, 1e-6);
  EXPECT_NEAR(fastest, spec.speed, 1e-3 * spec.speed);
  EXPECT_EQ(rests, 1 + 2 * spec.rows);  // the start, and both ends of each line
  EXPECT_EQ(path.at(1e6).p, path.at(path.duration()).p);
  EXPECT_EQ(path.at(1e6).v, Eigen::Vector2d(0.0, 0.0));
}

TEST(Path, Points_AreReachedAndTheLastIsKept) {
  const PathSpec spec = spec_of(PathKind::Points);
  const Path path(spec);
  for (const Eigen::Vector2d& point : spec.points) {
    double nearest = 1.0;
    for (double t = 0.0; t <= path.duration(); t += 1e-3)
      nearest = std::min(nearest, (path.at(t).p - point).norm());
    EXPECT_LT(nearest, 1e-6);
  }
  EXPECT_EQ(path.at(path.duration() + 1.0).p, spec.points.back());
  EXPECT_EQ(path.at(path.duration() + 1.0).a, Eigen::Vector2d(0.0, 0.0));
}

TEST(Path, Kinds_AreFoundByName) {
  for (const PathKind kind :
       {PathKind::Circle, PathKind::Spiral, PathKind::ZigZag, PathKind::Points})
    EXPECT_EQ(parse_path(name_of(kind)), kind);
  expect_words(refusal([] { parse_path("zigzig"); }), {"zigzig", "zigzag"});
}

TEST(Path, InvalidSpec_IsRefused) {
  const auto with = [](PathKind kind, auto&& change) {
    return refusal([&] {
      PathSpec spec = spec_of(kind);
      change(spec);
      Path{spec};
    });
  };
  using S = PathSpec;
  const double nan = std::nan("");
  expect_words(with(PathKind::Circle, [](S& s) { s.radius = 0.0; }), {"radius", "positive"});
  expect_words(with(PathKind::Circle, [](S& s) { s.start_up = -1.0; }), {"start_up", "positive"});
  expect_words(with(PathKind::Circle, [&](S& s) { s.rate = nan; }), {"rate", "finite"});
  expect_words(with(PathKind::Spiral, [](S& s) { s.pitch = 0.0; }), {"pitch", "positive"});
  expect_words(with(PathKind::Spiral, [](S& s) { s.rate = -1.0; }), {"rate", "positive"});
  expect_words(with(PathKind::Spiral, [](S& s) { s.start_up = 0.0; }), {"start_up", "positive"});
  expect_words(with(PathKind::ZigZag, [](S& s) { s.rows = 1; }), {"rows is 1", "at least 2"});
  expect_words(with(PathKind::ZigZag, [&](S& s) { s.width = nan; }), {"width", "positive"});
  expect_words(with(PathKind::ZigZag, [](S& s) { s.speed = 0.0; }), {"speed", "positive"});
  expect_words(with(PathKind::Points, [](S& s) { s.points.clear(); }), {"points is empty"});
  expect_words(with(PathKind::Points, [&](S& s) { s.points[1].x() = nan; }), {"not finite"});
}

}  // namespace
}  // namespace burnish::polishing

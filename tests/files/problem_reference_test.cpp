// Tests of references in problem files: rotations over time, curved surfaces, and sliding friction.
#include <gtest/gtest.h>

#include "support/problem_files.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

Eigen::Matrix3d rotation_at(const Reference& reference, double time) {
  return reference.at(time).rotation;
}
Eigen::Matrix3d about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST_F(ProblemFiles, ReferencesOverTime_RotateByTableOrLine) {
  // A quarter turn about z; the second quaternion has the other sign, the third is rounded.
  write("time [s],x [-],y,z,w\n0,0,0,0,1\n1,0,0,-0.38268343,-0.92387953\n2,0,0,0.7071,0.7071\n",
        "turn.csv");
  const std::string table = "{points: {file: turn.csv, columns: [x, y, z, w]}}";
  const std::string line =
      "{line: {from: {rpy: [0, 0, 0.2]}, to: {rpy: [0, 0, 1.2]}, duration: 2,"
      " profile: constant_speed}}";
  const ProblemFile file =
      read(small("directions: z", "directions: z, reference: {surface: {over_time: " + table + "}}",
                 "terminal_constraints:\n"
                 "  turned: {type: frame_velocity, frame: tool, lower: 0, scale: 0.1,"
                 " reference: {axes: link_3, over_time: " +
                     line +
                     "}}\n"
                     "  held: {type: frame_rotation, frame: tool, target: " +
                     line + ", lower: -1, scale: 1, l1_weight: 3, quadratic_weight: 2}\n"));
  const Reference& pad = file.spec.contacts[0].reference;
  EXPECT_EQ(pad.axes, Anchor(Anchor::Base));
  EXPECT_LT((rotation_at(pad, -1.0) - about_z(0.0)).norm(), 1e-8);
  EXPECT_LT((rotation_at(pad, 0.5) - about_z(M_PI / 8)).norm(), 1e-8) << "the shorter rotation";
  EXPECT_LT((rotation_at(pad, 1.5) - about_z(3 * M_PI / 8)).norm(), 1e-4);
  EXPECT_LT((rotation_at(pad, 9.0) - about_z(M_PI / 2)).norm(), 1e-4);
  const auto& velocity =
      std::get<residual::FrameVelocity>(file.spec.terminal_constraints[0].residual);
  EXPECT_EQ(velocity.reference.axes, Anchor("link_3"));
  EXPECT_EQ(velocity.reference.origin, Anchor(Anchor::Tool));
  for (const double t : {-1.0, 0.3, 1.7, 5.0})
    EXPECT_LT(
        (rotation_at(velocity.reference, t) - about_z(0.2 + 0.5 * std::clamp(t, 0.0, 2.0))).norm(),
        1e-12)
        << t;
  Eigen::VectorXd xyzw(4);
  std::get<residual::FrameRotation>(file.spec.terminal_constraints[1].residual)
      .target.at(1.0, xyzw);
  EXPECT_NEAR(xyzw[2], std::sin(0.35), 1e-12);
}

TEST_F(ProblemFiles, CurvedSurfaces_AreReadAsQuadrics) {
  const auto quadric = [&](const std::string& shape) {
    const ProblemFile file = read(small("directions: z", "directions: z, reference: {surface: {" +
                                                             shape + ", near: [0, 0, 0.5]}}"));
    return file.spec.contacts[0].reference;
  };
  const auto same = [](const Reference& reference, const Quadric& surface) {
    const Reference wanted = Reference::on(surface, {0.0, 0.0, 0.5});
    EXPECT_EQ(reference.rotation, wanted.rotation);
    ASSERT_TRUE(reference.quadric.has_value());
    EXPECT_EQ(reference.quadric->Q, surface.Q);
    EXPECT_EQ(reference.quadric->b, surface.b);
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), low(0.0, 0.0, -0.5);
  same(quadric("sphere: {center: [0, 0, -0.5], radius: 1}"), Quadric::sphere(low, 1.0));
  same(quadric("cylinder: {point: [0, 0, -0.5], axis: [2, 0, 0], radius: 0.3, hollow: true}"),
       Quadric::cylinder(low, x, 0.3, true));
  same(quadric("cone: {apex: [0, 0, -0.5], axis: [1, 0, 0], half_angle: 0.2}"),
       Quadric::cone(low, x, 0.2));
  same(quadric("ellipsoid: {center: [0, 0, -0.5], semi_axes: [1, 2, 3]}"),
       Quadric::ellipsoid(low, Eigen::Matrix3d::Identity(), {1.0, 2.0, 3.0}));
  same(quadric("osculating: {point: [0, 0, 0.5], normal: [0, 0, 1], curvature: [-1, 0, 2]}"),
       Quadric::osculating({0.0, 0.0, 0.5}, Eigen::Matrix3d::Identity(), -1.0, 0.0, 2.0));
  const auto refused = [&](const std::string& shape) {
    return refusal([&] { (void)quadric(shape); });
  };
  EXPECT_NE(refused("sphere: {center: [0, 0, 0], radius: -1}").find("radius"), std::string::npos);
  EXPECT_NE(refused("sphere: {center: [0, 0, 0], radios: 1}").find("did you mean 'radius'"),
            std::string::npos);
  EXPECT_NE(refused("sphere: {center: [0, 0, 0.5], radius: 1}").find("no normal"),
            std::string::npos);
}

TEST_F(ProblemFiles, SlidingFriction_IsReadWithItsDefaults) {
  const ProblemFile file =
      read(small("directions: z", "directions: z, friction: {coefficient: 0.4, radius: 0.02}"));
  const auto& friction = file.spec.contacts[0].friction;
  ASSERT_TRUE(friction.has_value());
  EXPECT_EQ(friction->coefficient, 0.4);
  EXPECT_EQ(friction->speed, SlidingFriction().speed);
  EXPECT_EQ(friction->radius, 0.02);
  const auto refused = [&](const std::string& keys) {
    return refusal([&] { read(small("directions: z", keys)); });
  };
  expect_words(refused("directions: z, friction: {coeficient: 0.4}"),
               {"did you mean 'coefficient'"});
  expect_words(refused("directions: z, friction: {speed: 0}"), {"friction.speed", "0"});
  expect_words(refused("directions: linear, friction: {}"),
               {"has friction, and its directions of translation are x,y,z"});
}

TEST_F(ProblemFiles, BadRotationsOverTime_AreRefused) {
  const auto refused = [&](const std::string& path) {
    return refusal(
        [&] { read(small("directions: z", "directions: z, reference: {local: {" + path + "}}")); });
  };
  write("time,x,y,z,w\n0,0,0,0,1\n1,0,0,0,0\n", "zero.csv");
  write("time,x,y,z,w\n0,0,0,0,1\n1,0,0,0,1.1\n", "long.csv");
  const auto table = [](const std::string& name) {
    return "over_time: {points: {file: " + name + ", columns: [x, y, z, w]}}";
  };
  expect_words(refused(table("zero.csv")), {"points.file", "quaternion at 1 s", "length 0"});
  expect_words(refused(table("long.csv")), {"points.file", "quaternion at 1 s", "length 1.1"});
  expect_words(refused("over_time: {sine: {}}"), {"over_time", "'sine'"});
  expect_words(refused("over_time: {}"), {"over_time", "'line' and 'points' are both missing"});
  expect_words(refused("rpy: [0, 0, 1], " + table("zero.csv")), {"'rpy'", "unknown"});
}

}  // namespace
}  // namespace burnish::testing

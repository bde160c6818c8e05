// Robots that are built in code equal the robots in files that they replace.
#include <gtest/gtest.h>

#include "support/robots.hpp"

namespace burnish::test {
namespace {

#if BURNISH_HAS_ROBOTS
/// Compares two models except their visuals.
void expect_alike(const Model& built, const Model& read) {
  const double rounding = 1e-15;
  ASSERT_EQ(built.joints.size(), read.joints.size());
  EXPECT_EQ(built.name, read.name);
  for (std::size_t i = 0; i < read.joints.size(); ++i) {
    const Joint &a = built.joints[i], &b = read.joints[i];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_TRUE(a.placement.isApprox(b.placement, rounding));
    EXPECT_NEAR(a.mass, b.mass, rounding);
    EXPECT_TRUE(a.com.isApprox(b.com, rounding));
    EXPECT_TRUE(a.inertia_at_com.isApprox(b.inertia_at_com, rounding));
  }
  ASSERT_EQ(built.frames.size(), read.frames.size());
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    const Frame &a = built.frames[i], &b = read.frames[i];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.body, b.body);
    EXPECT_TRUE(a.placement.isApprox(b.placement, rounding));
  }
  EXPECT_EQ(built.gravity, read.gravity);
  EXPECT_EQ(built.q_neutral, read.q_neutral);
  EXPECT_EQ(built.q_lower, read.q_lower);
  EXPECT_EQ(built.q_upper, read.q_upper);
  EXPECT_EQ(built.velocity_limit, read.velocity_limit);
  EXPECT_EQ(built.effort_limit, read.effort_limit);
  EXPECT_EQ(built.damping, read.damping);
  EXPECT_EQ(built.friction, read.friction);
  EXPECT_EQ(built.armature, read.armature);
}

TEST(BuiltArm7, Model_EqualsTheArmOfItsFile) {
  const Robot arm = load_robot(BURNISH_ROBOTS_DIR "/arm7");
  expect_alike(arm7::model(Base::Fixed), arm.model);
  EXPECT_EQ(arm7::ready(), arm.posture("ready"));
  expect_alike(arm7::model(Base::FreeFlyer), load_robot(BURNISH_ROBOTS_DIR "/arm7:floating").model);
}
#endif

TEST(BuiltBiped, HalfSittingPosture_HasTwoLevelSoles) {
  const Model model = biped::model(Base::FreeFlyer);
  const Eigen::VectorXd q = biped::half_sitting(model);
  const Eigen::Isometry3d left = testing::frame_placement(model, q, "left_sole_link");
  const Eigen::Isometry3d right = testing::frame_placement(model, q, "right_sole_link");
  EXPECT_TRUE(left.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
  EXPECT_TRUE(right.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
  EXPECT_NEAR(left.translation().z(), right.translation().z(), 1e-12);
  EXPECT_GT(left.translation().y() - right.translation().y(), 0.1);
  EXPECT_EQ(model.nv, 6 + 2 * 6 + 4);
}

}  // namespace
}  // namespace burnish::test

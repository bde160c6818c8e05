// Tendons of fixed length couple joints. Invalid tendons and springs are refused by name.
#include <gtest/gtest.h>

#include "burnish/model/model.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::nan;

/// Two hinges and a slide in a row, and a tendon along the hinges.
TreeSpec coupled() {
  TreeSpec tree = two_links();
  tree.source = "arm.xml";
  tree.links.push_back(link("far"));
  tree.joints.push_back(joint("slide", JointType::Prismatic, "tip", "far"));
  tree.tendons.push_back({"belt", {{"shoulder", 2.0}, {"elbow", 1.0}}, true, 0.3, 0.0, 0.0});
  return tree;
}

std::string refused(const TreeSpec& tree, const ModelOptions& options = {}) {
  return refusal([&] { build_model(tree, options); });
}

TEST(FixedLengthTendon, TwoJoints_LetTheSecondFollowTheFirst) {
  const Model model = build_model(coupled());
  const Joint& elbow = model.joints[static_cast<std::size_t>(model.joint_index("elbow"))];
  ASSERT_TRUE(elbow.follows);
  EXPECT_EQ(elbow.follows->leader, model.joint_index("shoulder"));
  EXPECT_DOUBLE_EQ(elbow.follows->multiplier, -2.0);
  EXPECT_DOUBLE_EQ(elbow.follows->offset, 0.3);
  EXPECT_EQ(model.nv, 2);
  EXPECT_TRUE(model.tendons.empty());
}

TEST(FixedLengthTendon, SecondJointThatCannotFollow_LetsTheFirstFollow) {
  TreeSpec tree = coupled();
  ModelOptions options;
  const auto follows = [&](const std::string& name) {
    const Model model = build_model(tree, options);
    return model.joints[static_cast<std::size_t>(model.joint_index(name))].follows;
  };
  options.free = {"elbow"};
  EXPECT_DOUBLE_EQ(follows("shoulder")->multiplier, -0.5);
  options.free = {"shoulder"};
  EXPECT_DOUBLE_EQ(follows("elbow")->multiplier, -2.0);
  options = {};
  tree.joints[1].mimic = MimicSpec{"slide", 1.0, 0.0};
  EXPECT_DOUBLE_EQ(follows("shoulder")->multiplier, -0.5);
  tree.joints[0].mimic = MimicSpec{"slide", 1.0, 0.0};
  expect_words(refused(tree),
               {"tendon 'belt'", "'shoulder'", "'elbow'", "neither joint can follow"});
}

TEST(FixedLengthTendon, OneLockedJoint_LocksTheOther) {
  ModelOptions options;
  options.locked = {"elbow"};
  options.posture = {{"elbow", {0.1}}};
  const Model model = build_model(coupled(), options);
  EXPECT_EQ(model.nv, 1);
  const Model free = build_model(coupled());
  const Eigen::VectorXd q = configuration(free, {{"shoulder", {0.1}}});
  EXPECT_TRUE(frame_placement(model, model.q_neutral, "far")
                  .isApprox(frame_placement(free, q, "far"), 1e-12));
}

TEST(FixedLengthTendon, MoreThanTwoJoints_NeedTheOthersLocked) {
  TreeSpec tree = coupled();
  tree.tendons[0].parts.push_back({"slide", 0.5});
  expect_words(refused(tree), {"arm.xml", "tendon 'belt'", "'slide'", "lock the others"});
  ModelOptions options;
  options.locked = {"slide"};
  options.posture = {{"slide", {0.2}}};
  const Model model = build_model(tree, options);
  const Joint& elbow = model.joints[static_cast<std::size_t>(model.joint_index("elbow"))];
  ASSERT_TRUE(elbow.follows);
  EXPECT_DOUBLE_EQ(elbow.follows->offset, 0.3 - 0.1);
}

TEST(Tendon, UnsuitableJoint_IsRefused) {
  TreeSpec tree = coupled();
  tree.tendons[0].line = 12;
  tree.tendons[0].parts[1].joint = "elbw";
  for (const bool fixed_length : {true, false}) {
    tree.tendons[0].held = fixed_length;
    tree.tendons[0].stiffness = 1.0;
    tree.tendons[0].parts[1].joint = "elbw";
    expect_words(refused(tree), {"line 12: tendon 'belt'", "'elbw'", "'elbow'?"});
    tree.tendons[0].parts[1].joint = "elbow";
    tree.joints[1].type = JointType::Ball;
    expect_words(refused(tree), {"tendon 'belt'", "'elbow'", "more than one coordinate"});
    tree.joints[1].type = JointType::Revolute;
  }
  tree.joints[1].type = JointType::Continuous;
  expect_words(refused(tree), {"tendon 'belt'", "'elbow'", "continuous", "revolute"});
  tree.tendons[0].stiffness = 0.0;
  tree.tendons[0].damping = 1.0;
  EXPECT_EQ(build_model(tree).tendons.size(), 1u);
  tree.tendons[0].held = true;
  tree.tendons[0].parts.pop_back();
  expect_words(refused(tree), {"tendon 'belt'", "'shoulder'", "alone"});
}

TEST(Tendon, InvalidNumber_IsRefused) {
  TreeSpec tree = coupled();
  tree.tendons[0].stiffness = -1.0;
  tree.tendons[0].parts[0].coefficient = nan;
  expect_words(refused(tree), {"tendon 'belt'", "stiffness", "-1", "'shoulder'", "nan"});
  tree.tendons[0].parts.clear();
  expect_words(refused(tree), {"tendon 'belt'", "no joint"});
}

TEST(Spring, InvalidSpring_IsRefusedOrWarnedAboutByName) {
  TreeSpec tree = two_links();
  tree.joints[0].stiffness = -1.0;
  tree.joints[1].rest = nan;
  expect_words(refused(tree), {"'shoulder'", "stiffness", "-1", "'elbow'", "rest", "nan"});
  tree = two_links();
  tree.joints[0].stiffness = 1.0;
  tree.joints[0].type = JointType::Planar;
  const Model planar = build_model(tree);
  ASSERT_EQ(planar.warnings.size(), 1u);
  expect_words(planar.warnings[0], {"'shoulder'", "spring", "ignored"});
  EXPECT_TRUE(planar.stiffness.isZero(0.0));
  tree.joints[0].type = JointType::Ball;
  EXPECT_EQ(build_model(tree).stiffness.head<3>(), Eigen::Vector3d::Ones());
  tree.joints[0].rest = 0.5;
  expect_words(build_model(tree).warnings.at(0), {"'shoulder'", "ball", "0.5", "ignored"});
}

TEST(Spring, CoupledContinuousJoints_AreRefused) {
  TreeSpec tree = two_links();
  tree.joints[0].type = tree.joints[1].type = JointType::Continuous;
  tree.joints[0].stiffness = tree.joints[1].stiffness = 1.0;
  tree.joints[1].mimic = MimicSpec{"shoulder", 1.0, 0.2};
  expect_words(refused(tree), {"'elbow'", "'shoulder'", "continuous", "revolute"});
  tree.joints[1].mimic->multiplier = 2.0;
  tree.joints[0].stiffness = 0.0;
  expect_words(refused(tree), {"'elbow'", "'shoulder'", "both springs at rest"});
}

}  // namespace
}  // namespace burnish::testing

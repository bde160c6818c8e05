// Tests of locked joints: postures, followers, and refusals.
#include <gtest/gtest.h>

#include "burnish/model/model.hpp"
#include "support/refusal.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

/// Fingers that copy each other: third copies second copies first.
TreeSpec hand() {
  TreeSpec tree;
  tree.name = "hand";
  tree.source = "hand.urdf";
  for (const char* name : {"palm", "wrist_link", "one", "two", "three"}) {
    tree.links.push_back(link(name));
  }
  tree.joints = {
      joint("wrist", JointType::Revolute, "palm", "wrist_link"),
      joint("first", JointType::Prismatic, "wrist_link", "one"),
      joint("second", JointType::Prismatic, "wrist_link", "two"),
      joint("third", JointType::Revolute, "wrist_link", "three"),
  };
  tree.joints[2].mimic = MimicSpec{"first", 2.0, 0.1};
  tree.joints[3].mimic = MimicSpec{"second", -1.0, 0.5};
  return tree;
}

double height(const Model& model, const std::string& frame) {
  return frame_placement(model, model.q_neutral, frame).translation().z();
}

TEST(LockedJoints, RandomPosture_EqualsTheFreeModel) {
  std::mt19937_64 generator(11);
  for (int round = 0; round < 20; ++round) {
    const TreeSpec tree = random_tree(generator, 18);
    ModelOptions options;
    options.base = round % 2 == 0 ? Base::Fixed : Base::FreeFlyer;
    const Model whole = build_model(tree, options);
    options.posture = random_posture(tree, generator);
    std::size_t moving = 0;
    for (const JointSpec& spec : tree.joints) {
      if (spec.type == JointType::Fixed) continue;
      ++moving;
      if (generator() % 2 == 0) options.locked.push_back(spec.name);
    }
    const Model locked = build_model(tree, options);
    EXPECT_EQ(locked.locked_joints.size(), options.locked.size());
    const std::size_t base_joints = options.base == Base::FreeFlyer ? 1 : 0;
    EXPECT_EQ(locked.joints.size(), moving + base_joints - options.locked.size());
    const Eigen::VectorXd q_whole = configuration(whole, options.posture);
    const Eigen::VectorXd q_locked = configuration(locked, options.posture);
    for (const Frame& frame : whole.frames) {
      EXPECT_TRUE(frame_placement(locked, q_locked, frame.name)
                      .isApprox(frame_placement(whole, q_whole, frame.name), 1e-11))
          << frame.name;
    }
    if (options.base == Base::FreeFlyer) {
      EXPECT_NEAR(locked.total_mass(), whole.total_mass(), 1e-12);
    }
  }
}

TEST(LockedJoints, NoPosture_LocksAtZero) {
  ModelOptions options;
  options.locked = {"wrist", "first", "second", "third"};
  const Model model = build_model(hand(), options);
  EXPECT_EQ(model.nv, 0);
  EXPECT_NEAR(height(model, "one"), 0.6, 1e-15);
}

TEST(LockedJoints, OptionFree_LocksAllOthers) {
  ModelOptions options;
  options.free = {"wrist"};
  const Model model = build_model(hand(), options);
  ASSERT_EQ(model.joints.size(), 1u);
  EXPECT_EQ(model.joints[0].name, "wrist");
  EXPECT_EQ(model.locked_joints, (std::vector<std::string>{"first", "second", "third"}));
  expect_words(refusal([&] { model.joint_index("first"); }), {"'first'", "locked"});
  options.base = Base::FreeFlyer;
  EXPECT_EQ(build_model(hand(), options).joints.size(), 2u);
  options.free = {"wrist", "root_joint"};
  EXPECT_EQ(build_model(hand(), options).joints.size(), 2u);
}

TEST(LockedJoints, ValuesInALaterPosture_AreIgnored) {
  ModelOptions options;
  options.free = {"wrist"};
  const Model model = build_model(hand(), options);
  EXPECT_EQ(configuration(model, {{"first", {1.0}}, {"wrist", {0.5}}})[0], 0.5);
}

TEST(LockedJoints, FollowerOfALockedLeader_IsLockedWithIt) {
  ModelOptions options;
  options.free = {"wrist"};
  options.posture = {{"first", {0.3}}};
  const Model model = build_model(hand(), options);
  EXPECT_NEAR(height(model, "two"), 0.6 + 2.0 * 0.3 + 0.1, 1e-12);
  const Eigen::Matrix3d turned = frame_placement(model, model.q_neutral, "three").linear();
  EXPECT_NEAR(std::atan2(turned(1, 0), turned(0, 0)), -(2.0 * 0.3 + 0.1) + 0.5, 1e-12);
}

TEST(LockedJoints, FollowerWithAPosture_IgnoresItsLeader) {
  ModelOptions options;
  options.free = {"wrist"};
  options.posture = {{"first", {0.3}}, {"second", {-0.2}}};
  const Model model = build_model(hand(), options);
  EXPECT_NEAR(height(model, "two"), 0.4, 1e-12);
  const Eigen::Matrix3d turned = frame_placement(model, model.q_neutral, "three").linear();
  EXPECT_NEAR(std::atan2(turned(1, 0), turned(0, 0)), 0.7, 1e-12);
}

TEST(LockedJoints, FollowerOfAMovingLeader_NeedsAValue) {
  ModelOptions options;
  options.locked = {"second", "third"};
  expect_words(refusal([&] { build_model(hand(), options); }),
               {"hand.urdf", "'second'", "'first'", "moves", "posture"});
  options.posture = {{"second", {0.0}}};
  EXPECT_EQ(build_model(hand(), options).nv, 2);
}

TEST(LockedJoints, FollowerWithAnInvalidLeader_IsRefused) {
  TreeSpec tree = hand();
  tree.joints[2].mimic->leader = "firstt";
  ModelOptions options;
  options.free = {"wrist"};
  expect_words(refusal([&] { build_model(tree, options); }), {"'firstt'", "'first'?"});
  tree = hand();
  tree.joints[1].mimic = MimicSpec{"third", 1.0, 0.0};
  expect_words(refusal([&] { build_model(tree, options); }), {"follows itself"});
  tree = hand();
  tree.joints[1].type = JointType::Floating;
  expect_words(refusal([&] { build_model(tree, options); }), {"'second'", "one coordinate"});
  tree = hand();
  tree.joints[2].type = JointType::Planar;
  expect_words(refusal([&] { build_model(tree, options); }), {"'second'", "one coordinate"});
}

TEST(LockedJoints, InvalidNamesOrPostures_AreRefused) {
  TreeSpec tree = hand();
  tree.links.push_back(link("cover"));
  tree.joints.push_back(joint("bolt", JointType::Fixed, "palm", "cover"));
  const auto sentence = [&](const ModelOptions& options) {
    return refusal([&] { build_model(tree, options); });
  };
  ModelOptions options;
  options.locked = {"wristt"};
  expect_words(sentence(options), {"hand.urdf", "lock", "'wristt'", "'wrist'?"});
  options.locked = {};
  options.free = {"wristt"};
  expect_words(sentence(options), {"free", "'wristt'", "'wrist'?"});
  options.free = {"bolt"};
  expect_words(sentence(options), {"'bolt'", "fixed"});
  options.free = {"wrist"};
  options.locked = {"wrist"};
  expect_words(sentence(options), {"'wrist'", "only one"});
  options = {};
  options.base = Base::FreeFlyer;
  options.locked = {"root_joint"};
  expect_words(sentence(options), {"root_joint", "fixed base"});
  options = {};
  options.free = {"wrist"};
  options.posture = {{"firstt", {0.0}}};
  expect_words(sentence(options), {"posture", "'firstt'", "'first'?"});
  options.posture = {{"bolt", {0.0}}};
  expect_words(sentence(options), {"posture", "'bolt'", "fixed"});
  options.posture = {{"first", {0.0, 1.0}}};
  expect_words(sentence(options), {"'first'", "2", "wanted 1"});
  options.posture = {{"first", {std::numeric_limits<double>::infinity()}}};
  expect_words(sentence(options), {"'first'", "inf"});
  options.posture = {{"root_joint", {0.0}}};
  expect_words(sentence(options), {"'root_joint'", "wanted 7"});
  // Locking a fixed joint changes nothing.
  options = {};
  options.locked = {"bolt", "first", "second", "third"};
  EXPECT_EQ(build_model(tree, options).locked_joints.size(), 3u);
}

TEST(LockedJoints, BallJoint_IsLockedAtItsQuaternionOrIdentity) {
  TreeSpec tree = two_links();
  tree.joints[1].type = JointType::Ball;
  ModelOptions options;
  options.locked = {"elbow"};
  const auto tip = [&]() -> Eigen::Vector3d {
    const Model model = build_model(tree, options);
    return frame_placement(model, model.q_neutral, "tip").translation();
  };
  EXPECT_TRUE(tip().isApprox(Eigen::Vector3d(3.0, 0.0, 0.0)));
  options.posture["elbow"] = {0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};
  EXPECT_TRUE(tip().isApprox(Eigen::Vector3d(2.0, 1.0, 0.0)));
  options.posture["elbow"] = {0.0, 0.0, 1.0, 1.0};
  expect_words(refusal([&] { build_model(tree, options); }), {"'elbow'", "quaternion", "length"});
  options.posture["elbow"] = {0.5};
  expect_words(refusal([&] { build_model(tree, options); }),
               {"'elbow'", "1 values", "4", "a quaternion x, y, z, w"});
}

TEST(LockedJoints, MasslessJoint_CanBeLocked) {
  TreeSpec tree = hand();
  tree.links[2].inertia = {};
  ModelOptions options;
  options.free = {"wrist"};
  EXPECT_NO_THROW(build_model(tree, options));
}

}  // namespace
}  // namespace burnish::testing

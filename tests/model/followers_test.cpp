// Joints that mimic others (followers). They have no entries of their own, pass their limits to
// their leaders, and are locked with them.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/model/model.hpp"
#include "support/built_robots.hpp"
#include "support/refusal.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::tree_with_followers;

/// Fingers that copy each other: third copies second copies first, which comes after them by name.
TreeSpec coupled_hand() {
  TreeSpec tree;
  tree.name = "hand";
  tree.source = "hand.urdf";
  for (const char* name : {"palm", "wrist_link", "one", "two", "three"})
    tree.links.push_back(link(name));
  tree.joints = {
      joint("wrist", JointType::Revolute, "palm", "wrist_link"),
      joint("z_first", JointType::Prismatic, "wrist_link", "one"),
      joint("second", JointType::Prismatic, "wrist_link", "two"),
      joint("third", JointType::Revolute, "two", "three"),
  };
  tree.joints[2].mimic = MimicSpec{"z_first", 2.0, 0.1};
  tree.joints[3].mimic = MimicSpec{"second", -1.5, 0.5};
  return tree;
}

const Joint& joint_of(const Model& model, const std::string& name) {
  return model.joints[static_cast<std::size_t>(model.joint_index(name))];
}

/// Compares with placements for which each follower's value is computed from its leader.
void expect_placements(const TreeSpec& tree, const Model& model, Posture posture) {
  const Eigen::VectorXd q = configuration(model, posture);
  for (std::size_t round = 0; round < tree.joints.size(); ++round)
    for (const JointSpec& spec : tree.joints)
      if (spec.mimic && posture.contains(spec.mimic->leader))
        posture[spec.name] = {spec.mimic->multiplier * posture.at(spec.mimic->leader)[0] +
                              spec.mimic->offset};
  for (const auto& [name, placement] : link_placements(tree, posture, tree.links[0].name))
    EXPECT_TRUE(burnish::frame_placement(model, q, name).isApprox(placement, 1e-12)) << name;
  EXPECT_TRUE(configuration(model, posture).isApprox(q, 1e-12))
      << "with the values of followers written out";
}

TEST(Followers, Entries_BelongToTheLeader) {
  const Model model = build_model(coupled_hand());
  ASSERT_EQ(model.joints.size(), 4u);
  EXPECT_EQ(model.nq, 2);
  EXPECT_EQ(model.nv, 2);
  const Joint &first = joint_of(model, "z_first"), &third = joint_of(model, "third");
  EXPECT_FALSE(first.follows);
  ASSERT_TRUE(third.follows);
  EXPECT_EQ(third.follows->leader, model.joint_index("z_first"));
  EXPECT_EQ(third.follows->multiplier, -3.0);
  EXPECT_NEAR(third.follows->offset, -1.5 * 0.1 + 0.5, 1e-15);
  EXPECT_EQ(third.nq, 0);
  EXPECT_EQ(third.nv, 0);
  EXPECT_EQ(third.q_index, first.q_index);
  EXPECT_EQ(third.v_index, first.v_index);
  EXPECT_EQ(model.q_name(1), "z_first");
  EXPECT_EQ(model.v_name(1), "z_first");
  EXPECT_EQ(model.locked_joints, std::vector<std::string>{});
}

TEST(Followers, Placements_FollowTheLeaders) {
  const TreeSpec hand = coupled_hand();
  expect_placements(hand, build_model(hand), {{"wrist", {0.7}}, {"z_first", {0.3}}});
  const TreeSpec tree = tree_with_followers();
  expect_placements(tree, build_model(tree),
                    {{"to_a", {0.4}},
                     {"to_c", {-0.3}},
                     {"to_wheel", {2.8}},
                     {"to_z", {0.9}},
                     {"to_z_3", {0.1, -0.2, 0.3, 0.5, 0.5, -0.5, 0.5}}});
}

TEST(Followers, EntriesThatMoveACommonBody_AreOnOnePathToTheRoot) {
  std::mt19937_64 generator(3);
  for (int round = 0; round < 20; ++round) {
    ModelOptions options;
    options.base = round % 2 == 0 ? Base::Fixed : Base::FreeFlyer;
    const Model model =
        build_model(with_random_followers(random_tree(generator, 20), generator), options);
    for (int body = 0; body < static_cast<int>(model.joints.size()); ++body) {
      const auto support = model.support(body);
      for (std::size_t i = 1; i < support.size(); ++i) {
        EXPECT_LT(support[i - 1], support[i]);
        int k = support[i];
        while (k > support[i - 1]) k = model.parent_of_v[static_cast<std::size_t>(k)];
        EXPECT_EQ(k, support[i - 1]);
      }
    }
  }
}

TEST(Followers, EffortFrictionDampingAndArmature_PassToTheLeader) {
  TreeSpec tree = coupled_hand();
  for (JointSpec& spec : tree.joints) {
    spec.effort_limit = 10.0;
    spec.friction = 0.5;
    spec.damping = 0.2;
    spec.armature = 0.1;
    spec.velocity_limit = 6.0;
  }
  const Model model = build_model(tree);
  const int v = joint_of(model, "z_first").v_index;
  EXPECT_NEAR(model.effort_limit[v], 10.0 * (1.0 + 2.0 + 3.0), 1e-12);
  EXPECT_NEAR(model.friction[v], 0.5 * (1.0 + 2.0 + 3.0), 1e-12);
  EXPECT_NEAR(model.damping[v], 0.2 * (1.0 + 4.0 + 9.0), 1e-12);
  EXPECT_NEAR(model.armature[v], 0.1 * (1.0 + 4.0 + 9.0), 1e-12);
  EXPECT_NEAR(model.velocity_limit[v], 2.0, 1e-12);
  EXPECT_EQ(model.effort_limit[0], 10.0) << "the wrist has no followers";
  // A follower without an effort limit adds nothing.
  tree.joints[2].effort_limit = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(build_model(tree).effort_limit[v], 10.0 * (1.0 + 3.0), 1e-12);
}

TEST(Followers, LimitsOfFollowers_NarrowTheRangeOfTheLeader) {
  TreeSpec tree = coupled_hand();
  tree.joints[1].lower = -0.5;
  tree.joints[1].upper = 0.5;
  tree.joints[2].lower = -0.1;  // 2 q + 0.1: q from -0.1
  tree.joints[2].upper = 0.9;   // to 0.4
  tree.joints[3].lower = -0.4;  // -3 q + 0.35: q up to 0.25
  const Model model = build_model(tree);
  const int q = joint_of(model, "z_first").q_index;
  EXPECT_NEAR(model.q_lower[q], -0.1, 1e-12);
  EXPECT_NEAR(model.q_upper[q], 0.25, 1e-12);
  tree.joints[3].lower = 1.0;
  expect_words(refusal([&] { build_model(tree); }),
               {"hand.urdf", "'third'", "'z_first'", "limits of both"});
  // With multiplier 0, only the offset matters.
  tree = coupled_hand();
  tree.joints[3].mimic->multiplier = 0.0;
  tree.joints[3].upper = 0.4;
  expect_words(refusal([&] { build_model(tree); }), {"'third'", "'z_first'"});
  tree.joints[3].upper = 0.6;
  EXPECT_EQ(build_model(tree).q_upper[q], std::numeric_limits<double>::infinity());
}

TEST(Followers, ContinuousJoints_NeedWholeMultipliers) {
  for (const bool leader_is_continuous : {true, false}) {
    TreeSpec tree = coupled_hand();
    tree.joints[1].type = leader_is_continuous ? JointType::Continuous : JointType::Revolute;
    tree.joints[2].type = leader_is_continuous ? JointType::Revolute : JointType::Continuous;
    tree.joints[3].mimic->multiplier = -2.0;
    for (const double multiplier : {3.0, -2.0, 0.0, 1.0}) {
      tree.joints[2].mimic->multiplier = multiplier;
      expect_placements(tree, build_model(tree), {{"wrist", {0.2}}, {"z_first", {2.9}}});
    }
    tree.joints[2].mimic->multiplier = 0.5;
    expect_words(refusal([&] { build_model(tree); }), {"'second'", "'z_first'", "0.5", "whole"});
    tree.joints[2].mimic->multiplier = 1.0;
    tree.joints[3].mimic->multiplier = 0.5;
    expect_words(refusal([&] { build_model(tree); }), {"'third'", "0.5", "whole"});
    tree.joints[2].mimic->multiplier = 1e7;
    expect_words(refusal([&] { build_model(tree); }), {"'second'", "1e+07"});
  }
  TreeSpec tree = coupled_hand();
  tree.joints[1].type = JointType::Continuous;
  tree.joints[2].type = JointType::Prismatic;
  expect_words(refusal([&] { build_model(tree); }), {"'second'", "'z_first'", "is prismatic"});
}

TEST(Followers, LockedLeader_LocksItsFollowers) {
  ModelOptions options;
  options.locked = {"z_first"};
  options.posture = {{"z_first", {0.3}}};
  const Model model = build_model(coupled_hand(), options);
  EXPECT_EQ(model.nv, 1);
  EXPECT_EQ(model.locked_joints, (std::vector<std::string>{"z_first", "second", "third"}));
  Posture values = {{"z_first", {0.3}}, {"second", {0.7}}, {"third", {-0.55}}};
  for (const auto& [name, placement] : link_placements(coupled_hand(), values, "palm"))
    EXPECT_TRUE(frame_placement(model, model.q_neutral, name).isApprox(placement, 1e-12)) << name;
  options.posture["third"] = {-0.5505};  // files are rounded
  EXPECT_NO_THROW(build_model(coupled_hand(), options));
  options.posture["third"] = {-0.5};
  expect_words(refusal([&] { build_model(coupled_hand(), options); }),
               {"'third'", "'second'", "-0.55", "posture"});
  options.locked = {"z_first", "third"};  // locked by name, at its own value
  EXPECT_NO_THROW(build_model(coupled_hand(), options));
}

TEST(Followers, LockedFollowerOfAMovingLeader_NeedsAValue) {
  ModelOptions options;
  options.locked = {"second"};
  expect_words(refusal([&] { build_model(coupled_hand(), options); }),
               {"'second'", "'z_first'", "moves", "posture"});
  options.posture = {{"second", {0.2}}};
  const Model model = build_model(coupled_hand(), options);
  EXPECT_EQ(model.nv, 2);
  EXPECT_FALSE(joint_of(model, "z_first").follows);
  EXPECT_EQ(model.locked_joints, (std::vector<std::string>{"second", "third"}));
}

TEST(Followers, FreeLeader_FreesItsFollowers) {
  ModelOptions options;
  options.free = {"z_first"};
  const Model model = build_model(coupled_hand(), options);
  EXPECT_EQ(model.nv, 1);
  EXPECT_EQ(model.joints.size(), 3u);
  EXPECT_EQ(model.locked_joints, std::vector<std::string>{"wrist"});
  options.free = {"z_first", "third"};
  EXPECT_EQ(build_model(coupled_hand(), options).joints.size(), 3u);
  options.free = {"second"};
  expect_words(refusal([&] { build_model(coupled_hand(), options); }),
               {"'second'", "'z_first'", "locked"});
}

TEST(Followers, FixedLeader_LocksFollowersAndFixedFollowersAreIgnored) {
  TreeSpec tree = coupled_hand();
  tree.joints[1].type = JointType::Fixed;
  const Model locked = build_model(tree);
  EXPECT_EQ(locked.nv, 1);
  EXPECT_EQ(locked.locked_joints, (std::vector<std::string>{"second", "third"}));
  tree = coupled_hand();
  tree.joints[2].type = JointType::Fixed;
  tree.joints[3].mimic.reset();
  tree.joints[2].mimic->leader = "nobody";
  EXPECT_EQ(build_model(tree).nv, 3) << "a fixed joint has no leader";
}

TEST(Followers, CycleUnknownLeaderOrSeveralCoordinates_AreRefused) {
  TreeSpec tree = coupled_hand();
  tree.joints[1].mimic = MimicSpec{"third", 1.0, 0.0};
  expect_words(refusal([&] { build_model(tree); }), {"hand.urdf", "follows itself"});
  tree.joints[1].mimic = MimicSpec{"z_first", 1.0, 0.0};
  expect_words(refusal([&] { build_model(tree); }), {"'z_first'", "follows itself"});
  tree = coupled_hand();
  tree.joints[2].mimic->leader = "z_firstt";
  expect_words(refusal([&] { build_model(tree); }), {"'second'", "'z_firstt'", "'z_first'?"});
  tree = coupled_hand();
  tree.joints[1].type = JointType::Floating;
  expect_words(refusal([&] { build_model(tree); }), {"'second'", "one coordinate"});
  tree = coupled_hand();
  tree.joints[2].type = JointType::Planar;
  expect_words(refusal([&] { build_model(tree); }), {"'second'", "one coordinate"});
}

TEST(Followers, PostureOfAFollower_SetsTheLeaderAndMustNotContradictIt) {
  const Model model = build_model(coupled_hand());
  const int q = joint_of(model, "z_first").q_index;
  EXPECT_NEAR(configuration(model, {{"second", {0.5}}})[q], 0.2, 1e-12);
  EXPECT_NEAR(configuration(model, {{"z_first", {0.2}}, {"second", {0.5004}}})[q], 0.2, 1e-12);
  const auto sentence = [&](const Posture& posture) {
    return refusal([&] { configuration(model, posture); });
  };
  expect_words(sentence({{"z_first", {0.2}}, {"second", {0.6}}}),
               {"'second'", "0.6", "'z_first'", "0.2", "0.5"});
  expect_words(sentence({{"second", {0.5}}, {"third", {0.0}}}), {"'third'", "'z_first'"});
  expect_words(sentence({{"second", {0.5, 1.0}}}), {"'second'", "2", "wanted 1"});
  TreeSpec tree = coupled_hand();
  tree.joints[1].type = tree.joints[2].type = JointType::Continuous;
  tree.joints[3].mimic->multiplier = 1.0;
  const Model continuous = build_model(tree);
  EXPECT_NO_THROW(configuration(continuous, {{"z_first", {3.0}}, {"second", {6.1 - 6.2831853}}}));
  expect_words(refusal([&] {
                 configuration(continuous, {{"second", {1.0}}});
               }),
               {"'second'", "'z_first'", "not stated"});
}

TEST(Followers, MasslessLeader_MovesTheMassOfItsFollowers) {
  TreeSpec tree = coupled_hand();
  tree.links[2].inertia = {};  // of z_first
  EXPECT_NO_THROW(build_model(tree));
}

}  // namespace
}  // namespace burnish::testing

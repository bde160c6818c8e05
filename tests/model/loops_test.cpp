// Tests of the kinematic loops of a model: frames, refusals, and loops of locked joints.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/model/model.hpp"
#include "support/loop_trees.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

std::string refused(const TreeSpec& tree, const ModelOptions& options = {}) {
  return refusal([&] { build_model(tree, options); });
}

TEST(Loops, Loop_AddsTwoFramesToItsLinks) {
  const Model model = build_model(four_bar());
  ASSERT_EQ(model.loops.size(), 1U);
  EXPECT_EQ(model.loops[0].name, "pin");
  EXPECT_EQ(model.loops[0].directions, Directions::linear());
  const Frame& first = model.frames[model.frame_index(model.loops[0].first)];
  const Frame& second = model.frames[model.frame_index(model.loops[0].second)];
  EXPECT_EQ(first.body, model.joint_index("knee"));
  EXPECT_EQ(second.body, model.joint_index("pivot"));
  const Eigen::Isometry3d tip = burnish::frame_placement(model, model.q_neutral, "pin/first");
  EXPECT_TRUE(tip.translation().isApprox(Eigen::Vector3d(0.4, 0.0, 0.0), 1e-12));
}

TEST(Loops, LinkAndWorld_CanBeTied) {
  TreeSpec tree = four_bar();
  tree.loops[0].second_link = "world";
  tree.loops[0].second.translation() = Eigen::Vector3d(0.3, 0.0, 0.2);
  const Model model = build_model(tree);
  EXPECT_EQ(model.frames[model.frame_index("pin/second")].body, -1);
}

TEST(Loops, AddedFrame_CanBeFixedToALoopFrame) {
  ModelOptions options;
  options.frames = {{"tip", "pin/first"}};
  EXPECT_TRUE(build_model(four_bar(), options).has_frame("tip"));
}

TEST(Loops, InvalidLoop_IsRefusedByName) {
  TreeSpec tree = four_bar();
  tree.loops[0].first_link = "couple";
  expect_words(refused(tree), {"four_bar.urdf", "loop 'pin'", "'couple'", "'coupler'"});
  tree = four_bar();
  tree.loops[0].second_link = "coupler";
  expect_words(refused(tree), {"loop 'pin'", "'coupler' to itself"});
  tree = four_bar();
  tree.loops.push_back(tree.loops[0]);
  expect_words(refused(tree), {"loop 'pin' is defined twice"});
  tree = four_bar();
  tree.loops[0].directions = {};
  expect_words(refused(tree), {"loop 'pin'", "no direction"});
  tree = four_bar();
  tree.loops[0].name.clear();
  expect_words(refused(tree), {"a loop has no name"});
  tree = four_bar();
  tree.loops[0].first.linear() *= 2.0;
  expect_words(refused(tree), {"loop 'pin'", "first frame", "not a rigid transformation"});
  tree = four_bar();
  tree.loops[0].line = 12;
  tree.links[1].name = "pin/first";
  tree.joints[0].child_link = tree.joints[1].parent_link = "pin/first";
  expect_words(refused(tree), {"line 12", "loop 'pin'", "'pin/first'", "unique names"});
}

TEST(Loops, LoopWithinOneBody_IsDroppedIfClosedElseRefused) {
  TreeSpec tree = four_bar();
  ModelOptions options;
  options.locked = {"drive", "knee", "pivot"};
  // All bars are along x, and the tips of coupler and rocker are 0.15 m apart.
  expect_words(refused(tree, options), {"loop 'pin'", "'coupler'", "'rocker'", "150 mm"});
  tree.loops[0].second.translation().x() = 0.1;
  const Model model = build_model(tree, options);
  EXPECT_TRUE(model.loops.empty());
  EXPECT_FALSE(model.has_frame("pin/first"));
  tree.loops[0].directions = Directions::all();
  tree.loops[0].second.linear() =
      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  expect_words(refused(tree, options), {"loop 'pin'", "5.72958 degrees"});
}

TEST(Loops, LoopBetweenTwoBodies_StaysWithALockedJoint) {
  ModelOptions options;
  options.locked = {"pivot"};
  EXPECT_EQ(build_model(four_bar(), options).loops.size(), 1U);
}

}  // namespace
}  // namespace burnish::testing

// Descriptions that are not a tree of physical bodies are refused by name.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/model/model.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::infinity;
using test::nan;

struct BadTree {
  std::string name;
  std::function<void(TreeSpec&)> spoil;
  std::vector<std::string> words;
};

const std::vector<BadTree>& bad_trees() {
  using Tree = TreeSpec;
  static const std::vector<BadTree> trees = {
      {"NoLinks", [](Tree& t) { t.links.clear(); }, {"no links"}},
      {"TwoLinks", [](Tree& t) { t.links.push_back(link("c")); }, {"link 'c'", "twice"}},
      {"TwoJoints", [](Tree& t) { t.joints[1].name = "b"; }, {"joint 'b'", "twice"}},
      {"NoName", [](Tree& t) { t.links[2].name = ""; }, {"link number 3", "no name"}},
      {"Parent", [](Tree& t) { t.joints[2].parent_link = "basf"; }, {"'d'", "'basf'", "'base'?"}},
      {"Child", [](Tree& t) { t.joints[2].child_link = "x"; }, {"'d'", "child", "'x'"}},
      {"TwoRoots", [](Tree& t) { t.joints.pop_back(); }, {"'base'", "'e'", "root"}},
      {"TwoParents",
       [](Tree& t) { t.joints.push_back(joint("f", JointType::Fixed, "c", "d")); },
       {"link 'd'", "two parents", "'a'", "'c'"}},
      {"Cycle", [](Tree& t) { t.joints[0].parent_link = "e"; }, {"ancestor"}},
      {"Self", [](Tree& t) { t.joints[4].parent_link = "e"; }, {"'e'", "ancestor"}},
      {"WholeCycle",
       [](Tree& t) { t.joints.push_back(joint("f", JointType::Fixed, "e", "base")); },
       {"ancestor"}},
      {"Mass", [](Tree& t) { t.links[1].inertia.mass = -1.2; }, {"'a'", "-1.2", "negative"}},
      {"MassNan", [](Tree& t) { t.links[1].inertia.mass = nan; }, {"'a'", "mass", "nan"}},
      {"ComInf", [](Tree& t) { t.links[1].inertia.com[1] = infinity; }, {"'a'", "centre", "inf"}},
      {"InertiaNan",
       [](Tree& t) { t.links[1].inertia.inertia_at_com(0, 1) = nan; },
       {"'a'", "inertia", "nan"}},
      {"Skewed",
       [](Tree& t) { t.links[1].inertia.inertia_at_com(0, 1) = 0.01; },
       {"'a'", "symmetric"}},
      {"NegativeInertia",
       [](Tree& t) { t.links[1].inertia.inertia_at_com(0, 0) = -1.0; },
       {"'a'", "moment of inertia -1", "negative"}},
      {"ZeroAxis", [](Tree& t) { t.joints[0].axis.setZero(); }, {"joint 'b'", "axis", "zero"}},
      {"AxisNan", [](Tree& t) { t.joints[0].axis[0] = nan; }, {"joint 'b'", "axis", "nan"}},
      {"Placement",
       [](Tree& t) { t.joints[0].placement.translation()[0] = infinity; },
       {"joint 'b'", "placement", "inf"}},
      {"Rotation",
       [](Tree& t) { t.joints[0].placement.linear() *= -1.0; },
       {"joint 'b'", "rotation"}},
      {"Limits",
       [](Tree& t) {
         t.joints[0].lower = 2.0;
         t.joints[0].upper = 1.0;
       },
       {"joint 'b'", "lower", "2", "above", "1"}},
      {"LowerNan", [](Tree& t) { t.joints[0].lower = nan; }, {"joint 'b'", "lower", "nan"}},
      {"UpperNan", [](Tree& t) { t.joints[0].upper = nan; }, {"joint 'b'", "upper", "nan"}},
      {"Velocity", [](Tree& t) { t.joints[0].velocity_limit = -1; }, {"'b'", "velocity", "-1"}},
      {"Effort", [](Tree& t) { t.joints[0].effort_limit = nan; }, {"'b'", "effort", "nan"}},
      {"Damping", [](Tree& t) { t.joints[0].damping = -1; }, {"'b'", "damping", "-1"}},
      {"Friction", [](Tree& t) { t.joints[0].friction = infinity; }, {"'b'", "friction", "inf"}},
      {"Armature", [](Tree& t) { t.joints[0].armature = -3; }, {"'b'", "armature", "-3"}},
      {"InertiaHuge",
       [](Tree& t) { t.links[4].inertia.mass = t.links[4].inertia.com[0] = 1e160; },
       {"joint 'd'", "overflows"}},
      {"VisualSize",
       [](Tree& t) {
         t.links[1].visuals = {{SphereShape{-1}, Eigen::Isometry3d::Identity(), {}}};
         t.links[1].visuals[0].rgba.setOnes();
       },
       {"'a'", "visual", "-1"}},
      {"VisualBox",
       [](Tree& t) {
         t.links[1].visuals = {{BoxShape{{1, nan, 1}}, Eigen::Isometry3d::Identity(), {}}};
         t.links[1].visuals[0].rgba.setOnes();
       },
       {"'a'", "visual", "nan"}},
  };
  return trees;
}

class InvalidTree : public ::testing::TestWithParam<BadTree> {};

TEST_P(InvalidTree, AnyDefect_IsRefusedByName) {
  TreeSpec tree = branching_tree();
  ASSERT_NO_THROW(build_model(tree));
  GetParam().spoil(tree);
  std::vector<std::string> words = GetParam().words;
  words.push_back("branches.urdf: ");
  expect_words(refusal([&] { build_model(tree); }), words);
}

INSTANTIATE_TEST_SUITE_P(Build, InvalidTree, ::testing::ValuesIn(bad_trees()),
                         [](const auto& test) { return test.param.name; });

TEST(ModelBuild, SeveralProblems_AreAllListed) {
  TreeSpec tree = branching_tree();
  tree.links[1].inertia.mass = -1.2;
  tree.joints[0].axis.setZero();
  tree.joints[0].damping = nan;
  tree.joints[2].parent_link = "basf";
  tree.joints[2].line = 17;
  const std::string sentence = refusal([&] { build_model(tree); });
  expect_words(sentence,
               {"branches.urdf: 4 problems: (1) line 17: joint 'd': parent link 'basf'",
                "(2) link 'a': mass -1.2", "(3) joint 'b': its axis", "(4) joint 'b': damping"});
}

TEST(ModelBuild, PositionLimitOfABall_IsIgnoredWithAWarning) {
  TreeSpec tree = branching_tree();
  tree.joints[0].type = JointType::Ball;
  tree.joints[0].axis.setZero();  // a ball joint needs no axis
  EXPECT_TRUE(build_model(tree).warnings.empty());
  tree.joints[0].upper = 1.0;
  const Model model = build_model(tree);
  ASSERT_EQ(model.warnings.size(), 1u);
  expect_words(model.warnings[0], {"joint 'b'", "ball", "ignored"});
  EXPECT_TRUE(std::isinf(model.q_upper[model.joints[0].q_index]));
}

TEST(ModelBuild, InvalidOptions_AreRefused) {
  ModelOptions options;
  options.gravity[2] = nan;
  expect_words(refusal([&] { build_model(branching_tree(), options); }), {"gravity"});
  options = {};
  options.base_placement.translation()[0] = nan;
  expect_words(refusal([&] { build_model(branching_tree(), options); }), {"base"});
  options = {};
  options.base = Base::FreeFlyer;
  TreeSpec tree = branching_tree();
  tree.joints[0].name = "root_joint";
  expect_words(refusal([&] { build_model(tree, options); }), {"root_joint", "another name"});
  EXPECT_NO_THROW(build_model(tree));
}

}  // namespace
}  // namespace burnish::testing

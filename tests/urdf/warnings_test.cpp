// Questionable descriptions load with a warning; strict reading refuses them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

#include "burnish/model/model.hpp"
#include "burnish/urdf/urdf.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::infinity;

/// The warnings in one line.
std::string joined(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) text += (text.empty() ? "" : " | ") + warning;
  return text;
}

/// Expects `count` warnings that contain the words, and a strict refusal with the same words.
void expect_warnings(const TreeSpec& tree, ModelOptions options, std::size_t count,
                     const std::vector<std::string>& words) {
  const Model model = build_model(tree, options);
  EXPECT_EQ(model.warnings.size(), count) << joined(model.warnings);
  options.strict = true;
  if (count == 0) {
    EXPECT_NO_THROW(build_model(tree, options));
    return;
  }
  expect_words(joined(model.warnings), words);
  std::vector<std::string> refusal_words = words;
  refusal_words.push_back("strict");
  expect_words(refusal([&] { build_model(tree, options); }), refusal_words);
}

struct TreeCase {
  std::string name;
  std::function<void(TreeSpec&)> spoil;
  std::vector<std::string> words;
};
void PrintTo(const TreeCase& tree, std::ostream* out) { *out << tree.name; }

void set_inertia(TreeSpec& tree, std::size_t link, double mass, const Eigen::Matrix3d& inertia) {
  tree.links[link].inertia.mass = mass;
  tree.links[link].inertia.inertia_at_com = inertia;
}

const std::vector<TreeCase>& tree_cases() {
  using Tree = TreeSpec;
  static const std::vector<TreeCase> trees = {
      {"Triangle",
       [](Tree& t) { set_inertia(t, 1, 1.0, Eigen::Vector3d(1.0, 1.0, 2.2).asDiagonal()); },
       {"branches.urdf: ", "link 'a'", "2.2", "no solid"}},
      {"Dummy",  // a placeholder: one number for all entries
       [](Tree& t) { set_inertia(t, 1, 1e-6, Eigen::Matrix3d::Constant(1e-6)); },
       {"link 'a'", "no solid"}},
      {"SlightlyNegative",
       [](Tree& t) { set_inertia(t, 1, 0.001, Eigen::Vector3d(-3.5e-8, 1e-6, 1e-6).asDiagonal()); },
       {"link 'a'", "-3.5e-08", "negative"}},
      {"Products",
       [](Tree& t) {
         set_inertia(t, 1, 1.0, Eigen::Matrix3d::Identity());
         Eigen::Matrix3d& inertia = t.links[1].inertia.inertia_at_com;
         inertia(0, 1) = inertia(1, 0) = 2.0;
       },
       {"link 'a'", "principal moment -1", "negative"}},
      {"Massless",
       [](Tree& t) { t.links[4].inertia = {}; },
       {"joint 'd' moves no mass", "singular", "lock the joint"}},
      {"PointOnAxis",
       [](Tree& t) { t.links[3].inertia.inertia_at_com.setZero(); },
       {"joint 'c' moves no mass"}},
  };
  return trees;
}

class QuestionableTree : public ::testing::TestWithParam<TreeCase> {};

TEST_P(QuestionableTree, AnyDefect_GivesOneWarning) {
  TreeSpec tree = branching_tree();
  ASSERT_TRUE(build_model(tree).warnings.empty());
  GetParam().spoil(tree);
  expect_warnings(tree, {}, 1, GetParam().words);
}

INSTANTIATE_TEST_SUITE_P(Warnings, QuestionableTree, ::testing::ValuesIn(tree_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(Warnings, RoundingErrors_GiveNone) {
  TreeSpec tree = branching_tree();
  set_inertia(tree, 1, 1.0, Eigen::Vector3d(1.0, 1.0, 2.09).asDiagonal());
  expect_warnings(tree, {}, 0, {});
  // The inertia of a point mass is only rounding errors, so it is not checked.
  set_inertia(tree, 1, 1.0, Eigen::Vector3d(-2.4e-35, 0.0, 1e-34).asDiagonal());
  expect_warnings(tree, {}, 0, {});
  set_inertia(tree, 1, 1e-3, Eigen::Vector3d(-1e-20, 1e-20, 5e-20).asDiagonal());
  expect_warnings(tree, {}, 0, {});
}

TEST(Warnings, ArmatureWithoutMass_GivesNone) {
  TreeSpec tree = branching_tree();
  tree.links[4].inertia = {};
  tree.joints[2].armature = 1e-3;
  expect_warnings(tree, {}, 0, {});
}

/// Two hinges with a massless link between: a universal joint if their axes differ, one rotation
/// twice if the axes are one line.
TreeSpec two_hinges(const Eigen::Vector3d& second_axis) {
  TreeSpec tree;
  tree.links = {link("base"), link("cross", 0.0), link("tip")};
  tree.joints = {joint("first", JointType::Revolute, "base", "cross"),
                 joint("second", JointType::Revolute, "cross", "tip", second_axis)};
  tree.joints[1].placement.setIdentity();
  return tree;
}

TEST(Warnings, JointsThatMoveTheSameMass_AreNamed) {
  expect_warnings(two_hinges(Eigen::Vector3d::UnitX()), {}, 0, {});
  expect_warnings(two_hinges(Eigen::Vector3d::UnitZ()), {}, 1,
                  {"joint 'first'", "no mass of its own"});
  TreeSpec parallel = two_hinges(Eigen::Vector3d::UnitZ());
  parallel.joints[1].placement.translation().x() = 0.5;
  expect_warnings(parallel, {}, 0, {});
  // The whole mass is on the axis in the zero posture only.
  TreeSpec folded = two_hinges(Eigen::Vector3d::UnitX());
  folded.links[2].inertia.inertia_at_com.setZero();
  folded.links[2].inertia.com = Eigen::Vector3d(0.0, 0.0, 1.0);
  expect_warnings(folded, {}, 0, {});
}

TEST(Warnings, RobotWithoutMass_GivesOne) {
  TreeSpec tree = branching_tree();
  for (LinkSpec& spec : tree.links) spec.inertia = {};
  const std::size_t joints = build_model(tree).joints.size();
  expect_warnings(tree, {}, 1, {"joints '", "move no mass"});
  ModelOptions floating;
  floating.base = Base::FreeFlyer;
  expect_warnings(tree, floating, 1, {"'root_joint'", "move no mass"});
  EXPECT_EQ(build_model(tree, floating).joints.size(), joints + 1);
}

TEST(Warnings, SeveralMasslessJoints_AreAllNamed) {
  TreeSpec tree = branching_tree();
  for (const std::size_t tip : {3u, 4u}) tree.links[tip].inertia = {};
  expect_warnings(tree, {}, 1, {"joints 'd' and 'c' move no mass"});
}

TEST(Warnings, NegativeInertia_NamesTheJoint) {
  TreeSpec tree = two_hinges(Eigen::Vector3d(1.0, -1.0, 0.0));
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();
  inertia(0, 1) = inertia(1, 0) = 50.0;
  set_inertia(tree, 2, 0.0, inertia);
  expect_warnings(
      tree, {}, 2,
      {"link 'tip'", "joint 'second' moves a negative inertia", "not positive definite"});
}

/// A robot of one joint, with the given contents of link and joint.
std::string file(const std::string& joint_type, const std::string& joint_content,
                 const std::string& link_content = "",
                 const std::string& start = "<robot name='r'>") {
  return start +
         "<link name='a'/>\n<link name='b'><inertial><origin xyz='0.1 0 0.2'/><mass value='1'/>"
         "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>" +
         link_content + "</link>\n<joint name='j' type='" + joint_type +
         "'><parent link='a'/><child link='b'/>" + joint_content + "</joint></robot>";
}
std::string visual(const std::string& content) { return "<visual>" + content + "</visual>"; }

struct FileCase {
  std::string name, xml;
  std::vector<std::string> words;  ///< words of the one warning; empty if none is expected
};
void PrintTo(const FileCase& file, std::ostream* out) { *out << file.name; }

const std::vector<FileCase>& file_cases() {
  static const std::string ball = "<geometry><sphere radius='1'/></geometry>";
  static const std::string red = "<material name='m'><color rgba='1 0 0 1'/></material>";
  static const std::string box = "<geometry><box size='1 2'/></geometry>";
  static const std::vector<FileCase> files = {
      {"NoName", file("fixed", "", "", "<robot>"), {"odd.urdf: line 1: ", "no name", "'odd'"}},
      {"EmptyName", file("fixed", "", "", "<robot name=''>"), {"no name", "'odd'"}},
      {"Property",
       file("fixed", "", "", "<robot name='r'>\n<xacro:property name='p' value='1'/>"),
       {"line 2", "<xacro:property>", "ignored"}},
      {"MacroInALink", file("fixed", "", "<xacro:solid m='1'/>"), {"link 'b'", "<xacro:solid>"}},
      {"MacroInAJoint", file("fixed", "<xacro:motor/>"), {"joint 'j'", "<xacro:motor>"}},
      {"MacroInWhatIsNotRead",
       file("fixed", "", "", "<robot name='r'><gazebo><xacro:sensor/></gazebo>"),
       {}},
      {"NoLimit", file("revolute", ""), {"line 3: joint 'j'", "no <limit>", "unlimited"}},
      {"NoRange", file("prismatic", "<limit effort='1'/>"), {"neither", "unlimited"}},
      {"NoLower", file("revolute", "<limit upper='-1'/>"), {"no 'lower'", "unlimited"}},
      {"NoUpper", file("revolute", "<limit lower='1'/>"), {"no 'upper'", "unlimited"}},
      {"LowerByDefault", file("revolute", "<limit upper='1'/>"), {}},
      {"NoEffort", file("revolute", "<limit lower='-1' upper='1'/>"), {}},
      {"NoSpeed",
       file("revolute", "<limit lower='-1' upper='1' velocity='0'/>"),
       {"line 3: joint 'j'", "'velocity' = 0", "unlimited"}},
      {"NoTorque",
       file("continuous", "<limit effort='0.0' velocity='2'/>"),
       {"line 3: joint 'j'", "'effort' = 0", "unlimited"}},
      {"FixedJointWithEverything",
       file("fixed", "<axis/><limit effort='-1'/><dynamics damping='x'/><mimic joint='k'/>"),
       {}},
      {"FloatingJointWithAnAxis", file("floating", "<axis xyz='0 0'/>"), {}},
      {"NoGeometry", file("fixed", "", visual("")), {}},
      {"NoShape", file("fixed", "", visual("<geometry/>")), {}},
      {"TwoMaterials", file("fixed", "", visual(ball + red + red)), {}},
      {"TwoMaterialsOfAName", file("fixed", "", "", "<robot name='r'>" + red + red), {}},
      {"MaterialWithoutAName", file("fixed", "", "", "<robot name='r'><material/>"), {}},
      {"Colour",
       file("fixed", "", visual(ball + "<material><color rgba='255 0 0 1'/></material>")),
       {}},
      {"ColourLess", file("fixed", "", visual(ball + "<material><color/></material>")), {}},
      {"Capsule",
       file("fixed", "", visual("<geometry><capsule/></geometry>")),
       {"link 'b'", "<capsule>", "not drawn"}},
      {"BoxSize", file("fixed", "", visual(box)), {"link 'b'", "3 numbers", "not drawn"}},
      {"Radius",
       file("fixed", "", visual("<geometry><sphere radius='-1'/></geometry>")),
       {"link 'b'", "-1", "not drawn"}},
      {"MeshFile",
       file("fixed", "", visual("<geometry><mesh/></geometry>")),
       {"link 'b'", "'filename'", "not drawn"}},
      {"VisualOrigin", file("fixed", "", visual(ball + "<origin xyz='0'/>")), {"not drawn"}},
  };
  return files;
}

class QuestionableFile : public ::testing::TestWithParam<FileCase> {};

TEST_P(QuestionableFile, Content_GivesTheExpectedWarning) {
  const TreeSpec tree = parse_urdf(GetParam().xml, "folder/odd.urdf");
  const bool has_warning = !GetParam().words.empty();
  EXPECT_EQ(tree.warnings.size(), has_warning ? 1u : 0u) << joined(tree.warnings);
  expect_warnings(tree, {}, has_warning ? 1 : 0, GetParam().words);
}

INSTANTIATE_TEST_SUITE_P(Warnings, QuestionableFile, ::testing::ValuesIn(file_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(UrdfDefaults, MissingLimits_AreInfiniteOrZero) {
  const auto first_joint = [](const std::string& content) {
    return parse_urdf(file("revolute", content)).joints[0];
  };
  for (const char* content : {"", "<limit effort='2'/>"}) {
    EXPECT_EQ(first_joint(content).lower, -infinity);
    EXPECT_EQ(first_joint(content).upper, infinity);
  }
  EXPECT_EQ(first_joint("<limit upper='-1'/>").lower, -infinity);
  EXPECT_EQ(first_joint("<limit upper='-1'/>").upper, -1.0);
  EXPECT_EQ(first_joint("<limit upper='1'/>").lower, 0.0);  // the default of the format
  EXPECT_EQ(first_joint("<limit lower='1'/>").upper, infinity);
}

TEST(UrdfDefaults, ZeroSpeedAndTorque_AreUnlimitedWithWarnings) {
  const TreeSpec tree =
      parse_urdf(file("revolute", "<limit lower='-1' upper='1' velocity='0' effort='0'/>"));
  EXPECT_EQ(tree.joints[0].velocity_limit, infinity);
  EXPECT_EQ(tree.joints[0].effort_limit, infinity);
  EXPECT_EQ(tree.warnings.size(), 2U) << joined(tree.warnings);
}

TEST(UrdfDefaults, FollowerWithZeroEffort_KeepsIt) {
  const TreeSpec tree = parse_urdf(
      file("revolute", "<limit lower='-1' upper='1' velocity='1' effort='0'/><mimic joint='k'/>"));
  EXPECT_EQ(tree.joints[0].effort_limit, 0.0);
  EXPECT_TRUE(tree.warnings.empty()) << joined(tree.warnings);
}

TEST(UrdfDefaults, FixedJoint_HasNoLeader) {
  EXPECT_FALSE(parse_urdf(file("fixed", "<mimic joint='k'/>")).joints[0].mimic.has_value());
}

TEST(UrdfDefaults, TwoMaterials_UseTheFirstColour) {
  const std::string xml = file("fixed", "",
                               visual("<geometry><sphere radius='1'/></geometry><material/>"
                                      "<material><color rgba='0 1 0 1'/></material>"
                                      "<material><color rgba='1 0 0 1'/></material>"));
  EXPECT_EQ(parse_urdf(xml).links[1].visuals[0].rgba, Eigen::Vector4d(0, 1, 0, 1));
}

TEST(UrdfDefaults, RobotWithoutAName_IsNamedAfterItsFile) {
  const std::string xml = "<robot><link name='a'/></robot>";
  EXPECT_EQ(parse_urdf(xml, "some/ur3.urdf").name, "ur3");
  EXPECT_EQ(parse_urdf(xml, "/dev/fd/63").name, "robot");
  EXPECT_EQ(parse_urdf(xml, "/dev/stdin").name, "robot");
  EXPECT_EQ(parse_urdf(xml).name, "robot");
}

}  // namespace
}  // namespace burnish::testing

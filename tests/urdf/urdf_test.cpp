// Tests of the URDF reader: values, defaults, warnings and refused files.
#include "burnish/urdf/urdf.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <clocale>
#include <filesystem>

#include "burnish/model/model.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "support/special_numbers.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using test::infinity;

/// Two links and a hinge, with every element of the format.
const char* const full = R"(<?xml version="1.0"?>
<!-- <link name="only_a_comment"/> -->
<robot name="full" version="1.0">
  <material name="red"><color rgba="1 0 0 0.5"/></material>
  <link name="base">
    <visual>
      <origin xyz="0 0 0.5" rpy="0 0 1.5707963267948966"/>
      <geometry><box size="1	2
        3"/></geometry>
      <material name="red"/>
    </visual>
    <visual><geometry><cylinder radius="0.1" length="0.2"/></geometry>
      <material name="green"><color rgba="0 1 0 1"/></material></visual>
    <visual><geometry><sphere radius="0.3"/></geometry><material name="green"/></visual>
    <visual><geometry><mesh filename="package://full/arm.dae" scale="1 2 0.5"/></geometry>
      <material name="nowhere"/></visual>
    <collision><geometry><capsule radius="what"/></geometry></collision>
  </link>
  <link name="arm">
    <inertial>
      <origin xyz="0.1 0.2 0.3" rpy="0 0 1.5707963267948966"/>
      <mass value="+2.5e0"/>
      <inertia ixx="1" ixy="0.1" ixz="0" iyy="2" iyz="0" izz="2.5"/>
    </inertial>
  </link>
  <joint name="hinge" type="revolute">
    <parent link="base"/><child link="arm"/>
    <origin xyz="1 2 3" rpy="0.1 0.2 0.3"/>
    <axis xyz="0 3 4"/>
    <limit lower="-1" upper="2" velocity="3" effort="4"/>
    <dynamics damping="0.5" friction="0.25" armature="0.125" stiffness="3.5" rest="-0.5"/>
    <safety_controller k_velocity="0"/>
  </joint>
  <transmission name="t"><joint name="hinge"/></transmission>
  <gazebo reference="arm"/>
</robot>)";

TEST(Urdf, Names_AreReadInTheOrderOfTheFile) {
  const TreeSpec tree = parse_urdf(full, "full.urdf");
  EXPECT_EQ(tree.name, "full");
  EXPECT_EQ(tree.source, "full.urdf");
  ASSERT_EQ(tree.links.size(), 2u);
  EXPECT_EQ(tree.links[0].name, "base");
  EXPECT_EQ(tree.links[1].name, "arm");
  ASSERT_EQ(tree.joints.size(), 1u);
}

TEST(Urdf, Inertias_AreRead) {
  const TreeSpec tree = parse_urdf(full);
  EXPECT_EQ(tree.links[0].inertia.mass, 0.0);
  EXPECT_TRUE(tree.links[0].inertia.inertia_at_com.isZero());
  const InertiaSpec& inertia = tree.links[1].inertia;
  EXPECT_EQ(inertia.mass, 2.5);
  EXPECT_EQ(inertia.com, Eigen::Vector3d(0.1, 0.2, 0.3));
  // A quarter turn about z exchanges x and y, and changes the sign of their product.
  Eigen::Matrix3d turned;
  turned << 2.0, -0.1, 0.0, -0.1, 1.0, 0.0, 0.0, 0.0, 2.5;
  EXPECT_TRUE(inertia.inertia_at_com.isApprox(turned, 1e-14));
}

TEST(Urdf, Joints_AreRead) {
  const JointSpec joint = parse_urdf(full).joints[0];
  EXPECT_EQ(joint.name, "hinge");
  EXPECT_EQ(joint.type, JointType::Revolute);
  EXPECT_EQ(joint.parent_link, "base");
  EXPECT_EQ(joint.child_link, "arm");
  EXPECT_EQ(joint.placement.translation(), Eigen::Vector3d(1, 2, 3));
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()))
                                       .toRotationMatrix();
  EXPECT_TRUE(joint.placement.linear().isApprox(rotation, 1e-14));
  EXPECT_TRUE(joint.axis.isApprox(Eigen::Vector3d(0.0, 0.6, 0.8), 1e-15));
  EXPECT_EQ(joint.lower, -1.0);
  EXPECT_EQ(joint.upper, 2.0);
  EXPECT_EQ(joint.velocity_limit, 3.0);
  EXPECT_EQ(joint.effort_limit, 4.0);
  EXPECT_EQ(joint.damping, 0.5);
  EXPECT_EQ(joint.friction, 0.25);
  EXPECT_EQ(joint.armature, 0.125);
  EXPECT_EQ(joint.stiffness, 3.5);
  EXPECT_EQ(joint.rest, -0.5);
  EXPECT_FALSE(joint.mimic.has_value());
}

TEST(Urdf, Visuals_AreRead) {
  const std::vector<VisualSpec> visuals = parse_urdf(full).links[0].visuals;
  ASSERT_EQ(visuals.size(), 4u);
  EXPECT_EQ(std::get<BoxShape>(visuals[0].shape).size, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(visuals[0].rgba, Eigen::Vector4d(1.0, 0.0, 0.0, 0.5));
  EXPECT_TRUE(visuals[0].placement.translation().isApprox(Eigen::Vector3d(0, 0, 0.5)));
  EXPECT_TRUE(visuals[0].placement.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-14));
  EXPECT_EQ(std::get<CylinderShape>(visuals[1].shape).radius, 0.1);
  EXPECT_EQ(std::get<CylinderShape>(visuals[1].shape).length, 0.2);
  EXPECT_EQ(visuals[1].rgba, Eigen::Vector4d(0, 1, 0, 1));
  EXPECT_EQ(std::get<SphereShape>(visuals[2].shape).radius, 0.3);
  EXPECT_EQ(visuals[2].rgba, Eigen::Vector4d(0, 1, 0, 1));  // defined by the previous visual
  const auto& mesh = std::get<MeshShape>(visuals[3].shape);
  EXPECT_EQ(mesh.uri, "package://full/arm.dae");
  EXPECT_EQ(mesh.scale, Eigen::Vector3d(1, 2, 0.5));
  EXPECT_EQ(visuals[3].rgba, VisualSpec().rgba);  // undefined: the default grey
}

/// A robot of one joint between links a and b.
std::string robot(const std::string& joint_attributes, const std::string& joint_content,
                  const std::string& link_content = "", const std::string& more = "") {
  return "<robot name=\"r\"><link name=\"a\"/><link name=\"b\">" + link_content + "</link><joint " +
         joint_attributes + "><parent link=\"a\"/><child link=\"b\"/>" + joint_content +
         "</joint>" + more + "</robot>";
}
std::string robot_of_type(const std::string& type, const std::string& content = "") {
  return robot("name=\"j\" type=\"" + type + "\"", content);
}

TEST(Urdf, EveryJointType_IsRead) {
  const std::string limit = "<limit lower=\"0\" upper=\"1\" velocity=\"1\" effort=\"1\"/>";
  const std::vector<std::pair<std::string, JointType>> types = {
      {"fixed", JointType::Fixed},           {"revolute", JointType::Revolute},
      {"continuous", JointType::Continuous}, {"prismatic", JointType::Prismatic},
      {"planar", JointType::Planar},         {"floating", JointType::Floating}};
  for (const auto& [name, type] : types) {
    const JointSpec joint = parse_urdf(robot_of_type(name, limit)).joints[0];
    EXPECT_EQ(joint.type, type) << name;
    const bool limited = type == JointType::Revolute || type == JointType::Prismatic;
    EXPECT_EQ(joint.upper, limited ? 1.0 : infinity) << name;
    EXPECT_EQ(joint.axis, Eigen::Vector3d::UnitX()) << name;  // the default of the format
  }
}

TEST(Urdf, MissingNumbers_AreInfiniteOrZero) {
  const JointSpec joint =
      parse_urdf(robot_of_type("revolute", "<limit upper=\"1\"/><dynamics armature=\"2\"/>"))
          .joints[0];
  EXPECT_EQ(joint.lower, 0.0);
  EXPECT_EQ(joint.velocity_limit, infinity);
  EXPECT_EQ(joint.effort_limit, infinity);
  EXPECT_EQ(joint.damping, 0.0);
  EXPECT_EQ(joint.armature, 2.0);
  EXPECT_EQ(parse_urdf(robot_of_type("continuous")).joints[0].effort_limit, infinity);
  EXPECT_EQ(parse_urdf(robot_of_type("revolute", "<limit lower=\"-inf\" upper=\"inf\"/>"))
                .joints[0]
                .lower,
            -infinity);
}

TEST(Urdf, ContinuousJointWithARange_GivesAWarning) {
  const auto warnings = [](const std::string& limit) {
    return parse_urdf(robot_of_type("continuous", limit)).warnings;
  };
  const auto texts = warnings("<limit lower=\"-1.05\" upper=\"0.7\" velocity=\"1\" effort=\"1\"/>");
  ASSERT_EQ(texts.size(), 1U);
  expect_words(texts[0], {"joint 'j'", "continuous", "-1.05", "0.7", "revolute"});
  // Exporters write such ranges, of a full turn or more or zero, or none, for continuous joints.
  for (const char* range : {"lower=\"-3.1416\" upper=\"3.1416\"", "lower=\"0\" upper=\"0\"",
                            "lower=\"-6.28\" upper=\"6.28\"", ""})
    EXPECT_TRUE(warnings("<limit " + std::string(range) + " velocity=\"1\" effort=\"1\"/>").empty())
        << range;
}

TEST(Urdf, Mimic_IsRead) {
  const JointSpec joint = parse_urdf(robot_of_type("continuous", "<mimic joint=\"k\"/>")).joints[0];
  ASSERT_TRUE(joint.mimic.has_value());
  EXPECT_EQ(joint.mimic->leader, "k");
  EXPECT_EQ(joint.mimic->multiplier, 1.0);
  EXPECT_EQ(joint.mimic->offset, 0.0);
  const JointSpec other =
      parse_urdf(
          robot_of_type("continuous", "<mimic joint=\"k\" multiplier=\"-2\" offset=\"0.5\"/>"))
          .joints[0];
  EXPECT_EQ(other.mimic->multiplier, -2.0);
  EXPECT_EQ(other.mimic->offset, 0.5);
}

TEST(Urdf, SpecialCharactersInNames_AreKept) {
  std::string xml = robot_of_type("fixed");
  xml.replace(xml.find("\"j\""), 3, "\"j &amp; &quot;k&quot; &lt;ü&gt;\"");
  EXPECT_EQ(parse_urdf(xml).joints[0].name, "j & \"k\" <ü>");
}

TEST(Urdf, Locale_IsIgnored) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) {
    if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
  }
  const TreeSpec tree = parse_urdf(full);
  std::setlocale(LC_NUMERIC, before.c_str());
  EXPECT_EQ(tree.links[1].inertia.mass, 2.5);
  EXPECT_EQ(tree.joints[0].damping, 0.5);
}

TEST(Urdf, Parsing_WritesNothingToTheConsole) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_NO_THROW(parse_urdf(full));
  EXPECT_THROW(parse_urdf("<robot name=\"r\"><link/></robot>"), Error);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

struct BadFile {
  std::string name;
  std::string xml;
  std::vector<std::string> words;
};
void PrintTo(const BadFile& file, std::ostream* out) { *out << file.name; }

std::string inertial(const std::string& mass, const std::string& ixx, const std::string& izz) {
  return "<inertial><mass value=\"" + mass + "\"/><inertia ixx=\"" + ixx + "\" iyy=\"1\" izz=\"" +
         izz + "\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
}
std::string with_link(const std::string& content) {
  return robot("name=\"j\" type=\"fixed\"", "", content);
}

std::string nested(int depth) {
  std::string xml = "<robot name=\"r\">";
  for (int i = 0; i < depth; ++i) xml += "<gazebo>";
  for (int i = 0; i < depth; ++i) xml += "</gazebo>";
  return xml + "</robot>";
}

const std::vector<BadFile>& bad_files() {
  static const std::string cut = std::string(full).substr(0, 1200);
  static const std::vector<BadFile> files = {
      // Not XML, or not a robot.
      {"Empty", "", {"empty"}},
      {"Blank", " \n\t ", {"empty"}},
      {"NoXml", "solid ascii stl", {"line 1", "not well formed", "text"}},
      {"Binary",
       std::string("\x7f"
                   "ELF\0\0\1",
                   7),
       {"line 1", "not well formed"}},
      {"Truncated", cut, {"line ", "not well formed"}},
      {"TruncatedInATag", std::string(full).substr(0, 160), {"line ", "not well formed"}},
      {"Mismatched", "<robot name=\"r\">\n<link name=\"a\">\n</robot>", {"line ", "closed"}},
      {"Nested", nested(5000), {"nested too deeply"}},
      {"NotARobot", "<sdf><model/></sdf>", {"<sdf>", "<robot>"}},
      {"OnlyAComment", "<!-- nothing -->", {"outermost", "<robot>"}},
      {"Xacro",
       "<robot name=\"r\" xmlns:xacro=\"x\">\n<xacro:arm/><link name=\"a\"/></robot>",
       {"line 2", "xacro"}},
      // Not a tree.
      {"NoLinks", "<robot name=\"r\"/>", {"no links"}},
      {"LinkName", "<robot name=\"r\">\n\n<link/></robot>", {"line 3", "<link>", "no name"}},
      {"TwoLinks",
       robot("name=\"j\" type=\"fixed\"", "", "", "<link name=\"b\"/>"),
       {"link 'b'", "twice"}},
      {"TwoRoots",
       robot("name=\"j\" type=\"fixed\"", "", "", "<link name=\"c\"/>"),
       {"'a'", "'c'", "root"}},
      {"TwoParents",
       robot("name=\"j\" type=\"fixed\"", "", "",
             "<link name=\"c\"/><joint name=\"k\" type=\"fixed\"><parent link=\"a\"/>"
             "<child link=\"c\"/></joint><joint name=\"l\" type=\"fixed\"><parent link=\"c\"/>"
             "<child link=\"b\"/></joint>"),
       {"'b'", "two parents", "'a'", "'c'"}},
      {"Cyclic",
       robot("name=\"j\" type=\"fixed\"", "", "",
             "<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>"),
       {"ancestor"}},
      {"CyclicAside",
       robot("name=\"j\" type=\"fixed\"", "", "",
             "<link name=\"c\"/><link name=\"d\"/><joint name=\"k\" type=\"fixed\"><parent "
             "link=\"c\"/><child link=\"d\"/></joint><joint name=\"l\" type=\"fixed\"><parent "
             "link=\"d\"/><child link=\"c\"/></joint>"),
       {"ancestor"}},
      {"UnknownLink",
       robot("name=\"j\" type=\"fixed\"", "", "",
             "<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"handd\"/>"
             "</joint><link name=\"hand\"/>"),
       {"joint 'k'", "'handd'", "'hand'?"}},
      // Joints.
      {"JointName", robot("type=\"fixed\"", ""), {"line 1", "<joint>", "no name"}},
      {"TwoJoints",
       robot("name=\"j\" type=\"fixed\"", "", "",
             "<link name=\"c\"/><joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child "
             "link=\"c\"/></joint>"),
       {"joint 'j'", "twice"}},
      {"JointType", robot_of_type("revolut"), {"joint 'j'", "'revolut'", "'revolute'?"}},
      {"StrangeType", robot_of_type("screwdriver_joint"), {"'screwdriver_joint'", "wanted"}},
      {"NoType", robot("name=\"j\"", ""), {"joint 'j'", "'type'"}},
      {"NoParent",
       "<robot name=\"r\"><link name=\"a\"/><joint name=\"j\" type=\"fixed\"><child "
       "link=\"a\"/></joint></robot>",
       {"joint 'j'", "<parent>"}},
      {"EmptyChild",
       "<robot name=\"r\"><link name=\"a\"/><joint name=\"j\" type=\"fixed\"><parent "
       "link=\"a\"/><child/></joint></robot>",
       {"joint 'j'", "<child>", "'link'"}},
      {"OriginWord", robot_of_type("fixed", "<origin xyz=\"0 0 up\"/>"), {"'j'", "xyz", "'up'"}},
      {"OriginNan", robot_of_type("fixed", "<origin xyz=\"0 0 nan\"/>"), {"'j'", "nan", "finite"}},
      {"OriginInf", robot_of_type("fixed", "<origin rpy=\"0 inf 0\"/>"), {"'j'", "rpy", "finite"}},
      {"OriginHuge", robot_of_type("fixed", "<origin xyz=\"0 0 1e999\"/>"), {"'j'", "'1e999'"}},
      {"OriginComma", robot_of_type("fixed", "<origin xyz=\"0,1 0 0\"/>"), {"'j'", "'0,1'"}},
      {"OriginLines", robot_of_type("fixed", "<origin xyz=\"0\n0\nhere\"/>"), {"'j'", "'here'"}},
      {"OriginLong",
       robot_of_type("fixed", "<origin xyz=\"" + std::string(5000, '8') + "\"/>"),
       {"'j'", "888...'"}},
      {"OriginTwo", robot_of_type("fixed", "<origin xyz=\"0 0\"/>"), {"'j'", "3 numbers"}},
      {"OriginEmpty", robot_of_type("fixed", "<origin xyz=\"\"/>"), {"'j'", "3 numbers"}},
      {"OriginOther", robot_of_type("fixed", "<origin quat_xyzw=\"0 0 0 1\"/>"), {"quat_xyzw"}},
      {"Axis", robot_of_type("continuous", "<axis xyz=\"0 0 0\"/>"), {"joint 'j'", "axis", "zero"}},
      {"AxisEmpty", robot_of_type("continuous", "<axis/>"), {"joint 'j'", "<axis>", "'xyz'"}},
      {"LimitOrder",
       robot_of_type("revolute", "<limit lower=\"2\" upper=\"1\"/>"),
       {"'j'", "2", "above", "1"}},
      {"LimitNan",
       robot_of_type("revolute", "<limit lower=\"nan\" upper=\"1\"/>"),
       {"'j'", "lower", "nan"}},
      {"Effort",
       robot_of_type("revolute", "<limit upper=\"1\" effort=\"-5\"/>"),
       {"'j'", "effort", "-5"}},
      {"Damping",
       robot_of_type("continuous", "<dynamics damping=\"-1\"/>"),
       {"'j'", "damping", "-1"}},
      {"Armature",
       robot_of_type("continuous", "<dynamics armature=\"much\"/>"),
       {"'j'", "armature", "'much'"}},
      {"MimicLeader", robot_of_type("continuous", "<mimic/>"), {"'j'", "<mimic>", "'joint'"}},
      {"MimicNumber",
       robot_of_type("continuous", "<mimic joint=\"k\" offset=\"--1\"/>"),
       {"'j'", "offset", "'--1'"}},
      // Links.
      {"Mass", with_link(inertial("-1.2", "1", "1")), {"link 'b'", "-1.2", "negative"}},
      {"MassNan", with_link(inertial("nan", "1", "1")), {"link 'b'", "nan", "finite"}},
      {"MassOfXacro", with_link(inertial("${m}", "1", "1")), {"link 'b'", "'${m}'", "xacro first"}},
      {"MassUnit", with_link(inertial("1.2kg", "1", "1")), {"link 'b'", "'1.2kg'"}},
      {"InertiaSign", with_link(inertial("1", "-1", "1")), {"link 'b'", "-1", "negative"}},
      {"NoMass",
       with_link("<inertial><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
                 "iyz=\"0\"/></inertial>"),
       {"link 'b'", "<mass>"}},
      {"NoInertia",
       with_link("<inertial><mass value=\"1\"/></inertial>"),
       {"link 'b'", "<inertia>"}},
      {"NoIyz",
       with_link("<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" "
                 "ixz=\"0\"/></inertial>"),
       {"link 'b'", "'iyz'"}},
  };
  return files;
}

class InvalidUrdf : public ::testing::TestWithParam<BadFile> {};

TEST_P(InvalidUrdf, AnyDefect_IsRefusedByName) {
  std::vector<std::string> words = GetParam().words;
  words.push_back("bad.urdf: ");
  expect_words(refusal([&] { parse_urdf(GetParam().xml, "bad.urdf"); }), words);
}

INSTANTIATE_TEST_SUITE_P(Urdf, InvalidUrdf, ::testing::ValuesIn(bad_files()),
                         [](const auto& test) { return test.param.name; });

TEST(Urdf, SeveralProblems_AreListedWithTheirLines) {
  const std::string xml =
      "<robot name='r'>\n<link name='a'/>\n"
      "<link name='b'>\n<inertial>\n<origin xyz='0 0'/>\n<mass value='heavy'/>\n"
      "<inertia ixx='1' ixy='0' ixz='nan' iyy='1' iyz='0'/>\n</inertial>\n</link>\n"
      "<link name='c'><inertial><mass value='-3'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
      "izz='1'/></inertial></link>\n"
      "<joint name='j' type='revolut'><parent link='a'/><child link='b'/></joint>\n"
      "<joint name='k' type='revolute'><parent link='aa'/><child link='c'/>\n"
      "<axis xyz='0 0 0'/><limit lower='2' upper='1' effort='-4' velocity='x'/></joint>\n"
      "</robot>";
  const std::vector<std::string> expected = {
      "line 5: link 'b': <origin> has xyz",
      "line 6: link 'b': <mass> has value = 'heavy'",
      "line 7: link 'b': <inertia> has ixz = 'nan'",
      "line 7: link 'b': <inertia> has no 'izz'",
      "line 11: joint 'j': type 'revolut' is unknown",
      "line 13: joint 'k': <limit> has velocity = 'x'",
      "line 12: joint 'k': parent link 'aa' does not exist; did you mean 'a'?",
      "line 10: link 'c': mass -3",
      "line 12: joint 'k': its axis is zero",
      "line 12: joint 'k': its lower limit 2 is above its upper limit 1",
      "line 12: joint 'k': effort limit is -4"};
  try {
    parse_urdf(xml, "r.urdf");
    ADD_FAILURE() << "the file was accepted";
  } catch (const Error& error) {
    ASSERT_EQ(error.sentences().size(), expected.size()) << error.what();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(error.sentences()[i].rfind("r.urdf: " + expected[i], 0), 0u)
          << error.sentences()[i];
    }
    expect_words(error.what(), {"r.urdf: 11 problems: (1) line 5: ", " (11) line 12: "});
  }
}

TEST(Urdf, ConsequencesOfAProblem_AreNotListed) {
  // A link without a name may be 'b', so a missing link 'b' is not reported.
  const std::string sentence = refusal([&] {
    parse_urdf(
        "<robot name='r'><link name='a'/><link/><joint name='j' type='fixed'>"
        "<parent link='a'/><child link='b'/></joint></robot>");
  });
  EXPECT_EQ(sentence, "<string>: line 1: <link> has no name; the attribute 'name' is needed");
}

TEST(Urdf, AnyTruncation_IsRefused) {
  const std::string xml = full;
  for (std::size_t size = 0; size + 8 < xml.size(); size += 7) {
    EXPECT_NE(refusal([&] { parse_urdf(xml.substr(0, size)); }), "") << size;
  }
}

TEST(Urdf, MillionLinks_AreRefusedWithinASecond) {
  std::string xml = "<robot name=\"r\">";
  xml.reserve(120u << 20);
  for (int i = 0; i < 1000000; ++i) {
    const std::string n = std::to_string(i);
    xml += "<link name=\"l" + n + "\"/>";
    if (i == 0) continue;
    xml += "<joint name=\"j" + n + "\" type=\"fixed\"><parent link=\"l" + std::to_string(i - 1) +
           "\"/><child link=\"l" + n + "\"/></joint>";
  }
  xml += "</robot>";
  const auto start = std::chrono::steady_clock::now();
  expect_words(refusal([&] { parse_urdf(xml, "long.urdf"); }), {"long.urdf", "2000 links"});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 1.0);
}

std::string chain(int links) {
  std::string xml = "<robot name=\"r\"><link name=\"l0\"/>";
  for (int i = 1; i < links; ++i) {
    const std::string n = std::to_string(i);
    xml += "<link name=\"l" + n + "\"/><joint name=\"j" + n + "\" type=\"fixed\"><parent link=\"l" +
           std::to_string(i - 1) + "\"/><child link=\"l" + n + "\"/></joint>";
  }
  return xml + "</robot>";
}

TEST(Urdf, DeepestAllowedChain_IsRead) {
  EXPECT_EQ(parse_urdf(chain(500)).links.size(), 500u);
  expect_words(refusal([&] { parse_urdf(chain(501)); }), {"501", "500"});
  expect_words(refusal([&] { parse_urdf(chain(2000)); }), {"500"});
}

TEST(Urdf, LinksInComments_AreNotCounted) {
  std::string comment = "<!--";
  for (int i = 0; i < 3000; ++i) comment += "<link name=\"x\"/>";
  const std::string xml = "<robot name=\"r\">" + comment + "--><link name=\"a\"/></robot>";
  EXPECT_EQ(parse_urdf(xml).links.size(), 1u);
}

TEST(Urdf, File_IsReadAndAMissingFileIsRefused) {
  const Scratch scratch;
  const std::filesystem::path file = scratch.write("arm.urdf", full);
  EXPECT_EQ(read_urdf(file).source, file.string());
  std::filesystem::remove(file);
  expect_words(refusal([&] { read_urdf(file); }), {file.string(), "cannot be opened"});
  expect_words(refusal([&] { read_urdf(scratch.folder); }), {"folder"});
}

}  // namespace
}  // namespace burnish::testing

// Tests of <attach> and <replicate>: each model equals the same model written out, in burnish and
// in MuJoCo 2.2.2, which reads neither element.
#include <gtest/gtest.h>

#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/model.hpp"
#include "mjcf/comparison.hpp"
#include "mjcf/tied_comparison.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

/// Returns a tree as text with twelve digits, for comparison.
std::string text_of(const TreeSpec& tree) {
  std::string text;
  char number[40];
  const auto add = [&](const std::string& word) { text += word + " "; };
  const auto add_number = [&](double value) {
    std::snprintf(number, sizeof number, "%.12g ", std::abs(value) < 1e-13 ? 0.0 : value);
    text += number;
  };
  const auto add_placement = [&](const Eigen::Isometry3d& at) {
    for (int i = 0; i < 12; ++i) add_number(at.matrix()(i % 3, i / 3));
  };
  for (const LinkSpec& link : tree.links) {
    add("link " + link.name), add_number(link.inertia.mass);
    for (const double value : link.inertia.com) add_number(value);
    for (const VisualSpec& visual : link.visuals)
      for (const double value : visual.rgba) add_number(value);
    text += "\n";
  }
  for (const JointSpec& joint : tree.joints) {
    add("joint " + joint.name + " " + joint.parent_link + " " + joint.child_link);
    for (const double value : {joint.lower, joint.upper, joint.effort_limit, joint.damping})
      add_number(value);
    add_placement(joint.placement);
    if (joint.mimic) add(joint.mimic->leader), add_number(joint.mimic->multiplier);
    text += "\n";
  }
  for (const LoopSpec& loop : tree.loops) {
    add("loop " + loop.first_link + " " + loop.second_link);
    add_placement(loop.first), add_placement(loop.second);
    text += "\n";
  }
  for (const TendonSpec& tendon : tree.tendons) {
    add("tendon " + tendon.name), add_number(tendon.stiffness);
    for (const TendonSpec::Part& part : tendon.parts) add(part.joint), add_number(part.coefficient);
    text += "\n";
  }
  for (const FrameSpec& frame : tree.frames)
    add("frame " + frame.name + " " + frame.parent), add_placement(frame.placement);
  return text;
}

void expect_same(const TreeSpec& tree, const std::string& by_hand) {
  const TreeSpec same = parse_mjcf(by_hand, "m.xml");
  EXPECT_EQ(text_of(tree), text_of(same));
  const auto theirs = mujoco::compile(by_hand);
  EXPECT_LE(compare(tree, *theirs, 20).worst(), 1e-10);
  EXPECT_LE(compare_tied(tree, *theirs, 10).worst(), 1e-9);
}

std::string model(const std::string& inside) { return "<mujoco>" + inside + "</mujoco>"; }
const std::string swung_mass =
    "<inertial pos='0.1 0 0.05' mass='1.5' diaginertia='0.03 0.025 0.02'/>";

std::string swing(const std::string& attributes, const std::string& suffix) {
  return "<body name='b" + suffix + "' " + attributes + "><joint name='j" + suffix +
         "' axis='0 1 0'/>" + swung_mass + "<site name='s" + suffix + "' pos='0 0 0.1'/></body>";
}

TEST(MjcfReplicate, OffsetAndRotation_AddUpFromCopyToCopy) {
  // Each step also rotates the next offset: the copies form a square.
  expect_same(parse_mjcf(model("<worldbody><replicate count='4' offset='1 0 0' euler='0 0 90'>" +
                               swing("pos='0 0.1 0'", "") + "</replicate></worldbody>"),
                         "m.xml"),
              model("<worldbody>" + swing("pos='0 0.1 0'", "0") +
                    swing("pos='0.9 0 0' euler='0 0 90'", "1") +
                    swing("pos='1 0.9 0' euler='0 0 180'", "2") +
                    swing("pos='0.1 1 0' euler='0 0 270'", "3") + "</worldbody>"));
}

TEST(MjcfReplicate, Names_HaveTheDigitsOfTheCount) {
  const TreeSpec tree =
      parse_mjcf(model("<worldbody><replicate count='10' offset='0 0 1' sep='-'>" + swing("", "") +
                       "</replicate></worldbody>"));
  ASSERT_EQ(tree.links.size(), 11u);
  EXPECT_EQ(tree.links[1].name, "b-00");
  EXPECT_EQ(tree.links[10].name, "b-09");
  EXPECT_EQ(tree.frames[3].name, "s-03");
  EXPECT_EQ(tree.links[5].line, 1);
}

TEST(MjcfReplicate, NestedCopies_HaveTheInnerNumberFirst) {
  const TreeSpec tree = parse_mjcf(
      model("<worldbody><replicate count='2' offset='0 1 0'><frame pos='0 0 0.5'><replicate "
            "count='2' offset='1 0 0' sep='_'>" +
            swing("", "") + "</replicate></frame></replicate></worldbody>"),
      "m.xml");
  expect_same(
      tree, model("<worldbody>" + swing("pos='0 0 0.5'", "_00") + swing("pos='1 0 0.5'", "_10") +
                  swing("pos='0 1 0.5'", "_01") + swing("pos='1 1 0.5'", "_11") + "</worldbody>"));
}

TEST(MjcfReplicate, ReferencesToCopiedElements_AreCopied) {
  const auto two = [](const std::string& suffix, const std::string& pos) {
    return swing("pos='" + pos + "'", suffix) + "<body name='c" + suffix + "' pos='" + pos +
           "'><joint name='k" + suffix + "' axis='1 0 0'/>" + swung_mass + "</body>";
  };
  const auto coupling = [](const std::string& s) {
    return "<joint joint1='k" + s + "' joint2='j" + s + "' polycoef='0.1 2 0 0 0'/>";
  };
  const auto tendon = [](const std::string& s) {
    return "<fixed name='t" + s + "' stiffness='3'><joint joint='j" + s +
           "' coef='2'/><joint joint='free' coef='1'/></fixed>";
  };
  const auto motor = [](const std::string& s) {
    return "<motor joint='j" + s + "' ctrlrange='-3 3' ctrllimited='true'/>";
  };
  const std::string still = "<body name='still'><joint name='free'/>" + swung_mass + "</body>";
  const TreeSpec tree = parse_mjcf(
      model("<worldbody>" + still + "<replicate count='2' offset='0 1 0'>" + two("", "0 0 0.2") +
            "</replicate></worldbody><tendon>" + tendon("") + "</tendon><equality>" + coupling("") +
            "<weld body1='b' body2='still'/></equality><actuator>" + motor("") + "</actuator>"),
      "m.xml");
  expect_same(tree, model("<worldbody>" + still + two("0", "0 0 0.2") + two("1", "0 1 0.2") +
                          "</worldbody><tendon>" + tendon("0") + tendon("1") +
                          "</tendon><equality>" + coupling("0") + coupling("1") +
                          "</equality><actuator>" + motor("0") + motor("1") + "</actuator>"));
  ASSERT_EQ(tree.warnings.size(), 1u);  // the weld is lost with its replicated body, as in MuJoCo
  expect_words(tree.warnings[0], {"both to replicated and to other elements", "<weld>"});
}

/// A model with its own units, defaults, mesh, equalities and actuators.
const std::string arm_text =
    "<mujoco model='arm'><compiler angle='radian' meshdir='parts'/><default><joint damping='0.3' "
    "axis='0 1 0'/><default class='wrist'><joint range='-0.5 0.5'/><geom rgba='1 0 0 "
    "1'/></default></default><asset><mesh file='tip.obj'/><material name='red' rgba='1 0 0 "
    "0.5'/></asset><worldbody><light/><body name='base' pos='0 0 0.1'><joint name='turn'/><geom "
    "size='0.1' material='red'/>" +
    swung_mass +
    "<body name='hand' pos='0 0 0.4' euler='0 0.2 0' childclass='wrist'><joint name='flex'/>"
    "<geom type='mesh' mesh='tip' mass='0.5'/><body "
    "name='finger' pos='0 0 0.2'><joint name='grip' type='slide'/>" +
    swung_mass + "</body></body></body><body name='other'><joint name='lone'/>" + swung_mass +
    "</body></worldbody><equality><joint joint1='grip' joint2='flex' polycoef='0 0.5 0 0 0'/>"
    "<joint joint1='lone' joint2='turn'/></equality><actuator><motor joint='turn' "
    "ctrlrange='-4 4'/><motor joint='lone'/></actuator></mujoco>";
const std::string tip_mesh =
    "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

class MjcfAttach : public ::testing::Test {
 protected:
  MjcfAttach() {
    scratch.write("arms/arm.xml", arm_text);
    scratch.write("arms/parts/tip.obj", tip_mesh);
  }
  TreeSpec read(const std::string& inside) const {
    return read_mjcf(scratch.write("main.xml", "<mujoco model='m'>" + inside + "</mujoco>"));
  }
  std::string refused(const std::string& inside) const {
    return refusal([&] { read(inside); });
  }
  Scratch scratch;
};
const std::string with_arm = "<asset><model name='a' file='arms/arm.xml'/></asset>";

TEST_F(MjcfAttach, BodyOfAnotherModel_IsReadUnderItsPrefix) {
  const TreeSpec tree =
      read("<compiler angle='degree'/><default><joint damping='7'/></default>" + with_arm +
           "<worldbody><body name='post' pos='1 0 0' euler='0 0 90'><joint name='swivel'/>" +
           swung_mass +
           "<frame pos='0 0 0.3'><attach model='a' body='base' prefix='left_'/></frame></body>"
           "</worldbody>");
  ASSERT_EQ(tree.links.size(), 5u);
  // Written out in radians; each model keeps its own default damping.
  const TreeSpec same = read_mjcf(scratch.write(
      "hand.xml",
      "<mujoco model='m'><compiler angle='radian' meshdir='arms/parts'/><asset><mesh "
      "file='tip.obj'/></asset><worldbody><body name='post' pos='1 0 0' "
      "euler='0 0 1.5707963267948966'><joint name='swivel' damping='7'/>" +
          swung_mass +
          "<body name='left_base' pos='0 0 0.4'><joint name='left_turn' axis='0 1 0' "
          "damping='0.3'/><geom size='0.1' rgba='1 0 0 0.5'/>" +
          swung_mass +
          "<body name='left_hand' pos='0 0 0.4' euler='0 0.2 0'><joint name='left_flex' axis='0 1 "
          "0' damping='0.3' range='-0.5 0.5'/><geom type='mesh' mesh='tip' mass='0.5' rgba='1 0 0 "
          "1'/><body name='left_finger' pos='0 0 0.2'><joint "
          "name='left_grip' type='slide' axis='0 1 0' damping='0.3' range='-0.5 0.5'/>" +
          swung_mass +
          "</body></body></body></body></worldbody><equality><joint joint1='left_grip' "
          "joint2='left_flex' polycoef='0 0.5 0 0 0'/></equality><actuator><motor "
          "joint='left_turn' ctrlrange='-4 4'/></actuator></mujoco>"));
  EXPECT_EQ(text_of(tree), text_of(same));
  EXPECT_TRUE(tree.warnings.empty());
}

TEST_F(MjcfAttach, WholeModelAndReplicatedBody_AreRead) {
  const TreeSpec tree =
      read(with_arm +
           "<worldbody><attach model='a' prefix='x_'/><replicate count='2' offset='0 2 0'>"
           "<attach model='a' body='hand' prefix='y_'/></replicate></worldbody>");
  const Model model = build_model(tree);
  EXPECT_EQ(model.nv, 2 + 2);  // 'grip' and 'lone' are followers
  for (const char* joint : {"x_turn", "x_flex", "x_grip", "x_lone", "y_flex0", "y_grip1"})
    EXPECT_NO_THROW(model.joint_index(joint)) << joint;
  EXPECT_EQ(model.joints[static_cast<std::size_t>(model.joint_index("y_flex1"))]
                .placement.translation()
                .y(),
            2.0);
}

TEST_F(MjcfAttach, BodyOfTheSameModel_IsCopiedWithItsActuator) {
  expect_same(
      parse_mjcf(model("<worldbody>" + swing("", "") +
                       "<frame pos='0 1 0'><attach body='b' prefix='again_'/></frame>"
                       "</worldbody><actuator><motor joint='j' ctrlrange='-2 2' "
                       "ctrllimited='true'/></actuator>"),
                 "m.xml"),
      model("<worldbody>" + swing("", "") +
            "<body name='again_b' pos='0 1 0'><joint name='again_j' axis='0 1 0'/>" + swung_mass +
            "<site name='again_s' pos='0 0 0.1'/></body></worldbody><actuator><motor "
            "joint='j' ctrlrange='-2 2' ctrllimited='true'/><motor joint='again_j' "
            "ctrlrange='-2 2' ctrllimited='true'/></actuator>"));
}

TEST_F(MjcfAttach, BadAttachOrReplicate_IsRefused) {
  const auto in_world = [](const std::string& inside) {
    return with_arm + "<worldbody>" + swing("", "") + inside + "</worldbody>";
  };
  expect_words(refused(in_world("<attach model='b' body='base' prefix='x_'/>")),
               {"line 1", "<model> 'b'", "'a'"});
  expect_words(refused(in_world("<attach model='a' body='bose' prefix='x_'/>")),
               {"body 'bose'", "did you mean 'base'"});
  expect_words(refused(in_world("<attach model='a' body='base'/>")), {"'prefix'"});
  expect_words(refused(in_world("<attach prefix='x_'/>")), {"neither another model nor a body"});
  expect_words(refused("<worldbody><body name='b'>" + swung_mass +
                       "<attach body='b' prefix='x_'/></body></worldbody>"),
               {"attaches an element that contains it"});
  for (const char* count : {"1.5", "-1", "1e9"})
    expect_words(refused(in_world("<replicate count='" + std::string(count) + "'/>")),
                 {"count", count, "whole number"});
  std::string many = swing("", "");
  for (int i = 0; i < 3; ++i) many = "<replicate count='100'>" + many + "</replicate>";
  expect_words(refused("<worldbody>" + many + "</worldbody>"), {"copies more than 50000 elements"});
  std::string deep = swing("", "");
  for (int i = 0; i < 25; ++i) deep = "<replicate count='1'>" + deep + "</replicate>";
  expect_words(refused("<worldbody>" + deep + "</worldbody>"), {"20", "deep"});
  scratch.write("self.xml",
                "<mujoco><asset><model name='s' file='self.xml'/></asset><worldbody>"
                "<attach model='s' prefix='x'/></worldbody></mujoco>");
  expect_words(refusal([&] { read_mjcf(scratch.folder / "self.xml"); }), {"includes itself"});
}

}  // namespace
}  // namespace burnish::testing

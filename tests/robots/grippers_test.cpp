// Tests of the recognition of gripper fingers in descriptions, and of their locking at loading.
#include "robots/grippers.hpp"

#include <gtest/gtest.h>

#include "burnish/robots/robot.hpp"
#include "burnish/urdf/urdf.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "support/six_joint_arm.hpp"

namespace burnish::testing {
namespace {

using FingerNames = std::set<std::string>;

std::string turning(const std::string& name, const std::string& parent, const std::string& child,
                    const std::string& xyz) {
  return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" +
         child + "'/><origin xyz='" + xyz +
         "'/><axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint><link "
         "name='" +
         child + "'/>\n";
}

FingerNames fingers_of(const std::string& beyond_l6) {
  return finger_joints(parse_urdf(six_joint_arm({.beyond = beyond_l6}), "arm.urdf"));
}

TEST(GripperFingers, BranchesAtTheEndOfAnArm_AreFingers) {
  EXPECT_EQ(fingers_of(with_gripper().beyond), (FingerNames{"left", "right"}));
  EXPECT_EQ(finger_joints(read_urdf(BURNISH_ROBOTS_DIR "/crane/crane.urdf")),
            (FingerNames{"left_finger_a_joint", "left_finger_b_joint"}));
  // Two fingers of two joints each, without telling names, on a hand fixed to the last link.
  EXPECT_EQ(
      fingers_of("<link name='palm'/><joint name='p' type='fixed'><parent link='l6'/><child "
                 "link='palm'/></joint>" +
                 turning("a1", "palm", "a", "0 0.02 0.1") + turning("a2", "a", "aa", "0 0 0.04") +
                 turning("b1", "palm", "b", "0 -0.02 0.1") + turning("b2", "b", "bb", "0 0 0.04")),
      (FingerNames{"a1", "a2", "b1", "b2"}));
}

TEST(GripperFingers, SingleBranch_IsAFingerByItsName) {
  EXPECT_EQ(fingers_of(turning("j7", "l6", "moving_jaw", "0 0 0.05")), FingerNames{"j7"});
  EXPECT_EQ(fingers_of(turning("jointGripper", "l6", "mover", "0 0 0.05")),
            FingerNames{"jointGripper"});
  // A wrist joint that rolls a gripper is not a finger, nor is a seventh joint.
  EXPECT_EQ(fingers_of(turning("gripper_roll", "l6", "gripper", "0 0 0.05")), FingerNames{});
  EXPECT_EQ(fingers_of(turning("j7", "l6", "hand", "0 0 0.05")), FingerNames{});
}

TEST(GripperFingers, RotorBesideItsLink_IsNotAFinger) {
  const std::string elbow = turning("elbow", "l6", "forearm", "0 0 0.1");
  EXPECT_EQ(fingers_of(elbow + turning("spin", "l6", "elbow_rotor", "0 0 0.05")), FingerNames{});
  // Without a telling name, the rotor is the branch without mass.
  std::string heavy = elbow;
  heavy.replace(heavy.find("<link name='forearm'/>"), std::string("<link name='forearm'/>").size(),
                "<link name='forearm'><inertial><mass value='0.3'/><inertia ixx='1e-3' ixy='0' "
                "ixz='0' iyy='1e-3' iyz='0' izz='1e-3'/></inertial></link>");
  EXPECT_EQ(fingers_of(heavy + turning("spin", "l6", "disc", "0 0 0.05")), FingerNames{});
  EXPECT_EQ(fingers_of(elbow + turning("spin", "l6", "disc", "0 0 0.05")),
            (FingerNames{"elbow", "spin"}));
}

TEST(GripperFingers, TwoArms_AreNotFingers) {
  // A torso of two joints has two arms of three joints.
  std::string arms;
  for (const std::string side : {"a", "b"})
    arms += turning(side + "1", "t2", side + "x", "0 0.2 0.3") +
            turning(side + "2", side + "x", side + "y", "0.3 0 0") +
            turning(side + "3", side + "y", side + "z", "0.3 0 0");
  EXPECT_EQ(finger_joints(parse_urdf("<robot name='r'><link name='base'/>" +
                                         turning("w1", "base", "t1", "0 0 0.2") +
                                         turning("w2", "t1", "t2", "0 0 0.2") + arms + "</robot>",
                                     "r.urdf")),
            FingerNames{});
  for (const char* robot : {"arm7/arm7", "talos/talos", "quadruped/quadruped"})
    EXPECT_EQ(finger_joints(read_urdf(std::string(BURNISH_ROBOTS_DIR) + "/" + robot + ".urdf")),
              FingerNames{})
        << robot;
}

TEST(GripperFingers, FollowerOfAnArmJoint_IsNotAFinger) {
  EXPECT_EQ(
      fingers_of(finger("left", "l6", 0.03, "<mimic joint='j2'/>") + finger("right", "l6", -0.03)),
      FingerNames{"right"});
}

TEST(GripperFingers, FingerAsTheTool_IsLockedWithANote) {
  const Scratch scratch;
  const std::string file = scratch.write("arm.urdf", six_joint_arm(with_gripper())).string();
  const auto carrying = [&](const std::string& tool) {
    RobotOverrides overrides;
    overrides.carrying = tool;
    return load_robot(file, overrides);
  };
  const Robot by_tcp = carrying("tcp");
  EXPECT_EQ(by_tcp.model.nv, 6);
  EXPECT_TRUE(by_tcp.notes.empty());
  const Robot by_finger = carrying("right_link");
  EXPECT_EQ(by_finger.model.nv, 6);
  ASSERT_EQ(by_finger.notes.size(), 1U);
  expect_words(by_finger.notes[0], {"joint 'left' is treated as a finger", "'right_link'"});
  EXPECT_EQ(load_robot(file).model.nv, 7);
}

}  // namespace
}  // namespace burnish::testing

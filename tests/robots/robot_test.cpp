// Tests of loading robots: names, settings, variants, overrides, and errors in settings.
#include "burnish/robots/robot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "robots/robot_settings.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

const char* const arm_urdf = R"(<robot name="arm">
  <link name="base"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="upper"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="lower"><inertial><mass value="1"/>
    <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="slide" type="prismatic"><parent link="upper"/><child link="lower"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>)";

const char* const arm_settings = R"(# an arm
urdf: arm.urdf
description: a small arm
base: fixed
base_placement: {xyz: [0, 0, 2], rpy: [0, 0, 1.5707963267948966]}
default_posture: out
postures:
  out: {shoulder: 0.5, slide: 0.25}
  up: {root_joint: [1, 2, 3, 0, 0, 0, 1], shoulder: [0], slide: 1}
frames:
  tool: {parent: lower, xyz: [0, 0, 1]}
  tip: {parent: tool, xyz: [0, 0, 0.5], rpy: [0, 0, 0]}
variants:
  hinge:
    description: the shoulder alone
    free: [shoulder]
    posture: up
    default_posture: back
    postures:
      back: {shoulder: -1}
      up: {slide: 0.75}
    frames:
      tool: {parent: lower, xyz: [0, 0, 3]}
      elbow: {parent: upper}
  locked:
    lock: [slide]
  adrift: {base: free_flyer}
)";

/// A folder of robots that BURNISH_ROBOTS names.
class RobotFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    write("smallarm/arm.urdf", arm_urdf);
    write("smallarm/robot.yaml", arm_settings);
    ::setenv("BURNISH_ROBOTS", scratch_.folder.c_str(), 1);
  }
  void TearDown() override { ::unsetenv("BURNISH_ROBOTS"); }
  void write(const std::string& name, const std::string& text) const { scratch_.write(name, text); }
  std::string path(const std::string& name) const { return (scratch_.folder / name).string(); }
  Scratch scratch_;
};

double height(const Robot& robot, const std::string& frame) {
  return frame_placement(robot.model, robot.reference_configuration(), frame).translation().z();
}

TEST_F(RobotFolder, NameOrPath_FindsTheRobot) {
  for (const std::string& name :
       {std::string("smallarm"), path("smallarm"), path("smallarm/robot.yaml")}) {
    EXPECT_EQ(load_robot(name).model.nv, 2) << name;
    EXPECT_EQ(load_robot(name + ":hinge").model.nv, 1) << name;
  }
  const Robot plain = load_robot(path("smallarm/arm.urdf"));
  EXPECT_EQ(plain.model.nv, 2);
  EXPECT_TRUE(plain.postures.empty());
  EXPECT_EQ(plain.reference_configuration(), plain.model.q_neutral);
}

TEST_F(RobotFolder, PathWithColons_IsRead) {
  fs::create_directories(scratch_.folder / "a:b");
  fs::copy(scratch_.folder / "smallarm", scratch_.folder / "a:b");
  EXPECT_EQ(load_robot(path("a:b")).model.nv, 2);
  EXPECT_EQ(load_robot(path("a:b:hinge")).model.nv, 1);
}

TEST_F(RobotFolder, Settings_GivePosturesFramesAndBasePlacement) {
  const Robot robot = load_robot("smallarm");
  EXPECT_EQ(robot.default_posture, "out");
  EXPECT_EQ(robot.postures.size(), 2u);
  const Eigen::VectorXd q = robot.reference_configuration();
  EXPECT_EQ(q[0], std::cos(0.5));
  EXPECT_EQ(q[2], 0.25);
  EXPECT_EQ(robot.posture("up")[2], 1.0);
  EXPECT_DOUBLE_EQ(height(robot, "tip"), 2.0 + 0.25 + 1.0 + 0.5);
  const Eigen::Isometry3d base = frame_placement(robot.model, q, "base");
  EXPECT_TRUE(base.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-14));
}

TEST_F(RobotFolder, Variant_ReplacesAndAddsSettings) {
  const Robot robot = load_robot("smallarm:hinge");
  EXPECT_EQ(robot.default_posture, "back");
  EXPECT_EQ(robot.reference_configuration()[0], std::cos(-1.0));
  // Locked at the variant's posture "up". Its tool replaces the file's tool; the file's tip stays.
  EXPECT_DOUBLE_EQ(height(robot, "lower"), 2.75);
  EXPECT_DOUBLE_EQ(height(robot, "tip"), 2.75 + 3.5);
  EXPECT_TRUE(robot.model.has_frame("elbow"));
  EXPECT_EQ(robot.postures.size(), 3u);
  // A variant without a posture locks its joints at the default posture.
  EXPECT_DOUBLE_EQ(height(load_robot("smallarm:locked"), "lower"), 2.25);
  const Robot adrift = load_robot("smallarm:adrift");
  EXPECT_EQ(adrift.model.nv, 8);
  EXPECT_DOUBLE_EQ(adrift.model.q_neutral[2], 2.0);
  EXPECT_EQ(adrift.posture("up").head<3>(), Eigen::Vector3d(1, 2, 3));
}

TEST_F(RobotFolder, Overrides_ReplaceSettingsAndVariant) {
  RobotOverrides overrides;
  overrides.base = Base::FreeFlyer;
  EXPECT_EQ(load_robot("smallarm:hinge", overrides).model.nv, 7);
  overrides = {};
  overrides.locked = {"shoulder"};
  EXPECT_EQ(load_robot("smallarm", overrides).model.nv, 1);
  EXPECT_EQ(load_robot("smallarm:locked", overrides).model.nv, 0);
  expect_words(refusal([&] { load_robot("smallarm:hinge", overrides); }), {"at least one free"});
  overrides = {};
  overrides.free = {"slide"};
  EXPECT_EQ(load_robot("smallarm:hinge", overrides).model.joints[0].name, "slide");
  EXPECT_EQ(load_robot("smallarm:locked", overrides).model.joints[0].name, "slide");
  overrides = {};
  overrides.posture = "up";
  EXPECT_DOUBLE_EQ(height(load_robot("smallarm:locked", overrides), "lower"), 3.0);
  overrides.posture = "upp";
  expect_words(refusal([&] { load_robot("smallarm", overrides); }), {"'upp'", "'up'?"});
  expect_words(refusal([&] { load_robot(path("smallarm/arm.urdf"), overrides); }), {"'upp'"});
}

TEST_F(RobotFolder, UnknownNames_AreRefusedWithTheNearestName) {
  const auto sentence = [](const std::string& name) { return refusal([&] { load_robot(name); }); };
  expect_words(sentence("smallarn"), {"'smallarn'", "'smallarm'?"});
  expect_words(sentence("q"), {"'q'", "available robots", "smallarm"});
  expect_words(sentence(""), {"''"});
  expect_words(sentence("smallarm:hing"), {"robot.yaml", "'hing'", "'hinge'?"});
  expect_words(sentence("smallarm:"), {"smallarm:", "variant"});
  expect_words(sentence(path("nothing.urdf")), {"nothing.urdf", "does not exist"});
  expect_words(sentence(path("nothing.yaml:x")), {"nothing.yaml", "does not exist"});
  expect_words(sentence(scratch_.folder.string() + "/"), {"robot.yaml"});
  expect_words(sentence(path("smallarm/arm.urdf:hinge")), {"arm.urdf", "variant"});
  const Robot robot = load_robot("smallarm");
  expect_words(refusal([&] { robot.posture("uut"); }), {"'arm'", "'uut'", "'out'?"});
}

TEST_F(RobotFolder, SearchPath_StartsWithTheEnvironmentVariable) {
  ::setenv("BURNISH_ROBOTS", ("/nowhere::" + scratch_.folder.string()).c_str(), 1);
  const std::vector<fs::path> folders = robot_search_path();
  ASSERT_EQ(folders.size(), 4u);
  EXPECT_EQ(folders[0], "/nowhere");
  EXPECT_EQ(folders[1], scratch_.folder);
  EXPECT_EQ(load_robot("smallarm").model.nv, 2);
}

TEST_F(RobotFolder, LocalFolder_DoesNotHideALibraryRobot) {
  fs::create_directories(scratch_.folder / "here" / "smallarm");
  fs::create_directories(scratch_.folder / "here" / "ownarm");
  for (const char* name : {"here/smallarm/", "here/ownarm/"}) {
    write(name + std::string("arm.urdf"), arm_urdf);
    write(name + std::string("robot.yaml"), "urdf: arm.urdf\nlock: [slide]\n");
  }
  const fs::path before = fs::current_path();
  fs::current_path(scratch_.folder / "here");
  EXPECT_EQ(load_robot("smallarm").model.nv, 2);
  EXPECT_EQ(load_robot("./smallarm").model.nv, 1);
  EXPECT_EQ(load_robot("ownarm").model.nv, 1) << "no other robot has that name";
  fs::current_path(before);
}

struct BadSettings {
  std::string name;
  std::string yaml;
  std::vector<std::string> words;
};

const std::vector<BadSettings>& bad_settings() {
  static const std::string u = "urdf: arm.urdf\n";
  static const std::vector<BadSettings> all = {
      {"Empty", "", {"urdf"}},
      {"List", "- urdf", {"line 1", "keys"}},
      {"NoYaml", u + "base: [fixed", {"line ", "not valid YAML"}},
      {"NoUrdf", "base: fixed", {"'urdf'", "missing"}},
      {"MissingUrdf", "urdf: amr.urdf", {"amr.urdf", "cannot be opened"}},
      {"UrdfType", "urdf: [arm.urdf]", {"line 1", "urdf", "text"}},
      {"Key", u + "bsae: fixed", {"line 2", "'bsae'", "'base'?"}},
      {"StrangeKey", u + "colour_of_paint: red", {"line 2", "'colour_of_paint'", "known are"}},
      {"KeyTwice", u + "base: fixed\nbase: fixed", {"'base'", "twice"}},
      {"Base", u + "base: free", {"line 2", "'free'", "free_flyer"}},
      {"Placement", u + "base_placement: [0, 0, 1]", {"line 2", "base_placement", "keys"}},
      {"PlacementKey",
       u + "base_placement: {xzy: [0, 0, 1]}",
       {"line 2", "base_placement", "'xzy'", "'xyz'?"}},
      {"PlacementSize",
       u + "base_placement: {xyz: [0, 1]}",
       {"base_placement.xyz", "2 numbers; wanted 3"}},
      {"PlacementWord",
       u + "base_placement: {rpy: [0, 0, up]}",
       {"base_placement.rpy", "'up'", "number"}},
      {"PlacementNan", u + "base_placement: {rpy: [0, 0, nan]}", {"base_placement.rpy", "nan"}},
      {"Lock", u + "lock: {shoulder: 1}", {"line 2", "lock", "list"}},
      {"LockName", u + "lock: [shoulders]", {"arm.urdf", "'shoulders'", "'shoulder'?"}},
      {"FreeEmpty", u + "free: []", {"free", "at least one"}},
      {"LockAndFree", u + "lock: [slide]\nfree: [shoulder]", {"'lock'", "'free'", "both"}},
      {"Posture",
       u + "posture: outt\npostures: {out: {slide: 0}}",
       {"'posture'", "'outt'", "'out'?"}},
      {"DefaultPosture",
       u + "default_posture: outt\npostures: {out: {slide: 0}}",
       {"'default_posture'", "'outt'", "'out'?"}},
      {"PostureValue", u + "postures: {out: {slide: far}}", {"postures.out.slide", "'far'"}},
      {"PostureMap", u + "postures: {out: {slide: {x: 1}}}", {"postures.out.slide", "number"}},
      {"PostureInf", u + "postures: {out: {slide: [inf]}}", {"postures.out.slide", "inf"}},
      {"PostureJoint",
       u + "postures: {out: {slyde: 0}}",
       {"robot.yaml", "'out'", "'slyde'", "'slide'?"}},
      {"PostureSize", u + "postures: {out: {slide: [0, 1]}}", {"'out'", "'slide'", "wanted 1"}},
      {"PostureBase",
       u + "base: free_flyer\npostures: {out: {root_joint: [0, 0, 1]}}",
       {"'out'", "'root_joint'", "wanted 7"}},
      {"FrameParent", u + "frames: {tool: {xyz: [0, 0, 0]}}", {"frames.tool", "'parent'"}},
      {"FrameParentName", u + "frames: {tool: {parent: lowerr}}", {"'tool'", "'lower'?"}},
      {"FrameKey", u + "frames: {tool: {parnt: lower}}", {"frames.tool", "'parnt'", "'parent'?"}},
      {"Variant", u + "variants: {a: fixed}", {"line 2", "variants.a", "keys"}},
      {"VariantKey",
       u + "variants:\n  a:\n    fre: [slide]",
       {"line 4", "variants.a", "'fre'", "'free'?"}},
      {"VariantInVariant", u + "variants: {a: {variants: {}}}", {"variants.a", "'variants'"}},
  };
  return all;
}

class BadRobotSettings : public RobotFolder, public ::testing::WithParamInterface<BadSettings> {};

TEST_P(BadRobotSettings, Loading_IsRefusedWithTheKey) {
  write("smallarm/robot.yaml", GetParam().yaml);
  expect_words(refusal([&] { load_robot("smallarm"); }), GetParam().words);
}

INSTANTIATE_TEST_SUITE_P(Robot, BadRobotSettings, ::testing::ValuesIn(bad_settings()),
                         [](const auto& test) { return test.param.name; });

/// Returns "name" and "name:variant" of every robot of the library.
std::vector<std::string> robots_of_the_library() {
  std::vector<std::string> names;
  std::error_code ignored;  // without the folder, the list is empty
  for (const auto& entry : fs::directory_iterator(BURNISH_ROBOTS_DIR, ignored)) {
    if (!fs::exists(entry.path() / "robot.yaml")) continue;
    const std::string name = entry.path().filename().string();
    names.push_back(name);
    for (const auto& variant : read_robot_settings(entry.path() / "robot.yaml").variants) {
      names.push_back(name + ":" + variant.first);
    }
  }
  return names;
}

TEST(LibraryRobot, EveryVariant_LoadsWithValidPostures) {
  for (const std::string& name : robots_of_the_library()) {
    const Robot robot = load_robot(name);
    EXPECT_GT(robot.model.nv, 0) << name;
    for (const auto& [posture, values] : robot.postures) {
      EXPECT_NO_THROW(check_configuration(robot.model, robot.posture(posture)))
          << name << " " << posture;
    }
    EXPECT_NO_THROW(check_configuration(robot.model, robot.reference_configuration())) << name;
  }
}

}  // namespace
}  // namespace burnish::testing

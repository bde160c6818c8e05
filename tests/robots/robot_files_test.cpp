// Tests of robot files: names without a known ending, pipes, SRDF beside URDF, MJCF, and settings.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "burnish/robots/robot.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

std::string body(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/>"
         "</inertial></link>";
}
std::string moving(const std::string& name, const std::string& type, const std::string& parent,
                   const std::string& child) {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><limit " +
         (type == "continuous" ? "" : "lower='-1' upper='1' ") +
         "velocity='2' effort='3'/></joint>";
}
const std::string& two_joints() {
  static const std::string xml = "<robot name='arm'><link name='base'/>" + body("upper") +
                                 body("lower") + moving("hinge", "revolute", "base", "upper") +
                                 moving("wheel", "continuous", "upper", "lower") + "</robot>";
  return xml;
}

/// Writes files into a folder that is removed at the end.
class RobotFiles : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    return scratch_.write(name, text).string();
  }
  testing::Scratch scratch_;
  const fs::path& folder_ = scratch_.folder;
};

TEST_F(RobotFiles, AnyFileEnding_IsRead) {
  for (const char* name : {"ARM.URDF", "arm.xml", "arm", "arm.urdf.txt"}) {
    EXPECT_EQ(load_robot(write(name, two_joints())).model.nv, 2) << name;
  }
  write("arm.urdf", two_joints());
  EXPECT_EQ(load_robot(write("SETTINGS.YAML", "urdf: arm.urdf\nlock: [wheel]")).model.nv, 1);
  expect_words(refusal([&] { load_robot(write("arm.stl", "solid")); }), {"arm.stl", "line 1"});
  expect_words(refusal([&] { load_robot(write("arm.sdf", "<sdf/>")); }), {"<sdf>", "<robot>"});
}

/// Returns an MJCF model with a slide joint, a hinge and a site; `more` is added to it.
std::string mjcf(const std::string& more = "") {
  return "<?xml version='1.0'?>\n<!-- <robot/> --><mujoco model='m'><option gravity='0 0 -2'/>"
         "<worldbody><body name='b'><joint name='s' type='slide'/><geom size='0.1'/><body "
         "name='c'><joint name='h' ref='90'/><geom size='0.1'/><site name='tip' pos='0 0 "
         "1'/></body></body></worldbody>" +
         more + "</mujoco>";
}

TEST_F(RobotFiles, Format_IsDetectedFromTheContent) {
  for (const char* name : {"m.xml", "M.MJCF", "m", "m.urdf"}) {
    const Robot robot = load_robot(write(name, mjcf()));
    EXPECT_EQ(robot.model.nv, 2) << name;
    EXPECT_EQ(robot.model.gravity.z(), -2.0);
    EXPECT_TRUE(robot.model.has_frame("tip"));
    EXPECT_EQ(robot.default_posture, "qpos0");
    EXPECT_NEAR(robot.reference_configuration()[1], 0.5 * std::acos(-1.0), 1e-15);
  }
  // A URDF file with a <mujoco> element is not MJCF.
  EXPECT_EQ(
      load_robot(write("a.xml", "<robot name='a'><mujoco/><link name='l'/></robot>")).model.name,
      "a");
  const auto refused = [&](const std::string& text) {
    return refusal([&] { load_robot(write("m.xml", text)); });
  };
  expect_words(refused("<!-- a --><sdf version='1.7'/>"),
               {"m.xml", "<sdf>", "<mujoco>", "<robot>"});
  expect_words(refused("#usda 1.0\n"), {"m.xml", "USD", "MJCF"});
  expect_words(refused("PXR-USDC"), {"m.xml", "USD"});
  expect_words(refused("<mujocoinclude/>"), {"m.xml", "<mujocoinclude>", "includes it"});
  expect_words(refused("<mujoco/>"), {"m.xml", "<worldbody>"});
}

TEST_F(RobotFiles, MjcfInSettings_IsReadWithItsKeyframes) {
  write("m.xml",
        mjcf("<keyframe><key name='home' qpos='1 2'/><key name='far' qpos='3 4'/></keyframe>"));
  const auto load = [&](const std::string& settings) {
    return load_robot(write("robot.yaml", settings));
  };
  const Robot robot = load("mjcf: m.xml");
  EXPECT_EQ(robot.default_posture, "home");
  EXPECT_EQ(robot.posture("far"), Eigen::Vector2d(3, 4));
  const Robot changed = load(
      "mjcf: m.xml\nlock: [h]\ndefault_posture: far\npostures: {home: {s: 7}}\n"
      "frames: {tip: {parent: c, xyz: [1, 0, 0]}, more: {parent: tip}}\nvariants: {free: {lock: "
      "[]}}");
  EXPECT_EQ(changed.model.nv, 1);
  EXPECT_EQ(changed.posture("home")[0], 7.0);
  EXPECT_EQ(changed.reference_configuration()[0], 3.0);
  const auto frame = static_cast<std::size_t>(changed.model.frame_index("more"));
  // The locked joint is at 4 rad, its angle in the default posture. The frame is 1 m off the body.
  EXPECT_NEAR(std::abs(changed.model.frames[frame].placement.translation().norm()), 1.0, 1e-14);
  expect_words(refusal([&] { load("mjcf: m.xml\nurdf: m.urdf"); }),
               {"robot.yaml", "'urdf'", "'mjcf'"});
  expect_words(refusal([&] { load("description: none"); }), {"robot.yaml", "'urdf'", "'mjcf'"});
  expect_words(refusal([&] { load("urdf: m.xml"); }), {"m.xml", "<mujoco>", "<robot>"});
}

TEST_F(RobotFiles, UrdfInAPipe_IsRead) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], two_joints().data(), two_joints().size()),
            static_cast<ssize_t>(two_joints().size()));
  ::close(ends[1]);
  const std::string path = "/dev/fd/" + std::to_string(ends[0]);
  if (!fs::exists(path)) GTEST_SKIP() << "this system has no paths of pipes";
  EXPECT_EQ(load_robot(path).model.name, "arm");
  ::close(ends[0]);
}

TEST_F(RobotFiles, NamelessRobot_IsAWarningAndWithStrictAnError) {
  const std::string file =
      write("arm.urdf", "<robot><link name='base'/>" + body("upper") +
                            moving("hinge", "revolute", "base", "upper") + "</robot>");
  const Robot robot = load_robot(file);
  EXPECT_EQ(robot.model.name, "arm");
  ASSERT_EQ(robot.warnings.size(), 1u);
  expect_words(robot.warnings[0], {file, "line 1", "no name"});
  RobotOverrides strict;
  strict.strict = true;
  expect_words(refusal([&] { load_robot(file, strict); }), {file, "no name", "strict"});
}

const char* const states = R"(<robot name="arm">
  <group_state name="home" group="hinge"><joint name="hinge" value="0.5"/></group_state>
  <group_state name="home" group="wheel"><joint name="wheel" value="-0.25"/></group_state>
  <group_state name="up" group="all"><joint name="root_joint" value="0 0 1 0 0 0 1"/>
    <joint name="wheel" value="0 1"/></group_state>
</robot>)";

TEST_F(RobotFiles, SrdfBesideTheUrdf_GivesPostures) {
  write("urdf/arm.urdf", two_joints());
  write("srdf/arm.srdf", states);
  const Robot robot = load_robot((folder_ / "urdf/arm.urdf").string());
  EXPECT_TRUE(robot.warnings.empty());
  EXPECT_EQ(robot.postures.at("home"), (Posture{{"hinge", {0.5}}, {"wheel", {-0.25}}}));
  const Eigen::VectorXd up = robot.posture("up");
  EXPECT_EQ(up[0], 0.0);
  EXPECT_NEAR(up[1], 0.0, 1e-15);  // given as cosine and sine
  EXPECT_EQ(up[2], 1.0);
  EXPECT_EQ(robot.default_posture, "");
  RobotOverrides overrides;
  overrides.srdf = write("other.srdf", "<robot><group_state name='other' group='all'/></robot>");
  EXPECT_TRUE(
      load_robot((folder_ / "urdf/arm.urdf").string(), overrides).postures.contains("other"));
}

TEST_F(RobotFiles, PostureBeyondTheLimits_IsAWarning) {
  const std::string file = write("arm.urdf", two_joints());
  write("arm.srdf",
        "<robot name='arm'><group_state name='up' group='g'><joint name='hinge' value='1.5'/>"
        "</group_state><group_state name='home' group='g'><joint name='hinge' value='1'/>"
        "</group_state></robot>");
  const Robot robot = load_robot(file);
  ASSERT_EQ(robot.warnings.size(), 1U);
  expect_words(robot.warnings[0],
               {file, "posture 'up': joint 'hinge' is at 1.5 rad", "its limits are -1 and 1 rad"});
  EXPECT_EQ(robot.postures.size(), 2U);
}

TEST_F(RobotFiles, PostureInSettings_OverridesSrdf) {
  write("arm.urdf", two_joints());
  write("states.srdf", states);
  const std::string settings =
      "urdf: arm.urdf\ndefault_posture: up\npostures: {home: {hinge: 0.75}}\n";
  write("robot.yaml", settings + "srdf: states.srdf\n");
  const Robot robot = load_robot(folder_.string());
  EXPECT_EQ(robot.posture("home")[0], 0.75);
  EXPECT_EQ(robot.default_posture, "up");
  write("robot.yaml", settings + "srdf: stats.srdf\n");
  expect_words(refusal([&] { load_robot(folder_.string()); }), {"stats.srdf", "cannot be opened"});
}

TEST_F(RobotFiles, BadEntriesOfSrdf_AreWarnings) {
  const std::string file = write("arm.urdf", two_joints());
  write("arm.srdf",
        "<robot>\n"
        "<group_state name='bad'>\n"
        "<joint name='hinje' value='1'/>\n"
        "<joint name='hinge' value='1 2'/>\n"
        "<joint name='wheel' value='far'/>\n"
        "</group_state>\n"
        "<group_state name='bad'><joint name='hinge' value='1'/></group_state>\n"
        "<group_state name='bad'><joint name='hinge' value='2'/></group_state>\n"
        "<group_state/></robot>");
  const Robot robot = load_robot(file);
  EXPECT_EQ(robot.postures.at("bad"), (Posture{{"hinge", {1.0}}}));
  ASSERT_EQ(robot.warnings.size(), 5u);
  expect_words(robot.warnings[0], {"arm.srdf: line 3: ", "'bad'", "'hinje'", "'hinge'?"});
  expect_words(robot.warnings[1], {"'hinge'", "wanted 1"});
  expect_words(robot.warnings[2], {"line 5", "'far'"});
  expect_words(robot.warnings[3], {"line 8", "another value above"});
  expect_words(robot.warnings[4], {"line 9", "no name"});
  // A broken file that nobody requested is a warning only.
  write("arm.srdf", "solid");
  EXPECT_EQ(load_robot(file).warnings.size(), 1u);
  RobotOverrides overrides;
  overrides.srdf = (folder_ / "arm.srdf").string();
  expect_words(refusal([&] { load_robot(file, overrides); }), {"arm.srdf", "not well formed"});
}

TEST_F(RobotFiles, ZeroEffortInSettings_IsALimitWithoutAWarning) {
  std::string xml = two_joints();
  const std::size_t at = xml.find("effort='3'");
  xml.replace(at, 10, "effort='0'");
  write("arm.urdf", xml);
  ASSERT_EQ(load_robot((folder_ / "arm.urdf").string()).warnings.size(), 1U);
  write("robot.yaml", "urdf: arm.urdf\nlimits: {hinge: {effort: 0}}");
  const Robot robot = load_robot(folder_.string());
  EXPECT_EQ(robot.warnings, std::vector<std::string>());
  EXPECT_EQ(robot.model.effort_limit[0], 0.0);
  write("robot.yaml", "urdf: arm.urdf\nlimits: {wheel: {effort: 0}}");
  EXPECT_EQ(load_robot(folder_.string()).warnings.size(), 1U);
}

TEST_F(RobotFiles, RepeatedElement_IsReadOnceWithAWarning) {
  struct Duplicate {
    const char *before, *more, *words;
  };
  for (const Duplicate& duplicate :
       {Duplicate{"</inertial>", "<inertial><mass value='7'/></inertial>",
                  "<link> holds <inertial>"},
        {"<limit", "<axis xyz='0 1 0'/><axis xyz='0 0 1'/>", "<joint> holds <axis>"},
        {"<limit", "<limit lower='-0.1' upper='0.1' velocity='2' effort='3'/>", "holds <limit>"},
        {"<limit", "<dynamics damping='1'/><dynamics damping='2'/>", "holds <dynamics>"},
        {"<limit", "<origin xyz='0 0 1'/><origin xyz='0 0 2'/>", "holds <origin>"}}) {
    std::string xml = two_joints();
    const std::string before = duplicate.before;
    xml.insert(xml.find(before) + (before[1] == '/' ? before.size() : 0), duplicate.more);
    const Robot robot = load_robot(write("arm.urdf", xml));
    ASSERT_EQ(robot.warnings.size(), 1U) << duplicate.more;
    expect_words(robot.warnings[0], {duplicate.words, "twice", "the first one counts"});
    EXPECT_EQ(robot.model.total_mass(), 2.0);
    const Model& model = robot.model;
    const std::string words = duplicate.words;
    EXPECT_EQ(model.damping[0], words == "holds <dynamics>" ? 1.0 : 0.0);
    EXPECT_EQ(model.q_upper[0], words == "holds <limit>" ? 0.1 : 1.0);
  }
}

TEST_F(RobotFiles, LimitsInSettings_OverrideTheUrdf) {
  write("arm.urdf", two_joints());
  write("robot.yaml",
        "urdf: arm.urdf\nlimits: {hinge: {lower: -0.5, effort: 40}, wheel: {velocity: .inf}}\n"
        "variants: {free: {limits: {hinge: {lower: -.inf}}}}");
  const Model model = load_robot(folder_.string()).model;
  EXPECT_EQ(model.q_lower[0], -0.5);
  EXPECT_EQ(model.q_upper[0], 1.0);
  EXPECT_EQ(model.effort_limit, Eigen::Vector2d(40.0, 3.0));
  EXPECT_EQ(model.velocity_limit[0], 2.0);
  EXPECT_TRUE(std::isinf(model.velocity_limit[1]));
  const Model free = load_robot(folder_.string() + ":free").model;
  EXPECT_TRUE(std::isinf(free.q_lower[0]));
  EXPECT_EQ(free.effort_limit[0], 3.0);
  const auto sentence = [&](const std::string& limits) {
    write("robot.yaml", "urdf: arm.urdf\nlimits: " + limits);
    return refusal([&] { load_robot(folder_.string()); });
  };
  expect_words(sentence("{hinje: {lower: 1}}"), {"robot.yaml", "'hinje'", "'hinge'?"});
  expect_words(sentence("{wheel: {lower: 1}}"), {"robot.yaml", "'wheel'", "revolute"});
  expect_words(sentence("{hinge: {lower: 2}}"), {"'hinge'", "2", "above", "1"});
  expect_words(sentence("{hinge: {lower: .inf, upper: .inf}}"),
               {"robot.yaml", "'hinge'", "no position between inf and inf"});
  expect_words(sentence("{hinge: {lowr: 2}}"), {"limits.hinge", "'lowr'", "'lower'?"});
  expect_words(sentence("{hinge: {lower: low}}"), {"limits.hinge.lower", "'low'", "number"});
}

TEST_F(RobotFiles, JointsInSettings_SetSpringsFrictionAndRotors) {
  write("arm.urdf", two_joints());
  write("robot.yaml",
        "urdf: arm.urdf\n"
        "joints: {hinge: {armature: 0.5, stiffness: 7, rest: 0.1}, wheel: {friction: 0.2}}\n"
        "variants: {geared: {joints: {hinge: {armature: 0.5, rotor_inertia: 2e-5, gear_ratio: -100,"
        " damping: 3}}}}");
  const Model model = load_robot(folder_.string()).model;
  EXPECT_EQ(model.armature[0], 0.5);
  EXPECT_EQ(model.stiffness, Eigen::Vector2d(7.0, 0.0));
  EXPECT_EQ(model.spring_rest[0], 0.1);
  EXPECT_EQ(model.friction[1], 0.2);
  const Model geared = load_robot(folder_.string() + ":geared").model;
  EXPECT_NEAR(geared.armature[0], 0.7, 1e-12);
  EXPECT_EQ(geared.damping[0], 3.0);
  const auto sentence = [&](const std::string& joints) {
    write("robot.yaml", "urdf: arm.urdf\njoints: " + joints);
    return refusal([&] { load_robot(folder_.string()); });
  };
  expect_words(sentence("{hinje: {rest: 1}}"), {"robot.yaml", "'hinje'", "'hinge'?"});
  expect_words(sentence("{hinge: {stifness: 1}}"), {"'stifness'", "'stiffness'?"});
  expect_words(sentence("{hinge: {stiffness: -1}}"),
               {"joints.hinge.stiffness", "-1", "at least 0"});
  expect_words(sentence("{hinge: {gear_ratio: 50}}"), {"'gear_ratio'", "'rotor_inertia'"});
}

TEST_F(RobotFiles, InertiasAndPayloadInSettings_AreApplied) {
  write("arm.urdf", two_joints());
  write("robot.yaml", "urdf: arm.urdf");
  const Model plain = load_robot(folder_.string()).model;
  const std::string link = plain.frames[static_cast<std::size_t>(plain.frames.size()) - 1].name;
  const auto loaded = [&](const std::string& lines, const std::string& variant = "") {
    write("robot.yaml", "urdf: arm.urdf\n" + lines);
    return load_robot(folder_.string() + variant).model;
  };
  const std::string hand = "frames: {hand: {parent: " + link + ", xyz: [0, 0, 0.1]}}\n";
  const std::string brick =
      "payload: {frame: hand, mass: 2, com: [0, 0, 0.1], inertia: [0.1, 0.1, 0.1]}\n";
  EXPECT_NEAR(loaded(hand + brick).total_mass(), plain.total_mass() + 2.0, 1e-12);
  EXPECT_NEAR(
      loaded(hand + "variants: {full: {" + brick.substr(0, brick.size() - 1) + "}}", ":full")
          .total_mass(),
      plain.total_mass() + 2.0, 1e-12);
  const Model other = loaded("inertias: {" + link + ": {mass: 7, inertia: [1, 0, 0, 1, 0, 1]}}");
  EXPECT_EQ(other.joints.back().mass, 7.0);
  EXPECT_EQ(other.joints.back().inertia_at_com, Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  const auto sentence = [&](const std::string& lines) {
    return refusal([&] { (void)loaded(hand + lines); });
  };
  expect_words(sentence("payload: {frame: hnd, mass: 1}"), {"robot.yaml", "'hnd'", "'hand'?"});
  expect_words(sentence("payload: {mass: -1}"), {"payload.mass", "-1"});
  expect_words(sentence("payload: {mass: 1, inertia: [1, 1, 3]}"), {"payload", "no solid"});
  expect_words(sentence("payload: {mass: 1, inertia: [1, 1]}"), {"payload.inertia", "2 numbers"});
  expect_words(sentence("payload: {com: [0, 0, 0]}"), {"payload", "'mass'"});
  expect_words(sentence("inertias: {nothing: {mass: 1}}"), {"robot.yaml", "'nothing'"});
}

TEST_F(RobotFiles, RobotWithoutSettings_MovesOnlyJointsThatCarryTheTool) {
  const std::string xml =
      "<robot name='two arms'><link name='base'/>" + body("left") + body("hand") + body("right") +
      body("finger") + moving("l", "revolute", "base", "left") +
      moving("h", "fixed", "left", "hand") + moving("r", "revolute", "base", "right") +
      "<joint name='f' type='revolute'><parent link='right'/><child link='finger'/>"
      "<mimic joint='l'/></joint></robot>";
  const std::string file = write("arms.urdf", xml);
  const auto moving_for = [&](const std::string& name, const std::string& robot) {
    RobotOverrides overrides;
    overrides.carrying = name;
    std::vector<std::string> names;
    for (const Joint& joint : load_robot(robot, overrides).model.joints)
      names.push_back(joint.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(moving_for("hand", file), (Names{"l", "f"})) << "a follower moves with its leader";
  EXPECT_EQ(moving_for("h", file), (Names{"l", "f"})) << "the name may be that of a joint";
  EXPECT_EQ(moving_for("right", file), Names{"r"});
  EXPECT_EQ(moving_for("finger", file), (Names{"l", "r", "f"})) << "the leader is needed, too";
  EXPECT_EQ(moving_for("base", file).size(), 3u);
  EXPECT_EQ(moving_for("hnad", file).size(), 3u);
  write("robot.yaml", "urdf: arms.urdf");
  EXPECT_EQ(moving_for("right", folder_.string()).size(), 3u) << "settings lock no joint here";
}

}  // namespace
}  // namespace burnish::testing

// Tests of the commands burnish, burnish show and burnish check.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "support/six_joint_arm.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

TEST(Program, HelpAndVersion_ArePrinted) {
  EXPECT_EQ(run("--version").out, "burnish " BURNISH_VERSION "\n");
  for (const std::string arguments : {"--help", "show --help", "check --help", "eval --help"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.out.find("Examples:\n  "), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
  const Outcome bare = run("");
  EXPECT_EQ(bare.exit_code, 2);
  EXPECT_NE(bare.err.find("Usage: burnish"), std::string::npos);
}

TEST(Program, BadUsage_IsRefusedInOneSentence) {
  expect_refused(run("chek arm7"), "unknown command 'chek'; did you mean 'check'?");
  expect_refused(run("show"), "ROBOT is required");
  expect_refused(run("show arm7 --lok joint_1"),
                 "unknown argument '--lok'; did you mean '--lock'?");
  expect_refused(run("show arm7 extra"), "unknown argument 'extra'");
  expect_refused(run("show arm8"), "robot 'arm8' does not exist; did you mean 'arm7'?");
  expect_refused(run("show nowhere.urdf"), "nowhere.urdf: it does not exist");
  expect_refused(run("show arm7 --fixed --free-flyer"), "exclude each other");
  expect_refused(run("show arm7 --lock joint_11"), "did you mean 'joint_1'?");
  expect_refused(run("show arm7 --posture redy"), "did you mean 'ready'?");
  expect_refused(run("check arm7 --states many"), "could not convert: --states = many");
  expect_refused(run("check arm7 --states 0"), "states is 0; wanted at least 1");
  expect_refused(run("check arm7 --contact directions=z"), "key 'tool' is missing");
  expect_refused(run("check arm7 --contact tool=tool,directons=z"),
                 "key 'directons' is unknown; did you mean 'directions'?");
  expect_refused(run("check arm7 --contact tool=tool,kp=1,2"), "kp: it has 2 numbers; wanted 6");
  expect_refused(run("check arm7 --contact tool=tool,kp=1,kp=2"), "key 'kp' is stated twice");
  expect_refused(run("check arm7 --contact tool=tool,reference=local,normal=0,0,1"),
                 "key 'normal' is given without reference=surface");
  const std::string nope = run("check arm7 --tool nope").err;
  EXPECT_NE(nope.find("frame 'nope' does not exist"), std::string::npos) << nope;
  EXPECT_EQ(nope.find("did you mean"), std::string::npos) << nope;
  expect_refused(run("check arm7 --contact tool=tool,kp=much"), "kp: 'much' is not a number");
}

TEST(CheckCommand, ContactInBraces_EqualsTheContactAsPairs) {
  const std::string check = "check arm7 --states 2 --json --contact ";
  const Outcome pairs = run(check + "tool=tool,normal=0,0.2,1,directions=z,rx,kp=9");
  EXPECT_EQ(pairs.exit_code, 0) << pairs.err;
  const Outcome braces = run(check +
                             "'{tool: tool, reference: {surface: {normal: [0, 0.2, 1]}}, "
                             "directions: [z, rx], kp: 9, target: here}'");
  EXPECT_EQ(pairs.out, braces.out) << braces.err;
}

TEST(ShowCommand, MarginsOfATool_NameEveryJoint) {
  const Outcome outcome = run("show talos:right_arm --tool tool");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"Margins at tool on a table", "ms of extra delay", "gain of joint",
                            "in free air", "in contact", "arm_right_4_joint"})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
  expect_refused(run("show talos:right_arm --tool tol"), "did you mean 'tool'?");
  const Outcome without = run("show quadruped --tool fl_foot");  // its base floats
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_NE(without.err.find("note: no margins at fl_foot: "), std::string::npos) << without.err;
  EXPECT_NE(without.out.find("Frames"), std::string::npos) << without.out;
  const Json json = Json::parse(run("show talos:right_arm --tool tool --json").out);
  const Json& margins = json.at("margins");
  EXPECT_EQ(margins["tool"], "tool");
  char text[32];
  std::snprintf(text, sizeof text, "tolerates %.1f ms", 1e3 * margins["delay"].get<double>());
  EXPECT_NE(outcome.out.find(text), std::string::npos) << text << "\n" << outcome.out;
  for (const char* situation : {"air", "contact"}) {
    const Json& gains = margins[situation]["gains"];
    ASSERT_EQ(gains.size(), 6U);
    EXPECT_EQ(gains[5]["joint"], "arm_right_4_joint");
    EXPECT_LT(gains[5]["below"], 1.0);
    EXPECT_GT(gains[5]["above"], 1.0);
  }
  EXPECT_FALSE(Json::parse(run("show talos:right_arm --json").out).contains("margins"));
}

TEST(ShowCommand, Robot_IsPrintedAsATreeOfJoints) {
  const Outcome outcome = run("show crane");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string line :
       {"crane: 10 moving joints, 13 entries in q, 10 in v, 157.74 kg of moving mass\n",
        "  ├─ left_luff_joint     revolute        3  2   -0.7    1.2       0.8     520    14\n",
        "     right_wrist_joint   continuous  11-12  9      -      -       2.5      25   0.8\n",
        "Locked joints\n  left_finger_a_joint left_finger_b_joint\n", "  work (default)\n",
        "Frames in the world at 'work'"}) {
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << outcome.out;
  }
  EXPECT_EQ(outcome.out.find(" \n"), std::string::npos) << "a line ends with a blank";
}

TEST(ShowCommand, BaseAndLockOptions_ChangeTheNumberOfJoints) {
  EXPECT_NE(run("show arm7 --free-flyer").out.find("8 moving joints"), std::string::npos);
  EXPECT_NE(run("show arm7 --lock joint_3 joint_5").out.find("5 moving joints"), std::string::npos);
  EXPECT_NE(run("show arm7 --lock joint_3,joint_5").out.find("5 moving joints"), std::string::npos);
  EXPECT_NE(run("show arm7 --free joint_3").out.find("1 moving joints"), std::string::npos);
}

TEST(ShowCommand, JsonOption_PrintsJointsFramesAndPosture) {
  const Outcome outcome = run("show talos:right_arm --posture board_x --json");
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["nv"], 6);
  EXPECT_EQ(json["joints"].size(), 6U);
  EXPECT_EQ(json["joints"][5]["name"], "arm_right_4_joint");
  EXPECT_EQ(json["shown_posture"], "board_x");
  EXPECT_EQ(json["locked_joints"].size(), 24U);
  for (const Json& frame : json["frames"]) {
    if (frame["name"] != "tool") continue;
    EXPECT_NEAR(frame["xyz"][0].get<double>(), 0.489, 1e-3);
    EXPECT_NEAR(frame["xyz"][1].get<double>(), -0.336, 1e-3);
    EXPECT_NEAR(frame["xyz"][2].get<double>(), 1.152, 1e-3);
  }
}

/// A robot without a name whose finger has no mass.
const char* const flawed_robot =
    "<robot><link name='base'/><link name='arm'><inertial><origin xyz='0 0 1'/><mass value='1'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link>\n"
    "<link name='finger'/><joint name='hinge' type='revolute'><parent link='base'/><child "
    "link='arm'/>"
    "<limit lower='-2' upper='-1' velocity='1' effort='5'/></joint>\n"
    "<joint name='grip' type='continuous'><parent link='arm'/><child "
    "link='finger'/></joint></robot>";

TEST(ShowCommand, FlawedRobot_IsAWarningAndWithStrictAnError) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write("odd.urdf", flawed_robot));
  const Outcome outcome = run("show " + file);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(lines_of(outcome.err), 2) << outcome.err;
  EXPECT_NE(outcome.err.find("burnish: warning: "), std::string::npos);
  EXPECT_NE(outcome.err.find("joint 'grip' moves no mass"), std::string::npos) << outcome.err;
  EXPECT_EQ(Json::parse(run("show --json " + file).out)["warnings"].size(), 2U);
  const Outcome strict = run("show --strict " + file);
  EXPECT_EQ(strict.exit_code, 2);
  EXPECT_EQ(lines_of(strict.err), 2) << strict.err;
}

TEST(StrictOption, NamelessRobot_IsRefusedByEveryCommand) {
  const Scratch scratch;
  std::string nameless = flawed_robot;  // without the massless joint
  nameless.replace(nameless.find("continuous"), std::string("continuous").size(), "fixed");
  const std::string file = quoted(scratch.write("odd.urdf", nameless));
  const std::string out = " --out " + quoted(scratch.folder / "out");
  const std::string problem =
      quoted(scratch.write("problem.yaml",
                           "robot: odd.urdf\nstages: {s: {costs: {r: {type: joint_velocity}}}}\n"
                           "horizon: [s: 2]\n"));
  const std::string request = quoted(scratch.write("request.json", R"({"robot": "odd.urdf"})"));
  for (const std::string& command :
       {"show " + file, "check " + file, "bench " + file, "eval " + request,
        "solve " + problem + out, "polish --plant ideal --tool finger --robot " + file + out,
        "experiment tick --quick --plant ideal --set robot=" + file + out}) {
    const Outcome outcome = run(command + " --strict");
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_NE(outcome.err.find("<robot> has no name"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("strict reading rejects"), std::string::npos) << outcome.err;
  }
}

TEST(SingularMass, MasslessJoint_IsRefusedByCommandsThatSimulate) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write("odd.urdf", flawed_robot));
  const std::string out = " --out " + quoted(scratch.folder / "out");
  const std::string problem =
      quoted(scratch.write("problem.yaml",
                           "robot: odd.urdf\nstages: {s: {costs: {r: {type: joint_velocity}}}}\n"
                           "horizon: [s: 2]\n"));
  for (const std::string& command : {"bench " + file, "solve " + problem + out,
                                     "polish --plant ideal --tool finger --robot " + file + out}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_NE(outcome.err.find("': joint 'grip' moves no mass"), std::string::npos) << outcome.err;
  }
}

TEST(ShowCommand, RobotInAPipe_IsRead) {
  const std::string program = "'" BURNISH_PROGRAM "' ";
  for (const std::string& command : {"cat | " + program + "show /dev/stdin",
                                     "bash -c \"" + program + "show <(cat)\" 0</dev/stdin"}) {
    const Outcome outcome = shell("cat | " + command, flawed_robot);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("2 moving joints"), std::string::npos) << outcome.out;
  }
}

TEST(ShowCommand, BadUrdf_ListsEachProblemOnALine) {
  const Scratch scratch;
  const Outcome outcome =
      run("show " + quoted(scratch.write(
                        "bad.urdf",
                        "<robot name='r'><link name='a'/><link name='a'/>\n"
                        "<link name='b'><inertial><mass value='-1'/></inertial></link></robot>")));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(lines_of(outcome.err), 3) << outcome.err;
  EXPECT_NE(outcome.err.find("line 2: link 'b': mass -1 kg is negative"), std::string::npos);
}

TEST(ShowCommand, WriteSettings_DraftsAFileThatLoads) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write("odd.urdf", flawed_robot));
  const std::string folder = quoted(scratch.folder / "drafted");
  const Outcome outcome = run("show " + file + " --write-settings " + folder);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(scratch.folder / "drafted/robot.yaml");
  for (const std::string line :
       {"urdf: ../odd.urdf\n", "base: fixed", "  start: {hinge: -1.1, grip: 0}\n",
        "  tool: {parent: finger, xyz: [0, 0, 0], rpy: [0, 0, 0]}\n",
        "  hinge: {lower: -2, upper: -1, velocity: 1, effort: 5}\n", "  grip: {}\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  const Json json = Json::parse(run("show --json " + folder).out);
  EXPECT_EQ(json["default_posture"], "start");
  EXPECT_EQ(json["joints"][0]["effort_limit"][0], 5.0);
  const Outcome again = run("show " + file + " --write-settings " + folder);
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("robot.yaml: the file already exists"), std::string::npos) << again.err;
  expect_refused(run("show arm7 --write-settings " + folder), "a URDF or MJCF file");
}

TEST(ShowCommand, WriteSettingsOfALeggedRobot_DraftsFeetAndStandingPosture) {
  const Scratch scratch;
  const std::string file =
      quoted(std::filesystem::path(BURNISH_ROBOTS_DIR) / "quadruped" / "quadruped.urdf");
  const std::string folder = quoted(scratch.folder / "drafted");
  const Outcome outcome = run("show " + file + " --free-flyer --write-settings " + folder);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(scratch.folder / "drafted/robot.yaml");
  for (const std::string line :
       {"base: free_flyer\n", "# Feet: ", "standing: {feet: [", "half_x: 0, half_y: 0, radius: 0.",
        "default_posture: standing\n", "  standing: {", "root_joint: ["})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  EXPECT_EQ(text.find("  tool: "), std::string::npos)
      << "a leg with a foot must not become the tool" << text;
  const Json json = Json::parse(run("show --json " + folder).out);
  EXPECT_EQ(json["default_posture"], "standing");
  EXPECT_EQ(json["nv"], 18);
}

TEST(ShowCommand, WriteSettings_SkipsAPostureBeyondTheLimits) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write(
      "arm.urdf",
      "<robot name='arm'><link name='base'/><link name='l1'><inertial><mass value='1'/><inertia "
      "ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><joint name='j1' "
      "type='revolute'><parent link='base'/><child link='l1'/><axis xyz='0 1 0'/><limit "
      "lower='0.5' upper='3' effort='5' velocity='1'/></joint></robot>"));
  scratch.write("arm.srdf",
                "<robot name='arm'><group name='g'><joint name='j1'/></group>"
                "<group_state name='home' group='g'><joint name='j1' value='-1.5'/></group_state>"
                "<group_state name='up' group='g'><joint name='j1' value='1.5'/></group_state>"
                "</robot>");
  const Outcome outcome = run("show " + file + " --write-settings " + quoted(scratch.folder / "d"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(scratch.folder / "d/robot.yaml");
  EXPECT_NE(text.find("# Posture home: joint 'j1' is at -1.5 rad; its limits are 0.5 and 3 rad.\n"
                      "default_posture: up\n"),
            std::string::npos)
      << text;
}

TEST(ShowCommand, WriteSettingsWithATool_DraftsAPostureForATable) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write("arm.urdf", six_joint_arm(with_gripper())));
  const std::string folder = quoted(scratch.folder / "drafted");
  const std::string draft = "show " + file + " --write-settings " + folder;
  expect_refused(run(draft + " --tool flang"), "did you mean 'flange'?");
  EXPECT_FALSE(std::filesystem::exists(scratch.folder / "drafted"));
  const Outcome outcome = run(draft + " --tool flange");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const std::string text = contents(scratch.folder / "drafted/robot.yaml");
  for (const std::string line : {"lock: [left, right]\n", "  table: {j1: ",
                                 "  tool: {parent: flange, xyz: [0, 0, 0], rpy: [0, 0, 0]}\n",
                                 "  j6: {lower: -3, upper: 3, velocity: 3, effort: 28}\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  const Json json = Json::parse(run("show --json " + folder).out);
  EXPECT_EQ(json["nv"], 6);
  EXPECT_EQ(json["default_posture"], "start");
}

TEST(ShowCommand, WriteSettingsOfAGripper_PutsTheToolBetweenTheFingers) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write("arm.urdf", six_joint_arm(with_gripper())));
  EXPECT_EQ(run("show " + file + " --write-settings " + quoted(scratch.folder / "a")).exit_code, 0);
  const std::string text = contents(scratch.folder / "a/robot.yaml");
  EXPECT_NE(text.find("  tool: {parent: tcp, "), std::string::npos) << text;
  // The drafted effort of a leader is its own; the model adds that of its follower.
  const std::string lift = "<robot name='lift'><link name='base'/>" + finger("outer", "base", 0.0) +
                           finger("inner", "outer_link", 0.0, "<mimic joint='outer'/>") +
                           "</robot>";
  const std::string lift_file = quoted(scratch.write("lift.urdf", lift));
  EXPECT_EQ(
      run("show " + lift_file + " --write-settings " + quoted(scratch.folder / "b")).exit_code, 0);
  const std::string limits = contents(scratch.folder / "b/robot.yaml");
  EXPECT_NE(limits.find("outer: {lower: 0, upper: 0.04, velocity: 0.2, effort: 20}"),
            std::string::npos)
      << limits;
  for (const std::string& robot : {lift_file, quoted(scratch.folder / "b")})
    EXPECT_EQ(Json::parse(run("show --json " + robot).out)["joints"][0]["effort_limit"][0], 40.0);
}

TEST(ShowCommand, Mjcf_IsReadAndItsSettingsDrafted) {
  const Scratch scratch;
  const std::string file = quoted(scratch.write(
      "dog.xml",
      "<mujoco model='dog'><worldbody><light/><body name='trunk' pos='0 0 1'><freejoint/>"
      "<geom size='0.1'/><body name='leg'><joint name='hip' range='-20 20'/><geom size='0.1' "
      "pos='0 0 -0.3'/></body></body></worldbody><actuator><motor joint='hip' "
      "ctrlrange='-5 5'/></actuator></mujoco>"));
  const Outcome shown = run("show --json " + file);
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_NE(shown.err.find("1 <light>"), std::string::npos) << shown.err;
  const Json json = Json::parse(shown.out);
  EXPECT_EQ(json["nv"], 7);
  EXPECT_EQ(json["joints"][1]["effort_limit"][0], 5.0);
  const std::string folder = quoted(scratch.folder / "drafted");
  EXPECT_EQ(run("show " + file + " --write-settings " + folder).exit_code, 0);
  const std::string text = contents(scratch.folder / "drafted/robot.yaml");
  for (const std::string line : {"mjcf: ../dog.xml\n", "base: fixed", "default_posture: qpos0\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  EXPECT_EQ(Json::parse(run("show --json " + folder).out)["nv"], 7);
  EXPECT_EQ(run("check " + folder + " --states 2").exit_code, 0);
}

TEST(CheckCommand, GoodRobot_PassesWithExitCodeZero) {
  const Outcome outcome = run("check arm7 --states 2");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "") << "progress is shown on terminals only";
  EXPECT_NE(outcome.out.find("pass: all 120 rows, worst error "), std::string::npos) << outcome.out;
}

TEST(CheckCommand, UrdfFileAlone_Passes) {
  const Outcome outcome =
      run("check '" BURNISH_ROBOTS_DIR "/arm7/arm7.urdf' --tool flange --states 1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST(CheckCommand, CurvedSurfaces_Pass) {
  const Outcome outcome =
      run("check arm7 --surface sphere:0.3 --surface torus:0.1:0.5:hollow --states 1");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* words : {"sphere of radius 0.3 m", "hollow torus of radius 0.1 m along a ring",
                            "pass: all 48 rows, worst error "})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << outcome.out;
  expect_refused(
      run("check arm7 --surface spere:0.3"),
      "surface 'spere:0.3': there is no shape 'spere'; wanted a shape such as sphere:0.3; did you "
      "mean 'sphere'?");
  expect_refused(run("check arm7 --surface sphere:-1"), "its radius is -1 m");
}

TEST(CheckCommand, TooSmallTolerance_FailsWithExitCodeOne) {
  const Outcome outcome = run("check arm7 --states 1 --tolerance 1e-18");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("FAIL: 120 of 120 rows\n"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", finite differences give "), std::string::npos);
}

TEST(CheckCommand, TwoContactsAsArguments_AreCheckedTogether) {
  const Outcome outcome =
      run("check talos --states 2 --json --contact tool=left_sole_link,kp=100,kd=20,error=log6"
          " --contact tool=tool,base=world,name=pad,normal=0,0.2,1,directions=z,rx,ry,kd=50,"
          "acceleration=classical");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["rows"].size(), 1U);
  const Json& row = json["rows"][0];
  EXPECT_EQ(row["reference"], "centered + surface");
  EXPECT_EQ(row["directions"], "x,y,z,rx,ry,rz + z,rx,ry");
  EXPECT_EQ(row["acceleration"], "time_derivative + classical");
  EXPECT_EQ(row["gains"], "kp 100, kd 20 + kd 50");
  EXPECT_EQ(row["error"], "log6 + -");
  EXPECT_TRUE(row["pass"].get<bool>());
  EXPECT_LT(row["worst_error"].get<double>(), 1e-7);
  EXPECT_TRUE(json["pass"].get<bool>());
}

TEST(CheckCommand, TwoBodiesAndAllAccelerations_CheckEveryCombination) {
  const Outcome outcome =
      run("check crane --tool left_tip --base right_tip --all-accelerations --states 1 --json");
  EXPECT_EQ(outcome.exit_code, 0);
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["rows"].size(), 3U * 120U);
  EXPECT_EQ(json["rows"][0]["bodies"], "left_tip on right_tip");
}

}  // namespace
}  // namespace burnish::testing

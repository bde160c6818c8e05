// Tests of the command burnish identify: excitation, simulated records, estimates and refusals.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

TEST(Identify, SimulatedRecord_GivesThePayloadWithinOnePercent) {
  const Scratch scratch;
  const std::string record = quoted(scratch.folder / "record.csv");
  const Outcome simulated = run("identify arm7 --seed 3 --simulate " + record);
  ASSERT_EQ(simulated.exit_code, 0) << simulated.err;
  const std::size_t at = simulated.out.find("carries ");
  ASSERT_NE(at, std::string::npos) << simulated.out;
  const double mass = std::stod(simulated.out.substr(at + 8));

  const std::filesystem::path yaml = scratch.folder / "payload.yaml";
  const Outcome found = run("identify arm7 " + record + " --out " + quoted(yaml));
  EXPECT_EQ(found.exit_code, 0) << found.err;
  for (const char* word : {"mass", "com", "Izz", "+-", "joint_7", "as found"})
    EXPECT_NE(found.out.find(word), std::string::npos) << word << "\n" << found.out;
  const Outcome json = run("identify arm7 " + record + " --json");
  const Json payload = Json::parse(json.out).at("inertias").at(0);
  EXPECT_NEAR(payload.at("values").at(0).get<double>(), mass, 0.01 * mass);
  EXPECT_LE(payload.at("sigma").at(0).get<double>(), 0.01 * mass);

  // The written lines are valid settings of a robot.
  scratch.write("robot.yaml", "urdf: " BURNISH_ROBOTS_DIR
                              "/arm7/arm7.urdf\nframes: {tool: {parent: flange, "
                              "xyz: [0, 0, 0.12], rpy: [0, 0, 0.785398]}}\n" +
                                  contents(yaml));
  const auto total = [](const std::string& robot) {
    return Json::parse(run("show " + robot + " --json").out).at("total_mass").get<double>();
  };
  EXPECT_NEAR(total(quoted(scratch.folder)) - total("arm7"), mass, 0.01 * mass);
}

/// Returns an arm of two joints in a vertical plane. The first joint is continuous. It needs
/// 13.7 Nm to hold the stretched arm at the start.
std::string endless_arm(const Scratch& scratch, const std::string& effort = "90") {
  const auto link = [](const std::string& name, const char* com) {
    return "<link name='" + name + "'><inertial><mass value='2'/><origin xyz='" + com +
           "'/><inertia ixx='.02' iyy='.02' izz='.02' ixy='0' ixz='0' iyz='0'/></inertial></link>";
  };
  return quoted(scratch.write(
      "endless.urdf",
      "<robot name='endless'><link name='base'/>" + link("upper", "0.2 0 0") +
          link("tool", "0.1 0 0") +
          "<joint name='endless' type='continuous'><parent link='base'/><child link='upper'/>"
          "<axis xyz='0 1 0'/><limit effort='" +
          effort +
          "' velocity='3'/></joint><joint name='elbow' type='revolute'><origin xyz='0.4 0 0' "
          "rpy='0.3 0 0'/><parent link='upper'/><child link='tool'/><axis xyz='0 1 0'/><limit "
          "lower='-2' upper='2' effort='60' velocity='3'/></joint></robot>"));
}

TEST(Identify, ContinuousJoint_IsReadAsAnAngleThatWraps) {
  const Scratch scratch;
  const std::string arm = endless_arm(scratch) + " --payload tool ";
  const std::string record = quoted(scratch.folder / "record.csv"),
                    angles = quoted(scratch.folder / "angles.csv"),
                    motion = quoted(scratch.folder / "motion.csv");
  ASSERT_EQ(run("identify " + arm + "--seed 3 --duration 5 --simulate " + record).exit_code, 0);
  // An encoder measures one angle. Its zero is at the start, where the angle wraps.
  shell(
      "awk -F, -v OFS=, 'NR == 1 {for (i = 1; i <= NF; i++) {sub(/ .*/, \"\", $i); at[$i] = i} "
      "print \"time,q_endless,q_elbow,tau_endless,tau_elbow\"} NR > 1 {print $at[\"time\"], "
      "sprintf(\"%.12g\", atan2($at[\"measured_q_endless.sin\"], "
      "$at[\"measured_q_endless.cos\"]) + ($at[\"measured_q_endless.sin\"] < 0 ? 6.283185307179586 "
      ": 0)), $at[\"measured_q_elbow\"], $at[\"tau_measured_endless\"], "
      "$at[\"tau_measured_elbow\"]}' " +
      record + " > " + angles);
  const auto mass = [&](const std::string& file) {
    const Outcome found = run("identify " + arm + file + " --json");
    EXPECT_EQ(found.exit_code, 0) << found.err;
    EXPECT_EQ(found.err.find("wraps"), std::string::npos) << found.err;
    return found.exit_code != 0 ? 0.0
                                : Json::parse(found.out)["inertias"][0]["values"][0].get<double>();
  };
  EXPECT_NEAR(mass(angles), mass(record), 1e-6);

  ASSERT_EQ(run("identify " + arm + "--duration 5 --excite " + motion).exit_code, 0);
  const std::string text = contents(scratch.folder / "motion.csv");
  EXPECT_EQ(text.rfind("time [s],q_endless [rad],q_elbow [rad],v_endless [rad/s]", 0), 0U)
      << text.substr(0, 80);
}

TEST(Identify, ImplausibleRecord_IsRefusedWithoutAFile) {
  const Scratch scratch;
  // The records are of an arm at rest and of an arm with torques in Nmm.
  const std::filesystem::path out = scratch.folder / "payload.yaml";
  std::string still = "time,q_joint_1,tau_joint_1\n";
  for (int i = 0; i < 900; ++i) still += std::to_string(0.004 * i) + ",0.3,2\n";
  scratch.write("still.csv", still);
  scratch.write("arm.urdf",
                "<robot name='arm'><link name='base'/><link name='tool'><inertial><mass value='1'/>"
                "<origin xyz='0.3 0 0'/><inertia ixx='.01' iyy='.01' izz='.01' ixy='0' ixz='0' "
                "iyz='0'/></inertial></link><joint name='joint_1' type='revolute'><parent "
                "link='base'/><child link='tool'/><axis xyz='0 1 0'/><limit lower='-2' upper='2' "
                "effort='50' velocity='3'/></joint></robot>");
  const auto refused = [&](const std::string& robot, const char* record, const char* words) {
    const Outcome outcome = run("identify " + robot + " " + quoted(scratch.folder / record) +
                                " --payload tool --out " + quoted(out));
    expect_refused(outcome, words);
    EXPECT_FALSE(std::filesystem::exists(out));
  };
  refused(quoted(scratch.folder / "arm.urdf"), "still.csv", "at rest");

  ASSERT_EQ(
      run("identify arm7 --seed 3 --duration 5 --simulate " + quoted(scratch.folder / "record.csv"))
          .exit_code,
      0);
  shell(
      "awk -F, -v OFS=, 'NR == 1 {for (i = 1; i <= NF; i++) t[i] = $i ~ /^tau/} NR > 1 {for (i = "
      "1; i <= NF; i++) if (t[i]) $i *= 1000} {print}' " +
      quoted(scratch.folder / "record.csv") + " > " + quoted(scratch.folder / "nmm.csv"));
  refused("arm7", "nmm.csv", "Nmm");
}

TEST(Identify, UnobservablePayload_IsNotWritten) {
  const Scratch scratch;
  const std::filesystem::path out = scratch.folder / "payload.yaml";
  // About a vertical axis gravity has no torque: mass and centre cannot be separated.
  const std::string turning =
      quoted(scratch.write(
          "turn.urdf",
          "<robot name='turn'><link name='base'/><link name='tool'><inertial><mass value='1'/>"
          "<origin xyz='0.3 0 0'/><inertia ixx='.01' iyy='.01' izz='.01' ixy='0' ixz='0' iyz='0'/>"
          "</inertial></link><joint name='joint_1' type='revolute'><parent link='base'/><child "
          "link='tool'/><axis xyz='0 0 1'/><limit lower='-2' upper='2' effort='50' "
          "velocity='3'/></joint></robot>")) +
      " --payload tool ";
  const std::string record = quoted(scratch.folder / "record.csv");
  ASSERT_EQ(run("identify " + turning + "--seed 3 --duration 5 --simulate " + record).exit_code, 0);
  const Outcome found = run("identify " + turning + record + " --out " + quoted(out));
  EXPECT_EQ(found.exit_code, 1) << found.out << found.err;
  EXPECT_EQ(found.out.find("nan"), std::string::npos) << found.out;
  EXPECT_NE(found.err.find("payload.yaml' is not written"), std::string::npos) << found.err;
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Identify, FullDisk_LeavesNoFile) {
  const Scratch scratch;
  ASSERT_EQ(
      run("identify arm7 --seed 3 --duration 5 --simulate " + quoted(scratch.folder / "record.csv"))
          .exit_code,
      0);
  const std::filesystem::path out = scratch.folder / "payload.yaml";
  // No file may grow: writing fails like on a full disk.
  const Outcome found = shell("trap '' XFSZ; ulimit -f 0; '" BURNISH_PROGRAM "' identify arm7 " +
                              quoted(scratch.folder / "record.csv") + " --out " + quoted(out) +
                              " > /dev/null 2> /dev/null");
  EXPECT_EQ(found.exit_code, 2);
  for (const auto& entry : std::filesystem::directory_iterator(scratch.folder))
    EXPECT_EQ(entry.path().filename(), "record.csv");
}

TEST(Identify, Excite_WritesAMotionAtOneKilohertz) {
  const Scratch scratch;
  const std::filesystem::path file = scratch.folder / "motion.csv";
  const Outcome outcome = run("identify arm7 --duration 5 --excite " + quoted(file));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string text = contents(file);
  EXPECT_EQ(lines_of(text), 5002);
  EXPECT_EQ(text.rfind("time [s],q_joint_1 [rad]", 0), 0U) << text.substr(0, 80);
}

TEST(Identify, ArmTooWeakForItsStart_IsRefusedWithoutAFile) {
  const Scratch scratch;
  const std::string weak = endless_arm(scratch, "12") + " --payload tool ";
  for (const char* what : {"--excite ", "--simulate "}) {
    const std::filesystem::path file = scratch.folder / "file.csv";
    const Outcome outcome = run("identify " + weak + what + quoted(file));
    expect_refused(outcome,
                   "joint 'endless' needs 13.734 Nm to hold the start posture, more than its "
                   "effort limit of 12 Nm; wanted another start (--posture)");
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  expect_refused(run("identify " + weak + "--seeds 1"), "joint 'endless' needs 13.734 Nm");
}

TEST(Identify, ArmTooWeakForItsPayload_IsRefusedWithoutARecord) {
  const Scratch scratch;
  // Seed 3 draws a payload of 2.84 kg, which needs another 11 Nm.
  const std::string weak =
      endless_arm(scratch, "17.3") + " --payload tool --duration 5 --range 0.3 --seed 3 ";
  const std::filesystem::path motion = scratch.folder / "motion.csv",
                              record = scratch.folder / "record.csv";
  const Outcome planned = run("identify " + weak + "--excite " + quoted(motion));
  EXPECT_EQ(planned.exit_code, 0);
  EXPECT_EQ(planned.err.rfind("burnish: the motion is reduced to ", 0), 0U) << planned.err;
  const auto expect_fall = [](const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    const std::size_t at = outcome.err.find("the simulated arm cannot follow the motion: joint ");
    ASSERT_NE(at, std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("'endless' leaves the planned motion at ", at), std::string::npos);
    EXPECT_NE(outcome.err.find("effort limit of 17.3 Nm", at), std::string::npos) << outcome.err;
  };
  expect_fall(run("identify " + weak + "--simulate " + quoted(record)));
  EXPECT_FALSE(std::filesystem::exists(record));
  const Outcome tried = run("identify " + weak + "--first-seed 3 --seeds 1");
  expect_fall(tried);
  EXPECT_NE(tried.err.find("burnish: seed 3: "), std::string::npos) << tried.err;
}

TEST(Identify, BadInput_IsRefusedInOneSentence) {
  const Scratch scratch;
  const auto refused = [](const std::string& arguments, const std::string& word) {
    const Outcome outcome = run("identify " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_EQ(lines_of(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  };
  scratch.write("short.csv", "time,q_joint_1\n0,0\n0.001,0\n0.002,0\n");
  refused("arm7", "wanted DATA");
  refused("arm7 " + quoted(scratch.folder / "short.csv"), "q_joint_2");
  refused("arm7 --payload tol --excite /dev/null", "'tool'");
  refused("arm7:floating --excite /dev/null", "free-flyer");
  refused("arm7 --duration 1 --excite /dev/null", "duration");
}

}  // namespace
}  // namespace burnish::testing

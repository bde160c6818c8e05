// Standing and swaying of the quadruped, Talos and user descriptions in MuJoCo, and the task file.
#include "burnish/tasks/stand/stand.hpp"

#include <gtest/gtest.h>

#include "biped.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_posture.hpp"
#include "stand/descriptions.hpp"
#include "stand/swaying.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::stand {
namespace {

using testing::expect_words;
using testing::refusal;

const std::string shipped = BURNISH_TASKS_DIR "/stand/quadruped.yaml";
const std::string quadruped = BURNISH_ROBOTS_DIR "/quadruped";

/// Shipped task with its model errors, shortened.
Task short_task(const std::string& robot = quadruped, std::vector<std::string> overrides = {}) {
  const std::vector<std::string> always{"robot=" + robot,
                                        "standing.settle=0.3",
                                        "phases.settle_duration=0.1",
                                        "phases.sway_duration=1.8",
                                        "phases.rest_duration=0.2",
                                        "sway.rise=0.8",
                                        "sway.shift_rate=[0.7,0.5,0.7]",
                                        "sway.turn_rate=[0.7,0.5,0.7]",
                                        "disturbances.seed=5"};
  overrides.insert(overrides.begin(), always.begin(), always.end());
  return read_task(shipped, overrides);
}

/// Returns all notes in one string.
std::string notes_text(const Task& task, const Setting& setting) {
  std::string text;
  for (const std::string& note : setting_notes(task, setting)) text += note + "; ";
  return text;
}

RunResult run(const Task& task) { return run_task({.task = task, .plan_rate = 0.0}); }

class Stand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_mujoco()) GTEST_SKIP() << "without MuJoCo there are no feet to stand on";
  }
};

/// Expects a run that stood and swayed accurately, with an estimated (not measured) base.
void expect_swayed(const RunResult& result) {
  EXPECT_TRUE(result.succeeded) << result.outcome;
  EXPECT_FALSE(result.fell);
  ASSERT_TRUE(result.sway && result.standing) << result.outcome;
  EXPECT_GT(result.standing->com_moved, 0.02) << "the robot does not sway";
  EXPECT_LT(result.sway->com_rmse, 3e-3);
  EXPECT_LT(result.sway->turn_rmse, 0.012);
  EXPECT_GT(result.sway->position_estimate_rmse, 1e-5);
  EXPECT_LT(result.sway->position_estimate_rmse, 3e-3);
  EXPECT_LT(result.sway->orientation_estimate_rmse, 0.012);
  EXPECT_LT(result.sway->foot_slip, 3e-3);
  EXPECT_LT(result.sway->com_end, 3e-3) << "the robot does not return to its start";
  EXPECT_EQ(result.trace.column("phase")[result.trace.rows() - 1], 2.0);
}

TEST_F(Stand, QuadrupedWithOrWithoutForceSensors_Sways) {
  const RunResult with = run(short_task());
  expect_swayed(with);
  EXPECT_GT(with.standing->min_load, 12.0);
  const RunResult without = run(short_task(quadruped, {"standing.force_sensors=false"}));
  expect_swayed(without);
  EXPECT_NE(with.sway->com_rmse, without.sway->com_rmse)
      << "the run without force sensors uses them";
}

TEST_F(Stand, TalosOnSoles_Sways) {
  Task task = read_task(
      BURNISH_TASKS_DIR "/stand/talos.yaml",
      {std::string("robot=") + BURNISH_ROBOTS_DIR "/talos", "standing.settle=0.3",
       "phases.settle_duration=0.1", "phases.sway_duration=1.6", "phases.rest_duration=0.1",
       "sway.rise=0.7", "sway.shift_rate=[0.6,0.5,0.6]", "controller.update_rate=100",
       "controller.solver_delay=0.01", "controller.knots=20"});
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.sway);
  EXPECT_GT(result.standing->com_moved, 0.015);
  EXPECT_LT(result.sway->com_rmse, 3e-3);
  EXPECT_LT(result.sway->position_estimate_rmse, 2e-3);
}

TEST_F(Stand, PushAtTheTrunk_KeepsStanding) {
  Task task = short_task();
  task.disturbances.pushes = {{0.9, 0.2, Eigen::Vector3d(20.0, 60.0, 0.0)}};
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.sway);
  EXPECT_LT(result.sway->com_peak, 0.02);
  EXPECT_NE(result.trace.column("push_y_world").maxCoeff(), 0.0);
}

TEST_F(Stand, FootLiftsAndNoSway_OutcomeReportsBoth) {
  Task task = short_task();
  task.disturbances.pushes = {{0.9, 0.1, Eigen::Vector3d(0.0, 90.0, 0.0)}};
  Setting setting = make_setting(task);
  setting.sway.shift.setZero();
  setting.sway.turn.setZero();
  const RunResult result = run_task({.task = task, .setting = setting, .plan_rate = 0.0});
  EXPECT_TRUE(result.succeeded) << result.outcome;
  expect_words(result.outcome,
               {"stood: ", "; a foot lost contact", "; no direction of the sway was possible"});
}

TEST_F(Stand, HardPushOrSlipLimit_OutcomeReportsWhetherItFell) {
  Task task = short_task();
  task.disturbances.pushes = {{0.9, 0.4, Eigen::Vector3d(0.0, 400.0, 0.0)}};
  const RunResult fallen = run(task);
  EXPECT_FALSE(fallen.succeeded);
  EXPECT_TRUE(fallen.fell) << fallen.outcome;
  EXPECT_EQ(fallen.fault.kind, FaultKind::Watched);
  expect_words(fallen.outcome, {"beyond a limit", "slip of foot '", "; the robot fell"});
  task.disturbances.pushes.clear();
  task.slip = 1e-5;
  const RunResult stopped = run(task);
  EXPECT_FALSE(stopped.succeeded || stopped.fell);
  expect_words(stopped.outcome, {"slip of foot '", "; the robot stands"});
}

TEST_F(Stand, UserDescription_StandsAndSways) {
  std::string text = testing::contents(quadruped + "/quadruped.urdf");
  std::string feet;
  for (const std::string leg : {"fl", "fr", "rl", "rr"})
    feet += "<link name=\"" + leg + "_toe\"/><joint name=\"" + leg +
            "_ankle\" type=\"fixed\"><parent link=\"" + leg + "_shank_link\"/><child link=\"" +
            leg + "_toe\"/><origin xyz=\"0 0 -0.22\"/></joint>";
  text.insert(text.rfind("</robot>"), feet);
  const testing::Scratch scratch;
  const std::string file = scratch.write("mine.urdf", text).string();
  expect_words(
      refusal([&] {
        make_setting(short_task(file, {"standing.feet=[fl_toe, fr_foot, rl_toe, rr_toe]"}));
      }),
      {"standing.feet: frame 'fr_foot' does not exist on robot"});
  const Task task = short_task(file, {"standing.feet=[fl_toe, fr_toe, rl_toe, rr_toe]"});
  const Setting setting = make_setting(task);
  EXPECT_EQ(make_setting(task).q_start, setting.q_start) << "two searches give different postures";
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const TouchSpec& foot : setting.scene.supports()) middle += 0.25 * foot.surface.point;
  EXPECT_LT((setting.com - middle).head<2>().norm(), 2e-4);
  // The base is at 80 % of the length of straight legs.
  EXPECT_NEAR(setting.p_base.z() - middle.z(), 0.8 * 0.44, 0.03);
  expect_swayed(run(task));
}

TEST(StandRobot, AnotherRobot_FindsFeetAndPostureWithNotes) {
  const Task task = read_task(BURNISH_TASKS_DIR "/stand/talos.yaml", {"robot=" + quadruped});
  const Setting setting = make_setting(task, load_task_robot(task));
  EXPECT_EQ(setting.standing.feet,
            (std::vector<std::string>{"fl_foot", "fr_foot", "rl_foot", "rr_foot"}));
  EXPECT_FALSE(setting.standing.has_soles());
  expect_words(
      notes_text(task, setting),
      {"standing.feet: 'left_sole_link' and the other feet are not frames of robot 'quadruped'",
       "fl_foot, fr_foot, rl_foot, rr_foot (found), point feet of radius 0.018 m",
       "posture: robot 'quadruped' does not have the posture 'standing_board'"});
  const Task auto_task = short_task(BURNISH_ROBOTS_DIR "/talos", {"standing.feet=auto"});
  const Setting found = make_setting(auto_task);
  EXPECT_EQ(found.standing.feet, (std::vector<std::string>{"left_sole_link", "right_sole_link"}));
  EXPECT_NEAR(found.scene.touches.front().half_x, 0.105, 1e-9);
  expect_words(notes_text(auto_task, found), {"feet: left_sole_link", "soles of 0.21 x 0.13 m"});
  EXPECT_EQ(auto_task.standing.feet, std::vector<std::string>{"auto"});
  EXPECT_NE(task_text(auto_task).find("  feet: auto\n"), std::string::npos);
  expect_words(
      refusal([] { make_setting(short_task(BURNISH_ROBOTS_DIR "/arm7", {"standing.feet=auto"})); }),
      {"standing.feet: no feet were found on robot 'arm7': "});
  expect_words(
      refusal([] { make_setting(short_task(quadruped, {"standing.feet=[fl_foot, rr_foot]"})); }),
      {"cannot stand still on 2 point feet", "at least three, or soles"});
}

/// Robot of 2.5 kg with effort limits of 1000 Nm, from a file that is not part of burnish.
TEST_F(Stand, LightRobotSolo12_StandsAndSways) {
  const std::string file = std::string(BURNISH_SHARED_DIR) + "/robots/solo12.urdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const std::string feet = "standing.feet=[FL_FOOT, FR_FOOT, HL_FOOT, HR_FOOT]";
  Task task = short_task(file, {feet});
  task.standing.min_load = 12.0;
  // Left and right feet carry equal loads, so rounding decides which foot the message names.
  expect_words(refusal([&] { run(task); }),
               {"posture: the robot, which weighs 24.525 N, cannot stand at the start",
                "violating the plans' constraint 'load of ", "_FOOT', which must be at least 12 N",
                "standing.min_load"});
  task.standing.min_load = std::nullopt;
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  EXPECT_LT(result.sway->com_rmse, 5e-3);
}

TEST(StandTrunk, SwayPath_StartsAndEndsAtRest) {
  Task task = short_task();
  const Setting setting = make_setting(task);
  const double begin = task.settle_duration, end = begin + task.sway_duration;
  for (const double time : {0.0, begin, end, end + 1.0}) {
    const Trunk still = trunk_at(task, setting, time);
    EXPECT_LT((still.com - setting.com).norm(), 1e-12);
    EXPECT_LT((still.base - setting.R_base).norm(), 1e-12);
    EXPECT_LT(still.com_velocity.norm(), 1e-6);
  }
  constexpr double h = 1e-3;
  const double time = begin + 0.6;
  const Trunk at = trunk_at(task, setting, time);
  const Eigen::Vector3d rate =
      (trunk_at(task, setting, time + h).com - trunk_at(task, setting, time - h).com) / (2.0 * h);
  EXPECT_GT(rate.norm(), 0.01);
  EXPECT_LT((rate - at.com_velocity).norm(), 1e-4 * rate.norm());
}

TEST(StandTrunk, RotatedBase_SwaysAlongItsHeading) {
  Task task = short_task();
  task.sway.turn.setZero();
  task.sway.shift = {0.03, 0.0, 0.0};
  Robot robot = load_task_robot(task);
  Posture& posture = robot.postures.at("standing");
  posture.at("root_joint") = {0.0, 0.0, 0.32455, 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};
  const Setting setting = make_setting(task, robot);
  const Trunk at = trunk_at(task, setting, task.settle_duration + 0.7);
  const Eigen::Vector3d displacement = at.com - setting.com;
  EXPECT_LT(std::abs(displacement.x()), 1e-12) << "the robot faces along y";
  EXPECT_GT(std::abs(displacement.y()), 1e-3);
}

TEST(StandTrunk, SwayBeyondTheFeetWithoutFit_IsRefused) {
  const auto refused = [](const std::vector<std::string>& overrides) {
    const Task task = short_task(quadruped, overrides);
    return refusal([&] { refuse_out_of_reach(task, make_setting(task)); });
  };
  EXPECT_EQ(refused({}), "");
  expect_words(refused({"sway.shift=[0, 0.2, 0]", "sway.fit=false"}),
               {"sway: the robot", "cannot stand", "s into the sway", "load of r"});
  expect_words(refused({"sway.turn=[0, 0, 0.9]", "sway.fit=false"}),
               {"sway: no posture on these feet"});
  expect_words(refused({"standing.min_load=60"}),
               {"posture: the robot, which weighs 196.2 N, cannot stand at the start", "60 N"});
  expect_words(refused({"constraints.torque=0.1"}), {"posture: ", "torque limits/"});
  // Legs that cannot crouch that far crouch as low as possible, and a note gives the value.
  const Task low = short_task(quadruped, {"posture=search", "crouch=0.99"});
  expect_words(notes_text(low, make_setting(low)), {"crouch: ", " is used in place of 0.99"});
}

TEST(StandTrunk, SwayBeyondTheFeet_IsReducedWithANote) {
  const Task task = short_task(quadruped, {"sway.shift=[0.02, 0.2, 0]"});
  const Setting setting = make_setting(task);
  EXPECT_EQ(refusal([&] { refuse_out_of_reach(task, setting); }), "");
  EXPECT_GT(setting.sway.shift.y(), 0.01);
  EXPECT_LT(setting.sway.shift.y(), 0.05);
  expect_words(notes_text(task, setting),
               {"sway: amplitudes are reduced", "y ", " in place of 0.2 m"});
  const Task shipped_one = short_task();
  EXPECT_EQ(notes_text(shipped_one, make_setting(shipped_one)), "");
}

Task biped_task(const std::string& file, double size, std::vector<std::string> overrides = {}) {
  const std::vector<std::string> always{"robot=" + file,
                                        "standing.feet=[l_sole, r_sole]",
                                        "posture=search",
                                        "standing.half_x=" + std::to_string(0.1 * size),
                                        "standing.half_y=" + std::to_string(0.065 * size),
                                        "standing.settle=0.3",
                                        "phases.settle_duration=0.1",
                                        "phases.sway_duration=1.6",
                                        "phases.rest_duration=0.1",
                                        "sway.rise=0.7",
                                        "controller.update_rate=100",
                                        "controller.solver_delay=0.01",
                                        "controller.knots=20"};
  overrides.insert(overrides.begin(), always.begin(), always.end());
  return read_task(BURNISH_TASKS_DIR "/stand/talos.yaml", overrides);
}

TEST(StandPosture, SolesTiltedAtZero_AreLevelled) {
  const testing::Scratch scratch;
  Robot robot = pressing::load_floating(scratch.write("biped.urdf", biped(1.0)).string());
  Standing standing;
  for (const std::string sole : {"l_sole", "r_sole"}) {
    Frame tilted = robot.model.frames[static_cast<std::size_t>(robot.model.frame_index(sole))];
    tilted.name = sole + "_tilted";
    tilted.placement.rotate(Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitY()));
    robot.model.frames.push_back(tilted);
    standing.feet.push_back(tilted.name);
  }
  const Model& model = robot.model;
  const Eigen::VectorXd q = pressing::crouched_posture(model, standing, model.q_neutral, 0.1);
  for (const std::string& foot : standing.feet)
    EXPECT_GT(frame_placement(model, q, foot).linear()(2, 2), 1.0 - 1e-7) << foot;
}

TEST_F(Stand, LegsWithoutAnkleRoll_SwaysInPossibleDirections) {
  const testing::Scratch scratch;
  const Task task = biped_task(scratch.write("biped.urdf", biped(1.0)).string(), 1.0);
  const Setting setting = make_setting(task);
  EXPECT_EQ(setting.sway.shift.y(), 0.0);
  EXPECT_EQ(setting.sway.turn.x(), 0.0);
  EXPECT_EQ(setting.sway.turn.z(), 0.0);
  EXPECT_GT(setting.sway.shift.x(), 0.01);
  EXPECT_GT(setting.sway.turn.y(), 0.01);
  expect_words(notes_text(task, setting),
               {"sway: y, roll and yaw are omitted",
                "turning about z of 'r_sole' depends on the other directions of the feet"});
  // Eleven of the twelve directions are independent.
  int constrained = 0;
  for (const ContactSpec& foot : make_mpc(task, setting).problem.contacts)
    constrained += foot.directions.count();
  EXPECT_EQ(constrained, 11);
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.sway);
  EXPECT_LT(result.sway->com_rmse, 3e-3);
}

TEST_F(Stand, BipedsFrom1To175Kg_StandWithOneFile) {
  const testing::Scratch scratch;
  for (const double size : {0.274, 0.5, 1.53}) {  // 1 kg, 6 kg and 175 kg
    const RunResult result = run(biped_task(
        scratch.write("biped.urdf", biped(size)).string(), size,
        {"controller.update_rate=200", "controller.solver_delay=0.005", "controller.knots=30",
         "sway.rise=1.6", "phases.sway_duration=3.4", "sway.shift_rate=[0.3, 0.25, 0.4]"}));
    EXPECT_TRUE(result.succeeded) << size << ": " << result.outcome;
  }
}

TEST_F(Stand, LightBase_StandsFromTheStart) {
  const testing::Scratch scratch;
  // Pelvis of 0.3 kg, with the mass in a trunk above it.
  std::string text = biped(1.0,
                           "<link name='trunk'><inertial><origin xyz='0 0 0.2'/><mass value='25'/>"
                           "<inertia ixx='0.7' ixy='0' ixz='0' iyy='0.7' iyz='0' izz='0.7'/>"
                           "</inertial></link><joint name='waist' type='revolute'><parent "
                           "link='pelvis'/><child link='trunk'/><axis xyz='0 0 1'/><limit "
                           "lower='-1' upper='1' effort='200' velocity='20'/></joint>");
  const std::size_t mass = text.find("<mass value='25.0");
  text.replace(mass, text.find("/>", mass) - mass, "<mass value='0.3'");
  const std::size_t inertia = text.find("<inertia ", mass);
  text.replace(inertia, text.find("/>", inertia) - inertia,
               "<inertia ixx='1e-3' ixy='0' ixz='0' iyy='1e-3' iyz='0' izz='1e-3'");
  const Task task =
      biped_task(scratch.write("biped.urdf", text).string(), 1.0, {"phases.sway_duration=1.4"});
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
}

/// Soles 5 cm wide under a robot of 60 kg with a waist joint.
TEST_F(Stand, NarrowSoles_StandsWithoutTipping) {
  const testing::Scratch scratch;
  const std::string waist =
      "<link name='trunk'><inertial><origin xyz='0 0 0.3'/><mass value='20'/><inertia ixx='0.7' "
      "ixy='0' ixz='0' iyy='0.7' iyz='0' izz='0.3'/></inertial></link><joint name='waist' "
      "type='revolute'><parent link='pelvis'/><child link='trunk'/><axis xyz='1 0 0'/><limit "
      "lower='-0.5' upper='0.5' effort='200' velocity='20'/></joint>";
  Task task = biped_task(scratch.write("biped.urdf", biped(1.0, waist)).string(), 1.0,
                         {"standing.half_x=0.08", "standing.half_y=0.025"});
  const Setting setting = make_setting(task);
  const Joint& joint =
      setting.robot.model
          .joints[static_cast<std::size_t>(setting.robot.model.joint_index("waist"))];
  EXPECT_LT(std::abs(setting.q_start[joint.q_index]), 1e-3) << "the trunk inclines without need";
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
}

TEST(StandRobot, LegsThatReachNoPosture_RefusalNamesJointsAtTheirLimits) {
  const testing::Scratch scratch;
  std::string text = biped(1.0);
  for (std::size_t at = text.find("_ankle' type"); at != std::string::npos;
       at = text.find("_ankle' type", at + 1)) {
    const std::size_t lower = text.find("lower='-1.0", at);
    text.replace(lower, text.find("' upper", lower) - lower, "lower='0.6");
  }
  const Task task = biped_task(scratch.write("biped.urdf", text).string(), 1.0);
  expect_words(
      refusal([&] { make_setting(task); }),
      {"posture: no posture was found", "ended at the limits of the joints '", "'l_ankle'"});
}

TEST(StandRobot, DescriptionWithoutPostures_SearchesOneWithANote) {
  const testing::Scratch scratch;
  Task task = biped_task(scratch.write("biped.urdf", biped(1.0)).string(), 1.0);
  task.posture = "standing_board";
  expect_words(notes_text(task, make_setting(task)),
               {"posture: robot 'biped' does not have the posture 'standing_board'; a posture "
                "found by search replaces it"});
}

TEST(StandRobot, GroundTooStiff_NoteProposesAStiffness) {
  const Task stiff = short_task(quadruped, {"standing.stiffness=1e7"});
  expect_words(notes_text(stiff, make_setting(stiff)),
               {"standing.stiffness: 1e+07 N/m is 50 times", "auto: 200000 N/m"});
  const Task usual = short_task(quadruped, {"standing.stiffness=4e5"});
  EXPECT_EQ(notes_text(usual, make_setting(usual)), "");
}

TEST(StandRobot, AnkleLimitsBlockTheCrouch_CrouchesLess) {
  const testing::Scratch scratch;
  std::string text = biped(1.0);
  for (const std::string side : {"l", "r"}) {
    const std::size_t at = text.find("lower='-1.0", text.find(side + "_ankle"));
    text.replace(at, text.find("' upper", at) - at, "lower='-0.45");
  }
  const Task task = biped_task(scratch.write("biped.urdf", text).string(), 1.0);
  const Setting setting = make_setting(task);
  const Joint& ankle =
      setting.robot.model
          .joints[static_cast<std::size_t>(setting.robot.model.joint_index("l_ankle"))];
  EXPECT_LT(setting.q_start[ankle.q_index], -0.1);
  EXPECT_GT(setting.q_start[ankle.q_index], -0.45);
}

TEST(StandRobot, VeryLightLink_IsLockedUnlessGeared) {
  const testing::Scratch scratch;
  const auto finger = [](const std::string& dynamics) {
    return "<link name='finger'><inertial><origin xyz='0 0 0.01'/><mass value='0.01'/><inertia "
           "ixx='1e-6' ixy='0' ixz='0' iyy='1e-6' iyz='0' izz='1e-6'/></inertial></link><joint "
           "name='finger_joint' type='revolute'><parent link='pelvis'/><child link='finger'/>"
           "<axis xyz='1 0 0'/><limit lower='-1' upper='1' effort='1' velocity='10'/>" +
           dynamics + "</joint>";
  };
  const Robot light = load_task_robot(
      biped_task(scratch.write("light.urdf", biped(1.0, finger(""))).string(), 1.0));
  EXPECT_EQ(light.model.nv, 16);
  ASSERT_EQ(light.notes.size(), 1U);
  expect_words(light.notes.front(), {"locked: joint 'finger_joint'", "armature"});
  const Robot geared = load_task_robot(biped_task(
      scratch.write("geared.urdf", biped(1.0, finger("<dynamics armature='0.01'/>"))).string(),
      1.0));
  EXPECT_EQ(geared.model.nv, 17);
  EXPECT_TRUE(geared.notes.empty());
}

TEST(StandRobot, StronglyDampedGround_ReducesFallbackDamping) {
  const testing::Scratch scratch;
  const auto damping = [&](double size, const std::vector<std::string>& overrides) {
    const Task task =
        biped_task(scratch.write("biped.urdf", biped(size)).string(), size, overrides);
    const Setting setting = make_setting(task);
    return make_mpc(task, setting).fallback.damping;
  };
  EXPECT_EQ(damping(1.0, {}), 15.0);
  // Soft, strongly damped ground.
  EXPECT_LT(damping(1.0, {"standing.stiffness=1e5", "standing.damping=5e3"}), 15.0);
}

TEST(StandFile, WrittenTask_ReadsBackUnchanged) {
  EXPECT_EQ(testing::contents(shipped), task_text(read_task(shipped)))
      << "burnish run tasks/stand/quadruped.yaml --write-task FILE updates it";
  Task task = read_task(shipped);
  task.posture = "search";
  task.standing.feet = {"a foot", "another: #2"};
  task.tilt = range::end;
  task.sway.turn = {0.0, -0.1, 0.2};
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.sway.turn, task.sway.turn);
}

TEST(StandFile, InvalidFile_RefusalNamesTheLine) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto parsed = files::parse_said<Task>(text, "my.yaml", overrides);
      files::placed(parsed.texts, [&] {
        check_task(parsed.spec);
        refuse_out_of_reach(parsed.spec, make_setting(parsed.spec));
      });
    });
  };
  const std::string head = "task: stand\nrobot: " + quadruped + "\n";
  EXPECT_EQ(refused(head), "");
  expect_words(refused("task: stend\n"), {"my.yaml: line 1: task", "stand"});
  expect_words(refused(head + "sways: 3\n"), {"line 3", "sways", "sway"});
  expect_words(refused(head + "sway: {shift: 3}\n"), {"line 3: sway.shift"});
  expect_words(refused(head + "sway: {rise: 5}\n"),
               {"line 3: sway.rise: it is 5 s", "wanted at most"});
  expect_words(refused(head + "crouch: 1\n"), {"line 3: crouch"});
  expect_words(refused(head + "standing: {feet: []}\n"),
               {"line 3: standing.feet: no feet are stated"});
  expect_words(refused(head + "standing: {feet: [fl_foot, fr_fot, rl_foot, rr_foot]}\n"),
               {"line 3: standing.feet", "'fr_fot'", "did you mean 'fr_foot'?"});
  expect_words(refused(head + "standing: {half_x: 0.1}\n"),
               {"standing.half_x: half_x and half_y are 0.1 and 0 m"});
  expect_words(
      refused(head + "standing: {half_x: 0.1, half_y: 0.1}\n"),
      {"standing.feet: the sole of", "is not level at the start", "degrees off the vertical"});
  expect_words(refused(head + "sway: {shift: [0, 0.2, 0], fit: false}\n"),
               {"line 3: sway: ", "violating the plans' constraint"});
  expect_words(refused(head + "posture: standin\n"), {"line 3: posture", "'standing'"});
  expect_words(refused(head + "controller: {update_rate: 300}\n"),
               {"line 3: controller.update_rate: it is 300 Hz"});
  expect_words(refused(head + "controller: {solver_delay: 0.02}\n"),
               {"line 3: controller.solver_delay"});
  expect_words(refused(head + "controller: {knots: 300}\n"), {"line 3: controller.knots"});
  expect_words(refused(head + "controller: {step: 0.1, knots: 5}\n"),
               {"line 3: controller.step", "standing.contact_kd is 20", "below 0.1 s"});
  expect_words(refused(head + "phases: {rest_duration: 1e5}\n"),
               {"line 3: phases.rest_duration: it takes"});
  expect_words(refused("task: stand\nrobot: quadrupd\n"), {"line 2: robot", "quadruped"});
  expect_words(refused(head, {"disturbances=sensor"}), {"override 'disturbances=sensor'"});
}

TEST_F(Stand, ProgressReturnsFalse_InterruptsTheRun) {
  RunSpec spec{.task = short_task()};
  spec.progress = [](double time, double end) { return time < 0.6 && end > 1.9; };
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.succeeded);
  EXPECT_TRUE(result.interrupted);
  expect_words(result.outcome, {"interrupted at 0.6", "in phase sway"});
}

}  // namespace
}  // namespace burnish::stand

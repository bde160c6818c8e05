// Standing and swaying: the quadruped, Talos and a description of one's own in MuJoCo, and the
// file.
#include "burnish/tasks/stand/stand.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
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

/// The shipped one, which the controller does not know all about, over soon.
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

RunResult run(const Task& task) { return run_task({.task = task, .plan_rate = 0.0}); }

class Stand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_mujoco()) GTEST_SKIP() << "without MuJoCo there are no feet to stand on";
  }
};

/// On its feet, on its way, and its base is no known one.
void expect_swayed(const RunResult& result) {
  EXPECT_TRUE(result.done) << result.outcome;
  EXPECT_FALSE(result.fell);
  ASSERT_TRUE(result.sway && result.standing) << result.outcome;
  EXPECT_GT(result.standing->com_moved, 0.02) << "it does not sway";
  EXPECT_LT(result.sway->com_rmse, 3e-3);
  EXPECT_LT(result.sway->turn_rmse, 0.012);
  EXPECT_GT(result.sway->believed_place, 1e-5);
  EXPECT_LT(result.sway->believed_place, 3e-3);
  EXPECT_LT(result.sway->believed_turn, 0.012);
  EXPECT_LT(result.sway->foot_slip, 3e-3);
  EXPECT_LT(result.sway->com_end, 3e-3) << "it does not come back";
  EXPECT_EQ(result.trace.column("phase")[result.trace.rows() - 1], 2.0);
}

TEST_F(Stand, the_quadruped_sways_with_and_without_force_sensors_in_its_feet) {
  const RunResult with = run(short_task());
  expect_swayed(with);
  EXPECT_GT(with.standing->least_load, 12.0);
  const RunResult without = run(short_task(quadruped, {"standing.force_sensors=false"}));
  expect_swayed(without);
  EXPECT_NE(with.sway->com_rmse, without.sway->com_rmse) << "sensors that it has not are used";
}

TEST_F(Stand, talos_sways_on_its_soles) {
  Task task = read_task(
      BURNISH_TASKS_DIR "/stand/talos.yaml",
      {std::string("robot=") + BURNISH_ROBOTS_DIR "/talos", "standing.settle=0.3",
       "phases.settle_duration=0.1", "phases.sway_duration=1.6", "phases.rest_duration=0.1",
       "sway.rise=0.7", "sway.shift_rate=[0.6,0.5,0.6]", "controller.update_rate=100",
       "controller.solver_delay=0.01", "controller.knots=20"});
  const RunResult result = run(task);
  EXPECT_TRUE(result.done) << result.outcome;
  ASSERT_TRUE(result.sway);
  EXPECT_GT(result.standing->com_moved, 0.015);
  EXPECT_LT(result.sway->com_rmse, 3e-3);
  EXPECT_LT(result.sway->believed_place, 2e-3);
}

TEST_F(Stand, survives_a_push_at_its_trunk) {
  Task task = short_task();
  task.disturbances.pushes = {{0.9, 0.2, Eigen::Vector3d(20.0, 60.0, 0.0)}};
  const RunResult result = run(task);
  EXPECT_TRUE(result.done) << result.outcome;
  ASSERT_TRUE(result.sway);
  EXPECT_LT(result.sway->com_peak, 0.02);
  EXPECT_NE(result.trace.column("push_y_world").maxCoeff(), 0.0);
}

TEST_F(Stand, says_whether_it_fell) {
  Task task = short_task();
  task.disturbances.pushes = {{0.9, 0.4, Eigen::Vector3d(0.0, 400.0, 0.0)}};
  const RunResult fallen = run(task);
  EXPECT_FALSE(fallen.done);
  EXPECT_TRUE(fallen.fell) << fallen.outcome;
  EXPECT_EQ(fallen.fault.kind, FaultKind::Watched);
  expect_words(fallen.outcome, {"beyond a limit", "slip of foot '", "; it fell"});
  task.disturbances.pushes.clear();
  task.slip = 1e-5;
  const RunResult stopped = run(task);
  EXPECT_FALSE(stopped.done || stopped.fell);
  expect_words(stopped.outcome, {"slip of foot '", "; it stands"});
}

TEST_F(Stand, stands_on_a_description_of_ones_own) {
  std::string text = testing::contents(quadruped + "/quadruped.urdf");
  std::string feet;
  for (const std::string leg : {"fl", "fr", "rl", "rr"})
    feet += "<link name=\"" + leg + "_toe\"/><joint name=\"" + leg +
            "_ankle\" type=\"fixed\"><parent link=\"" + leg + "_shank_link\"/><child link=\"" +
            leg + "_toe\"/><origin xyz=\"0 0 -0.22\"/></joint>";
  text.insert(text.rfind("</robot>"), feet);
  const testing::Scratch scratch;
  const std::string file = scratch.write("mine.urdf", text).string();
  expect_words(refusal([&] { make_setting(short_task(file)); }),
               {"standing.feet: frame 'fl_foot' is none of robot", "fl_toe"});
  const Task task = short_task(file, {"standing.feet=[fl_toe, fr_toe, rl_toe, rr_toe]"});
  const Setting setting = make_setting(task);
  EXPECT_EQ(make_setting(task).q_start, setting.q_start) << "the same every time";
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SupportSpec& foot : setting.scene.supports) middle += 0.25 * foot.point;
  EXPECT_LT((setting.com - middle).head<2>().norm(), 2e-4);
  EXPECT_NEAR(setting.p_base.z() - middle.z(), 0.8 * 0.44, 0.03);  // of straight legs
  expect_swayed(run(task));
}

/// A robot from elsewhere, where it is at hand: 2.5 kg, with limits of 1000 Nm.
TEST_F(Stand, stands_on_a_small_robot_from_elsewhere) {
  const std::string file = std::string(BURNISH_SHARED_DIR) + "/robots/solo12.urdf";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const std::string feet = "standing.feet=[FL_FOOT, FR_FOOT, HL_FOOT, HR_FOOT]";
  Task task = short_task(file, {feet});
  // Left and right bear the same: which one comes first is rounding.
  expect_words(refusal([&] { run(task); }),
               {"posture: the robot, which weighs 24.525 N, cannot stand at the start",
                "in the way is the load of ", "_FOOT, 12 N", "standing.least_load"});
  task.standing.least_load = 1.0;
  const RunResult result = run(task);
  EXPECT_TRUE(result.done) << result.outcome;
  EXPECT_LT(result.sway->com_rmse, 5e-3);
}

TEST(StandTrunk, sways_from_where_it_starts_to_there_again) {
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

TEST(StandTrunk, goes_along_the_heading_of_the_base) {
  Task task = short_task();
  task.sway.turn.setZero();
  task.sway.shift = {0.03, 0.0, 0.0};
  Robot robot = load_task_robot(task);
  Posture& posture = robot.postures.at("standing");
  posture.at("root_joint") = {0.0, 0.0, 0.32455, 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5)};
  const Setting setting = make_setting(task, robot);
  const Trunk at = trunk_at(task, setting, task.settle_duration + 0.7);
  const Eigen::Vector3d way = at.com - setting.com;
  EXPECT_LT(std::abs(way.x()), 1e-12) << "it looks along y";
  EXPECT_GT(std::abs(way.y()), 1e-3);
}

TEST(StandTrunk, is_refused_where_feet_do_not_bear_it) {
  const auto refused = [](const std::vector<std::string>& overrides) {
    const Task task = short_task(quadruped, overrides);
    return refusal([&] { refuse_out_of_reach(task, make_setting(task)); });
  };
  EXPECT_EQ(refused({}), "");
  expect_words(refused({"sway.shift=[0, 0.2, 0]"}),
               {"sway: the robot", "cannot stand", "s into its sway", "load of r"});
  expect_words(refused({"sway.turn=[0, 0, 0.9]"}), {"sway: no posture on these feet"});
  expect_words(refused({"standing.least_load=60"}),
               {"posture: the robot, which weighs 196.2 N, cannot stand at the start", "60 N"});
  expect_words(refused({"constraints.torque=0.1"}), {"posture: ", "torque limits/"});
  expect_words(refused({"posture=search", "crouch=0.99"}), {"posture: no posture was found"});
}

TEST(StandFile, writes_a_file_that_reads_back_with_every_key_explained) {
  EXPECT_EQ(testing::contents(shipped), task_text(read_task(shipped)))
      << "burnish run tasks/stand/quadruped.yaml --write-task FILE mends it";
  Task task = read_task(shipped);
  task.posture = "search";
  task.standing.feet = {"a foot", "another: #2"};
  task.tilt = range::end;
  task.sway.turn = {0.0, -0.1, 0.2};
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.sway.turn, task.sway.turn);
}

TEST(StandFile, refuses_what_it_cannot_read_or_do_where_the_file_says_it) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto said = files::parse_said<Task>(text, "my.yaml", overrides);
      files::placed(said.texts, [&] {
        check_task(said.spec);
        refuse_out_of_reach(said.spec, make_setting(said.spec));
      });
    });
  };
  const std::string head = "task: stand\nrobot: " + quadruped + "\n";
  EXPECT_EQ(refused(head), "");
  expect_words(refused("task: stend\n"), {"my.yaml: line 1: task", "stand"});
  expect_words(refused(head + "sways: 3\n"), {"line 3", "sways", "sway"});
  expect_words(refused(head + "sway: {shift: 3}\n"), {"line 3: sway.shift"});
  expect_words(refused(head + "sway: {rise: 5}\n"),
               {"line 3: sway.rise: it is 5 s", "half of that"});
  expect_words(refused(head + "crouch: 1\n"), {"line 3: crouch"});
  expect_words(refused(head + "standing: {feet: []}\n"), {"line 3: standing.feet: there are none"});
  expect_words(refused(head + "standing: {feet: [fl_foot, fr_fot, rl_foot, rr_foot]}\n"),
               {"line 3: standing.feet", "'fr_fot'", "did you mean 'fr_foot'?"});
  expect_words(refused(head + "standing: {half_x: 0.1}\n"), {"standing.half_x: half sides"});
  expect_words(refused(head + "standing: {half_x: 0.1, half_y: 0.1}\n"),
               {"standing.feet: the z axis of"});
  expect_words(refused(head + "sway: {shift: [0, 0.2, 0]}\n"), {"line 3: sway: ", "in the way"});
  expect_words(refused(head + "posture: standin\n"), {"line 3: posture", "'standing'"});
  expect_words(refused(head + "controller: {update_rate: 300}\n"),
               {"line 3: controller.update_rate: it is 300 Hz"});
  expect_words(refused(head + "controller: {solver_delay: 0.02}\n"),
               {"line 3: controller.solver_delay"});
  expect_words(refused(head + "controller: {knots: 300}\n"), {"line 3: controller.knots"});
  expect_words(refused(head + "controller: {step: 0.1, knots: 5}\n"),
               {"line 3: controller.step", "standing.contact_kd 20", "below 0.1 s"});
  expect_words(refused(head + "phases: {rest_duration: 1e5}\n"),
               {"line 3: phases.rest_duration: it takes"});
  expect_words(refused("task: stand\nrobot: quadrupd\n"), {"line 2: robot", "quadruped"});
  expect_words(refused(head, {"disturbances=sensor"}), {"override 'disturbances=sensor'"});
}

TEST_F(Stand, ends_when_it_is_told_to) {
  RunSpec spec{.task = short_task()};
  spec.progress = [](double time, double end) { return time < 0.6 && end > 1.9; };
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.done);
  EXPECT_TRUE(result.interrupted);
  expect_words(result.outcome, {"interrupted at 0.6", "in phase sway"});
}

}  // namespace
}  // namespace burnish::stand

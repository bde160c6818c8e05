// Pushing with both hands against a wall: the task file, the force over time, and Talos in MuJoCo.
#include "burnish/tasks/push_wall/push_wall.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/mpc/mpc.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/pushing.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::push_wall {
namespace {

using testing::expect_words;
using testing::refusal;

const std::string shipped = BURNISH_TASKS_DIR "/push_wall/talos.yaml";
const std::string talos = BURNISH_ROBOTS_DIR "/talos";

Task talos_task(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "robot=" + talos);
  return read_task(shipped, overrides);
}

/// Plans assume low friction under the feet, so that the force search ends soon.
TEST(PushWall, BothHands_KeepTheForceAndFindTheLargest) {
  if (!has_mujoco()) GTEST_SKIP() << "without MuJoCo there are no feet to stand on";
  Task task = talos_task({"phases.settle_duration=0.1", "phases.clearance=0.008",
                          "phases.ramp_duration=0.7", "phases.hold_duration=0.7",
                          "standing.plan_friction=0.13", "force_search.hold_duration=0.4",
                          "phases.release_duration=2", "phases.retreat_duration=0.3",
                          "controller.update_rate=100", "controller.knots=20"});
  const RunResult result = run_task({.task = task, .plan_rate = 0.0});
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.push) << result.outcome;
  EXPECT_LT(result.push->force_rmse, 1.0);
  EXPECT_NEAR(result.push->force_mean, 50.0, 1.0);
  EXPECT_EQ(result.limit, Limit::Statics);
  EXPECT_EQ(result.limited_by.rfind("friction of ", 0), 0U) << result.limited_by;
  const double weight =
      result.setting.robot.model.total_mass() * result.setting.robot.model.gravity.norm();
  const double friction_force = 0.13 * weight / 2.0 / (1.0 + task.force_search.reserve);
  EXPECT_NEAR(result.push->search_force, friction_force, 2.5);
  EXPECT_NEAR(result.push->largest_force,
              task.force_search.hold_fraction * result.push->search_force, 1.0);
  EXPECT_LT(result.push->hand_slip, 4e-3);
  EXPECT_LT(result.push->foot_slip, 3e-3);
  EXPECT_GT(result.push->com_displacement, 5e-3)
      << "the centre of mass does not move towards the wall";
  // Both hands leave the wall in the end.
  const int last = result.trace.rows() - 1;
  for (const std::string& hand : task.hands)
    EXPECT_EQ(result.trace.at(last, result.trace.index("support_" + hand + "_fz")), 0.0);
}

TEST(PushWall, DesiredForce_FollowsPhasesAndSearch) {
  const Task task = talos_task();
  const Setting s = make_setting(task);
  SearchState force_search;
  const auto force = [&](double time) { return force_at(task, s, force_search, time); };
  EXPECT_EQ(force(s.touch - 1e-6), 0.0);
  EXPECT_EQ(force(s.touch), task.touch_force);
  EXPECT_EQ(force(s.ramp_end), task.force);
  EXPECT_NEAR(force(s.hold_end + 1.0), task.force + task.force_search.rate, 1e-9);
  EXPECT_EQ(force(s.search_end), force_max(task));
  force_search.reached = 80.0;
  EXPECT_NEAR(force(s.search_end), 80.0, 1e-9);
  EXPECT_NEAR(force(s.search_end + back_duration), task.force_search.hold_fraction * 80.0, 1e-9);
  EXPECT_NEAR(force(s.top_end), task.force_search.hold_fraction * 80.0, 1e-9);
  EXPECT_EQ(force(s.release_end), 0.0);
}

/// With a fixed centre of pressure, the moments of hands, weight and ground balance.
TEST(PushWall, ComShift_KeepsTheCentreOfPressure) {
  const Setting s = make_setting(talos_task());
  const Model& model = s.robot.model;
  RigidBody body(model);
  ASSERT_EQ(body.update(s.q_start, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const double F = 60.0;
  const Eigen::Vector3d below(s.com.x(), s.com.y(), s.scene.touches[0].surface.point.z());
  Eigen::Vector3d moment = (s.com + F * s.com_per_force - below).cross(body.mass() * model.gravity);
  for (int h = 0; h < 2; ++h) moment += (s.p_hands.col(h) - below).cross(F * s.wall_axes.col(2));
  EXPECT_LT(moment.head<2>().norm(), 1e-9 * F);
  EXPECT_GT(-s.com_per_force.dot(s.wall_axes.col(2)), 1e-3)
      << "the centre of mass must move towards the wall";
}

TEST(PushWall, StartPosture_PutsBothHandsAtTheClearance) {
  const Task task = talos_task();
  const Setting s = make_setting(task);
  const Eigen::Vector3d n = s.wall_axes.col(2);
  for (int h = 0; h < 2; ++h) {
    const std::string& hand = task.hands[static_cast<std::size_t>(h)];
    const Eigen::Vector3d start = frame_placement(s.robot.model, s.q_start, hand).translation();
    EXPECT_NEAR((start - s.p_hands.col(h)).dot(n), task.clearance, 2e-3);
    EXPECT_NEAR((s.p_hands.col(h) - s.scene.touch(hand).surface.point).dot(n), task.tip_radius,
                1e-12);
  }
  EXPECT_EQ(s.scene.touches.size(), 4U);
  EXPECT_EQ(s.scene.supports().size(), 4U);
}

TEST(PushWall, HandsInSomeStagesOnly_NeedForceSensors) {
  const Task task = talos_task();
  MpcSpec mpc = make_mpc(task, make_setting(task));
  EXPECT_EQ(refusal([&] { MpcController fits(mpc); }), "");
  mpc.touches.resize(2);  // the feet
  expect_words(refusal([&] { MpcController wrong(mpc); }),
               {"stage 'stand' does not contain the contact of support 'left_tool'",
                "a sensor of force at 'left_tool'"});
}

TEST(PushWall, RollingHand_DoesNotCountAsSlip) {
  const double r = 0.02, angle = 0.3;
  const Eigen::Vector3d n = -Eigen::Vector3d::UnitX(), axis = Eigen::Vector3d::UnitY();
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity(), now = start;
  now.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  now.translation() = r * angle * axis.cross(n);
  EXPECT_LT(pressing::slid(start, now, n, r).norm(), 1e-12);
  now.translation() += 0.005 * Eigen::Vector3d::UnitY() + 0.1 * n;
  EXPECT_NEAR(pressing::slid(start, now, n, r).norm(), 0.005, 1e-12);
}

TEST(PushWall, ForceBeyondTheMotors_IsRefused) {
  Task task = talos_task({"force=2000", "force_search.force_max=3000", "limits.force=never"});
  expect_words(refusal([&] { run_task({.task = task}); }),
               {"force: pushing with 2000 N at the start needs", "Nm in"});
}

TEST(PushWall, WrittenTask_ReadsBackUnchanged) {
  EXPECT_EQ(testing::contents(shipped), task_text(read_task(shipped)))
      << "burnish run tasks/push_wall/talos.yaml --write-task FILE updates it";
  Task task = talos_task();
  task.hands = {"a hand", "another: #2"};
  task.slip = range::end;
  task.wall.normal_world = Eigen::Vector3d(-1.0, 0.1, 0.0);
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.hands, task.hands);
}

TEST(PushWall, InvalidFile_RefusalNamesTheLine) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto parsed = files::parse_said<Task>(text, "my.yaml", overrides);
      files::placed(parsed.texts, [&] {
        check_task(parsed.spec);
        make_setting(parsed.spec);
      });
    });
  };
  const std::string head = "task: push_wall\nrobot: " + talos + "\nposture: standing_wall\n";
  EXPECT_EQ(refused(head), "");
  expect_words(refused("task: push_wal\n"), {"my.yaml: line 1: task", "push_wall"});
  expect_words(refused(head + "forse: 3\n"), {"line 4", "forse", "force"});
  expect_words(refused(head + "force: -3\n"), {"line 4: force", "-3"});
  expect_words(refused(head + "hands: [tool]\n"), {"line 4: hands: the list has 1 frame"});
  expect_words(refused(head + "hands: [tool, tool]\n"), {"line 4: hands", "both hands are 'tool'"});
  expect_words(refused(head + "hands: [left_tol, tool]\n"),
               {"line 4: hands: ", "'left_tol'", "did you mean 'left_tool'?"});
  expect_words(refused(head + "wall: {normal: [0, 0, 0]}\n"), {"line 4: wall.normal"});
  expect_words(refused(head + "wall: {normal: [0, -1, 0]}\n"), {"posture: hand", "farther"});
  expect_words(refused(head + "phases: {touch_force: 60}\n"),
               {"line 4: phases.touch_force: it is 60 N", "force of 50 N"});
  expect_words(refused(head + "phases: {hold_duration: 0.3}\n"),
               {"line 4: phases.hold_duration: it is 0.3 s; wanted at least 0.4 s"});
  expect_words(refused(head + "force_search: {hold_duration: 0.3}\n"),
               {"line 4: force_search.hold_duration: it is 0.3 s; wanted at least 0.4 s"});
  expect_words(refused(head + "force_search: {force_max: 40}\n"),
               {"line 4: force_search.force_max: it is 40 N"});
  expect_words(refused(head + "limits: {force: 52}\n"),
               {"line 4: limits.force: the limit is 52 N"});
  expect_words(refused(head + "limits: {force: never}\n"),
               {"force_search.force_max: force_max and limits.force are both never"});
  expect_words(refused(head + "standing: {force_sensors: false}\n"),
               {"line 4: standing.force_sensors: it is false"});
  expect_words(refused(head + "standing: {feet: [left_sole]}\n"), {"standing.feet", "'left_sole'"});
  expect_words(refused(head + "controller: {update_rate: 300}\n"),
               {"line 4: controller.update_rate: it is 300 Hz"});
  expect_words(refused(head + "controller: {knots: 300}\n"), {"line 4: controller.knots"});
  expect_words(refused(head + "controller: {step: 0.05, knots: 10}\n"),
               {"line 4: controller.step", "wall.contact_kd is 40 1/s", "below 0.05 s"});
  expect_words(refused("task: push_wall\nrobot: tallos\n"), {"line 2: robot", "talos"});
}

}  // namespace
}  // namespace burnish::push_wall

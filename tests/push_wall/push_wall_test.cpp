// Pushing with both hands against a wall: the file, the force over time, and Talos in MuJoCo.
#include "burnish/tasks/push_wall/push_wall.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
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

/// Its plans may use little friction under the feet, so that the search is over soon.
TEST(PushWall, holds_the_force_of_both_hands_and_finds_the_largest_on_its_feet) {
  if (!has_mujoco()) GTEST_SKIP() << "without MuJoCo there are no feet to stand on";
  Task task = talos_task({"phases.settle_duration=0.1", "phases.clearance=0.008",
                          "phases.ramp_duration=0.7", "phases.hold_duration=0.7",
                          "standing.plan_friction=0.13", "lean.hold_duration=0.4",
                          "phases.release_duration=2", "phases.retreat_duration=0.3",
                          "controller.update_rate=100", "controller.knots=20"});
  const RunResult result = run_task({.task = task, .plan_rate = 0.0});
  EXPECT_TRUE(result.done) << result.outcome;
  ASSERT_TRUE(result.push) << result.outcome;
  EXPECT_LT(result.push->force_rmse, 1.0);
  EXPECT_NEAR(result.push->force_mean, 50.0, 1.0);
  EXPECT_EQ(result.limit, Limit::Bear);
  EXPECT_EQ(result.limited_by.rfind("friction of ", 0), 0U) << result.limited_by;
  const double weight =
      result.setting.robot.model.total_mass() * result.setting.robot.model.gravity.norm();
  const double bears = 0.13 * weight / 2.0 / (1.0 + task.lean.reserve);
  EXPECT_NEAR(result.push->lean_force, bears, 2.5);
  EXPECT_NEAR(result.push->largest_force, task.lean.share * result.push->lean_force, 1.0);
  EXPECT_LT(result.push->hand_slip, 4e-3);
  EXPECT_LT(result.push->foot_slip, 3e-3);
  EXPECT_GT(result.push->lean, 5e-3) << "the body does not lean against the wall";
  // Off the wall in the end.
  const int last = result.trace.rows() - 1;
  for (const std::string& hand : task.hands)
    EXPECT_EQ(result.trace.at(last, result.trace.index("support_" + hand + "_fz")), 0.0);
}

TEST(PushWall, force_follows_its_phases_and_what_the_search_found) {
  const Task task = talos_task();
  const Setting s = make_setting(task);
  LeanState lean;
  const auto force = [&](double time) { return force_at(task, s, lean, time); };
  EXPECT_EQ(force(s.touch - 1e-6), 0.0);
  EXPECT_EQ(force(s.touch), task.touch_force);
  EXPECT_EQ(force(s.ramp_end), task.force);
  EXPECT_NEAR(force(s.hold_end + 1.0), task.force + task.lean.rate, 1e-9);
  EXPECT_EQ(force(s.lean_end), force_max(task));
  lean.reached = 80.0;
  EXPECT_NEAR(force(s.lean_end), 80.0, 1e-9);
  EXPECT_NEAR(force(s.lean_end + back_duration), task.lean.share * 80.0, 1e-9);
  EXPECT_NEAR(force(s.top_end), task.lean.share * 80.0, 1e-9);
  EXPECT_EQ(force(s.release_end), 0.0);
}

/// The moments of hands, weight and ground balance where the ground bears in the same place.
TEST(PushWall, leans_so_that_the_pressure_stays_where_it_is) {
  const Setting s = make_setting(talos_task());
  const Model& model = s.robot.model;
  RigidBody body(model);
  ASSERT_EQ(body.update(s.q_start, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const double F = 60.0;
  const Eigen::Vector3d below(s.com.x(), s.com.y(), s.scene.supports[0].point.z());
  Eigen::Vector3d moment = (s.com + F * s.com_per_force - below).cross(body.mass() * model.gravity);
  for (int h = 0; h < 2; ++h) moment += (s.p_hands.col(h) - below).cross(F * s.wall_axes.col(2));
  EXPECT_LT(moment.head<2>().norm(), 1e-9 * F);
  EXPECT_GT(-s.com_per_force.dot(s.wall_axes.col(2)), 1e-3) << "to the wall";
}

TEST(PushWall, starts_with_both_hands_before_the_wall) {
  const Task task = talos_task();
  const Setting s = make_setting(task);
  const Eigen::Vector3d n = s.wall_axes.col(2);
  for (int h = 0; h < 2; ++h) {
    const Eigen::Vector3d start =
        frame_placement(s.robot.model, s.q_start, task.hands[static_cast<std::size_t>(h)])
            .translation();
    EXPECT_NEAR((start - s.p_hands.col(h)).dot(n), task.clearance, 2e-3);
    EXPECT_NEAR((s.p_hands.col(h) - s.scene.surface.point).dot(n), task.tip_radius, 1e-12);
  }
  EXPECT_EQ(s.scene.supports.size(), 4U);
}

TEST(PushWall, hands_that_hold_in_some_stages_only_are_to_be_measured) {
  const Task task = talos_task();
  MpcSpec mpc = make_mpc(task, make_setting(task));
  EXPECT_EQ(refusal([&] { MpcController fits(mpc); }), "");
  mpc.support_sensors = false;
  expect_words(refusal([&] { MpcController wrong(mpc); }),
               {"stage 'stand' does without support 'left_tool'", "support_sensors"});
}

TEST(PushWall, rolling_is_no_sliding) {
  const double r = 0.02, angle = 0.3;
  const Eigen::Vector3d n = -Eigen::Vector3d::UnitX(), axis = Eigen::Vector3d::UnitY();
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity(), now = start;
  now.linear() = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  now.translation() = r * angle * axis.cross(n);
  EXPECT_LT(pressing::slid(start, now, n, r).norm(), 1e-12);
  now.translation() += 0.005 * Eigen::Vector3d::UnitY() + 0.1 * n;
  EXPECT_NEAR(pressing::slid(start, now, n, r).norm(), 0.005, 1e-12);
}

TEST(PushWall, is_refused_where_motors_cannot_bear_the_force) {
  Task task = talos_task({"force=2000", "lean.force_max=3000", "limits.force=never"});
  expect_words(refusal([&] { run_task({.task = task}); }),
               {"force: pushing with 2000 N at the start takes", "Nm of"});
}

TEST(PushWall, writes_a_file_that_reads_back_with_every_key_explained) {
  EXPECT_EQ(testing::contents(shipped), task_text(read_task(shipped)))
      << "burnish run tasks/push_wall/talos.yaml --write-task FILE mends it";
  Task task = talos_task();
  task.hands = {"a hand", "another: #2"};
  task.slip = range::end;
  task.wall.normal_world = Eigen::Vector3d(-1.0, 0.1, 0.0);
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.hands, task.hands);
}

TEST(PushWall, refuses_what_it_cannot_read_or_do_where_the_file_says_it) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto said = files::parse_said<Task>(text, "my.yaml", overrides);
      files::placed(said.texts, [&] {
        check_task(said.spec);
        make_setting(said.spec);
      });
    });
  };
  const std::string head = "task: push_wall\nrobot: " + talos + "\nposture: standing_wall\n";
  EXPECT_EQ(refused(head), "");
  expect_words(refused("task: push_wal\n"), {"my.yaml: line 1: task", "push_wall"});
  expect_words(refused(head + "forse: 3\n"), {"line 4", "forse", "force"});
  expect_words(refused(head + "force: -3\n"), {"line 4: force", "-3"});
  expect_words(refused(head + "hands: [tool]\n"), {"line 4: hands: there are 1"});
  expect_words(refused(head + "hands: [tool, tool]\n"), {"line 4: hands", "of one name"});
  expect_words(refused(head + "hands: [left_tol, tool]\n"),
               {"line 4: hands: ", "'left_tol'", "did you mean 'left_tool'?"});
  expect_words(refused(head + "wall: {normal: [0, 0, 0]}\n"), {"line 4: wall.normal"});
  expect_words(refused(head + "wall: {normal: [0, -1, 0]}\n"), {"posture: hand", "farther"});
  expect_words(refused(head + "phases: {touch_force: 60}\n"),
               {"line 4: phases.touch_force: it is 60 N", "force of 50 N"});
  expect_words(refused(head + "phases: {hold_duration: 0.3}\n"),
               {"line 4: phases.hold_duration: it is 0.3 s; wanted at least 0.4 s"});
  expect_words(refused(head + "lean: {hold_duration: 0.3}\n"),
               {"line 4: lean.hold_duration: it is 0.3 s; wanted at least 0.4 s"});
  expect_words(refused(head + "lean: {force_max: 40}\n"), {"line 4: lean.force_max: it is 40 N"});
  expect_words(refused(head + "limits: {force: 52}\n"), {"line 4: limits.force: it is 52 N"});
  expect_words(refused(head + "limits: {force: never}\n"), {"lean.force_max: it is never"});
  expect_words(refused(head + "standing: {force_sensors: false}\n"),
               {"line 4: standing.force_sensors: it is false"});
  expect_words(refused(head + "standing: {feet: [left_sole]}\n"), {"standing.feet", "'left_sole'"});
  expect_words(refused(head + "controller: {update_rate: 300}\n"),
               {"line 4: controller.update_rate: it is 300 Hz"});
  expect_words(refused(head + "controller: {knots: 300}\n"), {"line 4: controller.knots"});
  expect_words(refused(head + "controller: {step: 0.05, knots: 10}\n"),
               {"line 4: controller.step", "wall.contact_kd 40", "below 0.05 s"});
  expect_words(refused("task: push_wall\nrobot: tallos\n"), {"line 2: robot", "talos"});
}

}  // namespace
}  // namespace burnish::push_wall

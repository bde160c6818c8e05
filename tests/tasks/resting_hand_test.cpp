// Hand that rests on a plane while whole Talos stands and polishes: scene, plans, runs, refusals.
#include "polishing/resting_hand.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

polishing::Task resting_task() {
  polishing::Task task =
      polishing::read_task(std::string(BURNISH_TASKS_DIR) + "/polishing/resting_hand.yaml");
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos";
  return task;
}

/// Shipped task with a short path, in MuJoCo.
MpcCase resting_case() {
  MpcCase result;
  result.task = resting_task();
  result.task.reach_duration = 0.2;
  result.task.standing.settle = 0.2;
  result.task.polish_duration = 0.8;
  result.task.path.start_up = 0.5;
  result.make_plant = [](const Model& model, const SceneSpec& scene) {
    return make_plant(PlantKind::Mujoco, model, scene, 5e-4);
  };
  return result;
}

std::string setting_refusal(const polishing::Task& task) {
  return testing::refusal([&] { (void)polishing::make_setting(task); });
}

class RestingHand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  }
};

TEST(RestingHandScene, Plane_IsIndentedByTheForceAtTheStart) {
  polishing::Task task = resting_task();
  task.rest.normal_world = {-0.2, 0.0, 2.0};
  const polishing::Setting setting = polishing::make_setting(task);
  ASSERT_EQ(setting.scene.supports().size(), 3U);
  const TouchSpec& hand = setting.scene.touch(task.rest.frame);
  const Eigen::Vector3d n = task.rest.normal_world.normalized();
  const Eigen::Vector3d p =
      frame_placement(setting.robot.model, setting.q_start, hand.frame).translation();
  EXPECT_NEAR(hand.surface.stiffness * (hand.radius - (p - hand.surface.point).dot(n)),
              task.rest.force, 1e-6);
  EXPECT_EQ(polishing::feet_in(task, setting.scene).size(), 2U);
}

TEST(RestingHandPlans, EveryPhase_HoldsTheHand) {
  const polishing::Task task = resting_task();
  const MpcSpec mpc = polishing::make_mpc(task, polishing::make_setting(task));
  EXPECT_EQ(mpc.supports,
            (std::vector<std::string>{"left_sole_link", "right_sole_link", "left_tool"}));
  const auto holds_hand = [&](const std::string& name) {
    const auto stage = std::find_if(mpc.problem.stages.begin(), mpc.problem.stages.end(),
                                    [&](const Stage& each) { return each.name == name; });
    return std::count(stage->contacts.begin(), stage->contacts.end(), "left_tool") == 1;
  };
  for (const SchedulePhase& phase : mpc.schedule)
    EXPECT_TRUE(holds_hand(phase.stage)) << phase.name;
}

TEST(RestingHandPlans, Hand_RestsAndDoesNotCarryTheRobot) {
  const polishing::Task task = resting_task();
  const MpcSpec mpc = polishing::make_mpc(task, polishing::make_setting(task));
  EXPECT_EQ(mpc.supports.back(), task.rest.frame);
  EXPECT_EQ(mpc.resting_supports, std::vector<std::string>{task.rest.frame});
  for (const Stage& stage : mpc.problem.stages)
    EXPECT_EQ(stage.contacts.back(), task.rest.frame) << stage.name;
}

TEST(RestingHandPlans, NoHand_LeavesFeetOnly) {
  polishing::Task task = resting_task();
  task.rest.frame = {};
  const polishing::Setting setting = polishing::make_setting(task);
  EXPECT_EQ(setting.scene.supports().size(), 2U);
  EXPECT_EQ(polishing::make_mpc(task, setting).supports.size(), 2U);
}

TEST_F(RestingHand, MismatchedModel_HoldsBothForces) {
  const MpcCase wanted = resting_case();
  MpcRun run(wanted);
  ASSERT_LE(run.polish(), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  EXPECT_LT(run.metrics().force_rmse, 1.0);
  EXPECT_EQ(run.watched().allocations, 0);
  const double end = run.plant().time();
  const polishing::RestFigures figures =
      rest_figures(wanted.task.rest, run.setting(), run.loop().trace(), end - 0.7, end);
  EXPECT_NEAR(figures.force_mean, wanted.task.rest.force, 1.0);
  EXPECT_LT(figures.force_rmse, 2.0);
  EXPECT_LT(figures.slip, 2e-3);
}

TEST_F(RestingHand, SensorWithoutForce_ReportsTheLostContactOfTheHand) {
  MpcCase wanted = resting_case();
  wanted.spoil = [](Measurement& m) {
    if (m.time > 0.4) m.wrenches.col(3).setZero();
  };
  MpcRun run(wanted);
  ASSERT_LE(run.run(0.7), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::ContactLost);
  expect_words(run.mpc().fault().text(), {"left_tool", "contact needs 2 N"});
}

TEST_F(RestingHand, SmallLimitOfSlip_IsAFault) {
  MpcCase wanted = resting_case();
  wanted.task.rest.slip = 1e-7;
  MpcRun run(wanted);
  ASSERT_LE(run.run(0.5), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::Watched);
  expect_words(run.mpc().fault().text(), {"slip of hand 'left_tool'"});
}

TEST(RestingHandVerdict, LargeForceError_IsNotPassed) {
  const polishing::Task task = resting_task();
  EXPECT_EQ(polishing::rest_failure(task, {.force_rmse = 2.0}), "");
  expect_words(polishing::rest_failure(task, {.force_rmse = 2.1}),
               {"resting hand was off by 2.1 N rms, 10.5 % of 20 N", "verdict.force_rmse"});
}

TEST(RestingHandRefusals, UnfitHands_AreNamedWithTheRequirement) {
  polishing::Task task = resting_task();
  task.rest.frame = "left_tol";
  expect_words(setting_refusal(task), {"rest.frame", "left_tol", "left_tool"});
  task.rest.frame = "tool";
  expect_words(setting_refusal(task), {"rest.frame", "'tool'", "tool.frame", "another link"});
  task.rest.frame = "left_sole_link";
  expect_words(setting_refusal(task), {"rest.frame", "standing.feet"});
  for (const char* carrier : {"leg_left_5_link", "base_link"}) {
    task.rest.frame = carrier;
    expect_words(setting_refusal(task), {"rest.frame", carrier, "carries foot"});
  }
  task.rest.frame.clear();
  task.rest.force = 10.0;
  expect_words(setting_refusal(task), {"rest.frame", "no hand is stated"});
  task = resting_task();
  task.rest.slip = std::nan("");
  expect_words(setting_refusal(task), {"rest.slip is nan"});
  task = resting_task();
  task.rest.force = 500.0;
  expect_words(setting_refusal(task), {"rest.force", "500 N", "wanted at most", "Nm"});
  task = resting_task();
  task.standing.force_sensors = false;
  expect_words(setting_refusal(task), {"standing.force_sensors", "'left_tool'"});
  task = polishing::Task{};
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm";
  task.rest.frame = "left_tool";
  expect_words(setting_refusal(task), {"rest.frame", "standing.feet"});
}

TEST(RestingHandRefusals, NumbersOutOfRange_AreRefused) {
  for (const char* change :
       {"rest.force=0", "rest.radius=-1", "rest.plan_friction=0", "rest.normal=[0, 0, 0]"})
    EXPECT_NE(testing::refusal([&] {
                polishing::Task task = resting_task();
                polishing::override_task(task, {change});
                polishing::check_task(task);
              }),
              "")
        << change;
}

}  // namespace
}  // namespace burnish::test

// Whole Talos on its two feet in MuJoCo: it polishes, bears pushes, slow plans and faults.
#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/state.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "pressing/standing_terms.hpp"
#include "support/refusal.hpp"
#include "support/standing_case.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

bool stands(const Eigen::VectorXd& q_start, const Eigen::VectorXd& q) {
  return (q.head<3>() - q_start.head<3>()).norm() < 0.1;
}

class Standing : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  }
};

TEST_F(Standing, polishes_a_board_with_what_its_controller_does_not_know) {
  MpcRun run(standing_case());
  ASSERT_LE(run.polish(), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Metrics metrics = run.metrics();
  EXPECT_LT(metrics.force_rmse, 0.5);
  EXPECT_LT(metrics.position_rmse, 1e-3);
  EXPECT_EQ(run.watched().allocations, 0);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
}

TEST_F(Standing, keeps_pressing_while_its_torso_is_pushed) {
  for (const Eigen::Vector3d& force :
       {Eigen::Vector3d(0.0, 120.0, 0.0), Eigen::Vector3d(-104.0, -60.0, 0.0)}) {
    MpcRun run(standing_case({{2.0, 0.3, force, "torso_2_link"}}));
    ASSERT_LE(run.polish(), Status::NotConverged);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_LT(run.metrics().force_rmse, 3.0);
    EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
  }
}

TEST_F(Standing, keeps_polishing_while_its_inertial_unit_is_wrong_or_silent) {
  for (const ImuFault& fault :
       std::vector<ImuFault>{{.start = 3.0, .gyro_offset = {0.0, 0.3, 0.0}},
                             {.start = 3.0, .duration = 0.3, .gyro_offset = {1.0, 0.0, 0.0}},
                             {.start = 3.0, .accelerometer_offset = {2.0, 0.0, 0.0}},
                             {.start = 3.0, .frozen = true},
                             {.start = 3.0, .silent = true}}) {
    MpcCase wanted = standing_case();
    wanted.task.standing.settle = 1.0;  // as shipped: the unit's biases are known by then
    wanted.task.disturbances.imu_faults = {fault};
    MpcRun run(wanted, pressing::base_estimator(wanted.task.standing));
    ASSERT_LE(run.polish(), Status::NotConverged);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_LT(run.metrics().force_rmse, 2.0)
        << "silent: " << fault.silent << ", frozen: " << fault.frozen
        << ", gyroscope: " << fault.gyro_offset.transpose();
    EXPECT_TRUE(run.watched().finite);
    EXPECT_EQ(run.watched().allocations, 0);
    EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
    // Where it is told to be is where it is.
    const Eigen::VectorXd apart =
        difference(run.setting().robot.model, run.plant().q(), run.loop().measurement().q);
    EXPECT_LT(apart.head<3>().norm(), 5e-3);
    EXPECT_LT(apart.segment<3>(3).norm(), 0.01);
  }
}

TEST_F(Standing, freezes_when_nothing_tells_where_its_base_is) {
  MpcCase wanted = standing_case();
  wanted.spoil = [](Measurement& m) {
    if (m.time > 1.6) m.base_lost_for = m.time - 1.6;
  };
  MpcRun run(wanted);
  ASSERT_LE(run.run(3.0), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::BaseLost);
  EXPECT_NEAR(run.mpc().fault().time, 1.651, 2e-3);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
}

TEST_F(Standing, stays_on_its_feet_after_a_fault) {
  MpcCase wanted = standing_case();
  wanted.spoil = [](Measurement& m) {
    if (m.time > 1.6) m.tool_force_world.x() = std::nan("");
  };
  MpcRun run(wanted);
  ASSERT_LE(run.run(3.5), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::BadMeasurement);
  EXPECT_TRUE(run.watched().finite);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
  EXPECT_LT(run.plant().v().cwiseAbs().maxCoeff(), 0.1);
}

TEST_F(Standing, gives_up_upright_when_the_surface_is_gone) {
  MpcCase wanted = standing_case();
  wanted.task.disturbances.surface_motion = {.drift = -10.0, .start = 1.8};
  MpcRun run(wanted);
  ASSERT_LE(run.run(3.5), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::ContactLost);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
}

polishing::Task wide_task() {
  return polishing::read_task(std::string(BURNISH_TASKS_DIR) + "/polishing/standing_wide.yaml");
}

TEST(StandingWide, needs_the_legs_for_a_line_of_a_metre) {
  polishing::Task task = wide_task();
  const ReachReport standing = polishing::check_reach(task, polishing::make_setting(task));
  EXPECT_TRUE(standing.ok()) << standing.text;
  EXPECT_NEAR(standing.path_length, 1.5, 1e-3);  // half of it twice
  // Trunk and arm before the same board, the pelvis held.
  polishing::override_task(task, {"robot=talos:right_arm", "posture=board_x", "standing.feet=[]"});
  const ReachReport held = polishing::check_reach(task, polishing::make_setting(task));
  EXPECT_EQ(held.problem, ReachProblem::Joint);
  EXPECT_EQ(held.joint, "torso_2_joint");
}

TEST_F(Standing, polishes_up_and_down_a_wide_board) {
  MpcCase wanted = standing_case();
  const polishing::Task wide = wide_task();
  wanted.task.surface_estimate = wide.surface_estimate;
  wanted.task.path = wide.path;
  wanted.task.path.points = {{0.0, 0.3}};
  wanted.task.path.speed = 0.3;
  wanted.task.polish_duration = 1.9;
  MpcRun run(wanted);
  ASSERT_LE(run.polish(), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Metrics metrics = run.metrics();
  EXPECT_LT(metrics.force_rmse, 1.0);
  EXPECT_LT(metrics.position_rmse, 2e-3);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
}

TEST_F(Standing, is_refused_without_feet_and_on_feet_that_there_are_not) {
  polishing::Task task = standing_case().task;
  task.standing.feet = {};
  expect_words(testing::refusal([&] { (void)polishing::make_setting(task); }),
               {"floats free", "standing.feet"});
  EXPECT_EQ(polishing::wants_plans(task), "");
  EXPECT_NE(polishing::wants_plans(standing_case().task), "");
  task.standing.feet = {"left_sole_link", "right_sole_lnk"};
  expect_words(testing::refusal([&] { (void)polishing::make_setting(task); }),
               {"right_sole_lnk", "right_sole_link"});
  task.standing.feet = {"left_sole_link", "right_sole_link"};
  task.standing.half_y = 0.0;
  expect_words(testing::refusal([&] { (void)polishing::make_setting(task); }), {"half sides"});
}

}  // namespace
}  // namespace burnish::test

// Whole Talos on its two feet in MuJoCo: polishing, pushes, sensor faults, and refusals.
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

TEST_F(Standing, MismatchedModel_PolishesABoard) {
  MpcRun run(standing_case());
  ASSERT_LE(run.polish(), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Metrics metrics = run.metrics();
  EXPECT_LT(metrics.force_rmse, 0.5);
  EXPECT_LT(metrics.position_rmse, 1e-3);
  EXPECT_EQ(run.watched().allocations, 0);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
}

TEST_F(Standing, PushAtTheTorso_KeepsPressing) {
  for (const Eigen::Vector3d& force :
       {Eigen::Vector3d(0.0, 120.0, 0.0), Eigen::Vector3d(-104.0, -60.0, 0.0)}) {
    MpcRun run(standing_case({{2.0, 0.3, force, "torso_2_link"}}));
    ASSERT_LE(run.polish(), Status::NotConverged);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_LT(run.metrics().force_rmse, 3.0);
    EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
  }
}

TEST_F(Standing, ImuWrongOrSilent_KeepsPolishing) {
  for (const ImuFault& fault :
       std::vector<ImuFault>{{.start = 3.0, .gyro_offset = {0.0, 0.3, 0.0}},
                             {.start = 3.0, .duration = 0.3, .gyro_offset = {1.0, 0.0, 0.0}},
                             {.start = 3.0, .accelerometer_offset = {2.0, 0.0, 0.0}},
                             {.start = 3.0, .frozen = true},
                             {.start = 3.0, .silent = true}}) {
    MpcCase wanted = standing_case();
    // Time to estimate the biases of the IMU, as in the shipped task.
    wanted.task.standing.settle = 1.0;
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
    // The estimated base is close to the true one.
    const Eigen::VectorXd estimate_error =
        difference(run.setting().robot.model, run.plant().q(), run.loop().measurement().q);
    EXPECT_LT(estimate_error.head<3>().norm(), 5e-3);
    EXPECT_LT(estimate_error.segment<3>(3).norm(), 0.01);
  }
}

TEST_F(Standing, BaseEstimateLost_StopsOnItsFeet) {
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

TEST_F(Standing, BadMeasurement_StaysOnItsFeet) {
  MpcCase wanted = standing_case();
  wanted.spoil = [](Measurement& m) {
    if (m.time > 1.6) m.wrenches(0, 0) = std::nan("");
  };
  MpcRun run(wanted);
  ASSERT_LE(run.run(3.5), Status::NotConverged);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::BadMeasurement);
  EXPECT_TRUE(run.watched().finite);
  EXPECT_TRUE(stands(run.setting().q_start, run.plant().q()));
  EXPECT_LT(run.plant().v().cwiseAbs().maxCoeff(), 0.1);
}

TEST_F(Standing, SurfaceGone_ReportsContactLostAndStands) {
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

TEST(StandingWide, LineOfAMetre_NeedsTheLegs) {
  polishing::Task task = wide_task();
  const ReachReport standing = polishing::check_reach(task, polishing::make_setting(task));
  EXPECT_TRUE(standing.ok()) << standing.text;
  EXPECT_NEAR(standing.path_length, 1.5, 1e-3);  // half of the line twice
  // Trunk and arm at the same board, with a fixed pelvis.
  polishing::override_task(task, {"robot=talos:right_arm", "posture=board_x", "standing.feet=[]"});
  const ReachReport fixed_pelvis = polishing::check_reach(task, polishing::make_setting(task));
  EXPECT_EQ(fixed_pelvis.problem, ReachProblem::Joint);
  EXPECT_EQ(fixed_pelvis.joint, "torso_2_joint");
}

TEST_F(Standing, WideBoard_PolishesUpAndDown) {
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

TEST_F(Standing, MissingOrUnknownFeet_AreRefused) {
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
  expect_words(testing::refusal([&] { (void)polishing::make_setting(task); }),
               {"half_x and half_y are "});
}

}  // namespace
}  // namespace burnish::test

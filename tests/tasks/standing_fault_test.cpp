// Faults of whole Talos on its feet in MuJoCo, and its reactions.
#include <gtest/gtest.h>

#include "burnish/report/standing_figures.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "support/standing_case.hpp"

namespace burnish::test {
namespace {

class StandingFault : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
    task = standing_case().task;
    task.standing.after_fault = 1.0;
  }
  /// Runs the task with an estimated base, as a user does, and checks the torques against the
  /// limits.
  polishing::RunResult run() const {
    const polishing::RunResult result = polishing::run_task({.task = task, .plan_rate = 0.0});
    EXPECT_LE(result.plant_status, Status::NotConverged);
    EXPECT_TRUE(result.trace.has("signal_torque_error_" + joints(result).front()));
    for (int row = 0; row < result.trace.rows(); row += 20)
      for (const char* figure : {"tau_command", "tau_applied"})
        for (const std::string& joint : joints(result))
          EXPECT_LE(std::abs(result.trace.at(row, result.trace.index(figure + ("_" + joint)))),
                    effort(result, joint));
    return result;
  }
  static std::vector<std::string> joints(const polishing::RunResult& result) {
    std::vector<std::string> names;
    for (int k = 6; k < result.setting.robot.model.nv; ++k)
      names.push_back(result.setting.robot.model.v_name(k));
    return names;
  }
  static double effort(const polishing::RunResult& result, const std::string& joint) {
    const Model& model = result.setting.robot.model;
    for (int k = 0; k < model.nv; ++k)
      if (model.v_name(k) == joint) return model.effort_limit[k];
    return 0.0;
  }

  polishing::Task task;
};

TEST_F(StandingFault, OneFootOnSlipperyGround_Stands) {
  task.disturbances.slippery_ground = {{.start = 1.6, .frame = "left_sole_link"}};
  const polishing::RunResult result = run();
  EXPECT_EQ(result.fault.kind, FaultKind::None) << result.outcome;
  EXPECT_GT(result.standing->slip, 2e-3) << "the foot did not slip";
  EXPECT_FALSE(fell(*result.standing));
}

TEST_F(StandingFault, BothFeetOnLowFriction_Polishes) {
  task.disturbances.slippery_ground = {{.start = 1.6, .friction = 0.15}};
  const polishing::RunResult result = run();
  EXPECT_TRUE(result.succeeded) << result.outcome;
}

TEST_F(StandingFault, MotorLost_ReportsAFaultAndStands) {
  for (const char* joint :
       {"leg_right_3_joint", "leg_left_5_joint", "torso_1_joint", "arm_right_4_joint"}) {
    task.disturbances.motor_losses = {{.start = 1.6, .joint = joint}};
    const polishing::RunResult result = run();
    EXPECT_NE(result.fault.kind, FaultKind::None) << joint << ": " << result.outcome;
    EXPECT_LT(result.fault.time, 2.0) << joint;
    EXPECT_NE(result.outcome.find("the robot stands"), std::string::npos)
        << joint << result.outcome;
  }
}

TEST_F(StandingFault, TimeAfterFault_ExtendsTheRunNotTheFigures) {
  task.disturbances.surface_motion = {.drift = -10.0, .start = 2.0};
  task.standing.after_fault = 0.0;
  const polishing::RunResult ended = run();
  task.standing.after_fault = 0.5;
  const polishing::RunResult watched = run();
  EXPECT_EQ(ended.fault.kind, FaultKind::ContactLost) << ended.outcome;
  ASSERT_TRUE(watched.metrics && ended.metrics);
  EXPECT_EQ(watched.metrics->force_rmse, ended.metrics->force_rmse);
  const auto last = [](const polishing::RunResult& result) {
    const auto time = result.trace.column("time");
    return time[time.size() - 1];
  };
  EXPECT_NEAR(last(watched), last(ended) + 0.5, 2e-3);
}

TEST_F(StandingFault, HardPush_ReportsAFall) {
  task.disturbances.pushes = {{1.6, 0.3, Eigen::Vector3d(-400.0, 0.0, 0.0), "torso_2_link"}};
  const polishing::RunResult result = run();
  EXPECT_NE(result.fault.kind, FaultKind::None);
  EXPECT_TRUE(fell(*result.standing));
  EXPECT_NE(result.outcome.find("the robot fell"), std::string::npos) << result.outcome;
}

TEST_F(StandingFault, PlansTooLate_ReportSolverLateAndStand) {
  task.limits.deadline = 1e-9;  // shorter than any solve
  const polishing::RunResult result = run();
  EXPECT_EQ(result.fault.kind, FaultKind::SolverLate) << result.outcome;
  EXPECT_FALSE(fell(*result.standing)) << result.outcome;
}

}  // namespace
}  // namespace burnish::test

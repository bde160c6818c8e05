// Complete runs on both plants, and their results.
#include "burnish/tasks/polishing/run.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

/// Short run with a plan every 10 ms.
RunSpec short_run(PlantKind plant, ControllerKind controller) {
  RunSpec spec;
  put_on(spec.task, "table");
  spec.task.polish_duration = 1.5;
  spec.task.path.start_up = 1.0;
  spec.plant = plant;
  spec.controller = controller;
  return spec;
}

void expect_polished(const RunResult& result) {
  EXPECT_TRUE(result.succeeded) << result.outcome;
  EXPECT_EQ(result.plant_status, Status::Ok);
  EXPECT_EQ(result.fault.kind, FaultKind::None);
  EXPECT_EQ(result.outcome.rfind("polished", 0), 0U) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_NEAR(result.metrics->force_mean, 30.0, 2.0);
  EXPECT_LT(result.metrics->position_p95, 0.01);
  EXPECT_EQ(result.metrics->without_contact, 0.0);
  EXPECT_GT(result.ticks.count, 1000);
  EXPECT_LE(result.ticks.median, result.ticks.p99);
  EXPECT_LE(result.ticks.p99, result.ticks.maximum);
  EXPECT_EQ(result.trace.dropped(), 0);
  EXPECT_GT(result.reach.points, 10);
}

TEST(PolishingRun, IdealPlantWithMpc_Polishes) {
  const RunResult result = run_task(short_run(PlantKind::Ideal, ControllerKind::Mpc));
  expect_polished(result);
  EXPECT_TRUE(result.metrics->solver.has_value());
  // The retreat is part of the run.
  const auto phase = result.trace.column("phase");
  EXPECT_EQ(phase[phase.size() - 1], static_cast<double>(Phase::Retreat));
  const auto time = result.trace.column("time");
  EXPECT_NEAR(time[time.size() - 1], result.setting.track_end + 0.5, 0.1);
}

TEST(PolishingRun, IdealPlantWithoutPlans_Polishes) {
  for (const ControllerKind controller : {ControllerKind::Baseline, ControllerKind::Admittance}) {
    const RunResult result = run_task(short_run(PlantKind::Ideal, controller));
    expect_polished(result);
    EXPECT_FALSE(result.metrics->solver.has_value());
  }
}

TEST(PolishingRun, TaskGains_ReachTheController) {
  Task task;
  override_task(task, {"baseline.kp=123", "admittance.damping=456", "phases.touch_force=7",
                       "controller.tick_rate=1000"});
  const Setting setting = make_setting(task);
  const ImpedanceSpec baseline = make_baseline(task, setting);
  EXPECT_EQ(baseline.gains.kp, 123.0);
  EXPECT_EQ(baseline.path.touch_force, 7.0);
  EXPECT_EQ(baseline.path.period, 1e-3);
  EXPECT_EQ(make_admittance(task, setting).gains.damping, 456.0);
}

TEST(PolishingRun, FrictionWithALightWrist_CausesNoRinging) {
  // Without rotors and joint friction, pressing force and sliding are strongly coupled.
  RunSpec spec =
      short_run(has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal, ControllerKind::Mpc);
  spec.task.robot = "arm7";
  spec.task.posture = "ready";
  spec.task.disturbances = disturbance_preset("mismatch");
  spec.task.disturbances.surface_friction = 0.5;
  spec.task.polish_duration = 3.5;
  spec.task.path.start_up = 1.0;
  spec.plan_rate = 0.0;
  spec.robot = load_robot("arm7");
  Model& model = spec.robot->model;
  for (Eigen::VectorXd* figure : {&model.armature, &model.damping, &model.friction})
    figure->setZero();
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  // A ringing arm has 10 N, and no contact for a tenth of the time.
  EXPECT_LT(result.metrics->force_rmse, 1.0);
  EXPECT_EQ(result.metrics->without_contact, 0.0);
}

TEST(PolishingRun, MujocoPlant_PolishesOrIsRefusedIfAbsent) {
  if (!has_mujoco()) {
    const RunSpec spec = short_run(PlantKind::Mujoco, ControllerKind::Mpc);
    expect_words(refusal([&] { run_task(spec); }), {"no MuJoCo", "'ideal'"});
    GTEST_SKIP() << "built without MuJoCo";
  }
  for (const char* surface : {"table", "board"}) {
    RunSpec spec = short_run(PlantKind::Mujoco, ControllerKind::Mpc);
    put_on(spec.task, surface);
    spec.task.disturbances = disturbance_preset("mismatch");
    expect_polished(run_task(spec));
  }
}

TEST(PolishingRun, SameSeed_GivesTheSameBits) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Baseline);
  spec.task.disturbances = disturbance_preset("mismatch");
  const auto force = [&](std::uint64_t seed) {
    spec.task.disturbances.seed = seed;
    return Eigen::VectorXd(run_task(spec).trace.column("tool_force_z_world"));
  };
  const Eigen::VectorXd once = force(3), again = force(3), other = force(4);
  EXPECT_EQ(once, again);
  EXPECT_TRUE(once.size() != other.size() || (once - other).norm() > 0.0);
}

TEST(PolishingRun, Fault_EndsTheRunWithItsReport) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Mpc);
  spec.task.disturbances.pushes = {{0.2, 1.0, {0.0, 0.0, 1000.0}}};
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.succeeded);
  EXPECT_NE(result.fault.kind, FaultKind::None);
  EXPECT_EQ(result.outcome, result.fault.text());
  EXPECT_GT(result.fault.last_second.rows(), 100);
  EXPECT_FALSE(result.metrics.has_value());
  EXPECT_GT(result.trace.rows(), 400);
}

TEST(PolishingRun, MissingSurface_EndsTheBaselineRun) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Baseline);
  spec.task.disturbances.surface_height = -0.5;
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.succeeded);
  EXPECT_FALSE(result.metrics.has_value());
  expect_words(result.outcome, {"no contact was made", "in phase approach"});
}

TEST(PolishingRun, MissingSurface_IsAFaultOfTheController) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Mpc);
  spec.task.disturbances.surface_height = -0.1;
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.succeeded);
  EXPECT_EQ(result.fault.kind, FaultKind::NoContact);
  EXPECT_EQ(result.outcome, result.fault.text());
  expect_words(result.outcome, {"no contact at 2.", "moved 0.03", "m without contact"});
  // The run lasts as long as the controller waits for contact.
  spec.task.tool_limits.late_contact_travel = std::numeric_limits<double>::infinity();
  spec.task.tool_limits.late_contact_time = 5.0;
  spec.task.disturbances.surface_height = -0.3;
  const RunResult late = run_task(spec);
  EXPECT_EQ(late.fault.kind, FaultKind::ContactLate) << late.outcome;
  EXPECT_NEAR(late.fault.time, late.setting.touch - 0.05 + 5.0, 0.01);
}

TEST(PolishingRun, SurfaceOffByACentimetre_IsPolished) {
  for (const double height : {-0.01, 0.01}) {
    RunSpec spec =
        short_run(has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal, ControllerKind::Mpc);
    spec.task.disturbances = disturbance_preset("mismatch");
    spec.task.disturbances.surface_height = height;
    expect_polished(run_task(spec));
  }
}

/// An arm that approaches slowly rests on the surface with a force below the contact threshold.
TEST(PolishingRun, SlowTouch_IsPressedUntilDetected) {
  if (!has_mujoco()) GTEST_SKIP() << "built without MuJoCo";
  RunSpec spec = short_run(PlantKind::Mujoco, ControllerKind::Mpc);
  override_task(spec.task, {"phases.approach_speed=0.004", "phases.clearance=0.004",
                            "limits.contact_threshold=5", "disturbances=sensors"});
  spec.task.polish_duration = 0.5;
  const RunResult result = run_task(spec);
  EXPECT_EQ(result.fault.kind, FaultKind::None) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_NEAR(result.metrics->force_mean, 30.0, 1.0);
}

TEST(PolishingRun, NoisyForce_IsNotTakenForATouch) {
  for (const ControllerKind controller :
       {ControllerKind::Mpc, ControllerKind::Baseline, ControllerKind::Admittance}) {
    RunSpec spec = short_run(PlantKind::Ideal, controller);
    spec.task.polish_duration = 0.5;
    spec.task.disturbances.force_noise = 2.0;
    const RunResult result = run_task(spec);
    EXPECT_TRUE(result.succeeded) << result.outcome;
    const auto phase = result.trace.column("phase"), contact = result.trace.column("in_contact");
    int touch = 0, ramp = 0;
    while (contact[touch] == 0.0) ++touch;
    while (phase[ramp] < static_cast<double>(Phase::Ramp)) ++ramp;
    EXPECT_GE(ramp, touch);
    EXPECT_LE(ramp - touch, 40) << "more than 20 ms late";
  }
}

/// arm7 with a continuous last joint.
class ContinuousWristArm : public ::testing::Test {
 protected:
  void SetUp() override {
    namespace fs = std::filesystem;
    const fs::path arm7 = fs::path(BURNISH_ROBOTS_DIR) / "arm7";
    fs::copy_file(arm7 / "robot.yaml", folder_ / "robot.yaml");
    std::string urdf = testing::contents(arm7 / "arm7.urdf");
    const std::string joint = "\"joint_7\" type=\"revolute\"";
    ASSERT_NE(urdf.find(joint), std::string::npos);
    urdf.replace(urdf.find(joint), joint.size(), "\"joint_7\" type=\"continuous\"");
    scratch_.write("arm7.urdf", urdf);
  }
  testing::Scratch scratch_;
  const std::filesystem::path& folder_ = scratch_.folder;
};

TEST_F(ContinuousWristArm, EveryController_Polishes) {
  for (const ControllerKind controller :
       {ControllerKind::Mpc, ControllerKind::Baseline, ControllerKind::Admittance}) {
    RunSpec spec = short_run(PlantKind::Ideal, controller);
    spec.task.robot = folder_.string();
    spec.task.posture = "ready";
    spec.task.path.radius = 0.02;
    spec.task.update_rate = 200.0;
    const RunResult result = run_task(spec);
    EXPECT_EQ(result.setting.robot.model.nq, 8);
    expect_polished(result);
    EXPECT_GT(result.metrics->joint_margin, 0.0);
  }
}

TEST(PolishingRun, ProgressReturnsFalse_InterruptsTheRun) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Mpc);
  double seen = 0.0;
  spec.progress = [&](double time, double end) {
    seen = time;
    EXPECT_GT(end, 3.0);
    return time < 0.3;
  };
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(result.succeeded);
  EXPECT_GE(seen, 0.3);
  EXPECT_LT(seen, 0.4);
  EXPECT_EQ(result.trace.rows(), static_cast<int>(std::lround(seen / 5e-4)));
}

TEST(PolishingRun, ForceOutOfReach_IsRefusedBeforeTheRun) {
  RunSpec spec = short_run(PlantKind::Ideal, ControllerKind::Mpc);
  spec.task.force = 300.0;
  expect_words(refusal([&] { run_task(spec); }),
               {"more than the largest force of the task, 300 N"});
  spec.task.tool_limits.force = 1000.0;
  spec.task.force = 500.0;
  expect_words(refusal([&] { run_task(spec); }), {"out of reach", "pressing with 500 N"});
}

}  // namespace
}  // namespace burnish::testing

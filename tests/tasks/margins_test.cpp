// Stability margins of the polishing loop, compared with simulations, and gains fitted to an arm.
#include "burnish/tasks/polishing/margins.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "support/mpc_run.hpp"

namespace burnish::test {
namespace {

using polishing::Task;

Task sensed_task(const std::string& robot) {
  Task task = short_task();
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/" + robot;
  task.disturbances = disturbance_preset("sensors");
  task.model_error.transient_scale = 1.0;
  task.update_rate = 1000.0;
  return task;
}

/// Returns true if a short run in MuJoCo ends without a fault.
bool runs_without_fault(const Task& task, double command_delay) {
  MpcCase one{.task = task};
  one.task.disturbances.command_delay = command_delay;
  one.make_plant = [](const Model& model, const SceneSpec& scene) {
    return make_plant(PlantKind::Mujoco, model, scene, 5e-4);
  };
  MpcRun run(one);
  (void)run.polish_and_retreat();
  return run.mpc().fault().kind == FaultKind::None;
}

/// Task of `burnish polish` without a file.
Task first_task() {
  Task task;
  task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm";
  return task;
}

class MarginsInSimulation : public ::testing::TestWithParam<const char*> {};

TEST_P(MarginsInSimulation, DelayMargin_PredictsFaultsWithin25Percent) {
  if (!has_mujoco()) GTEST_SKIP() << "this build has no MuJoCo";
  const Task task = sensed_task(GetParam());
  const auto margins = polishing::margins(task, polishing::make_setting(task), loop_chain(task));
  ASSERT_TRUE(margins);
  const double max_delay = task.disturbances.command_delay + margins->delay();
  EXPECT_LT(max_delay, 7e-3);
  EXPECT_TRUE(runs_without_fault(task, 0.75 * max_delay)) << max_delay;
  EXPECT_FALSE(runs_without_fault(task, 1.25 * max_delay)) << max_delay;
}

INSTANTIATE_TEST_SUITE_P(Arms, MarginsInSimulation, ::testing::Values("talos:right_arm", "arm7"));

TEST(TaskMargins, Text_GainAtItsBound_IsMarked) {
  polishing::TaskMargins margins;
  margins.air = {.delay = 3e-3, .gains = {{"a", 0.1, 3.7}}};
  margins.contact = {.delay = 4e-3, .gains = {{"a", 0.1, 10.0}}};
  EXPECT_EQ(margins.text(),
            "3.0 ms of extra delay (in free air), gains of 0.1 or less (a) to 3.7 (a)");
  margins.air.gains = {{"a", 0.12, 10.0}};
  margins.contact.gains = margins.air.gains;
  EXPECT_EQ(margins.text(),
            "3.0 ms of extra delay (in free air), gains of 0.12 (a) to 10 or more (a)");
}

TEST(TaskMargins, FitGains_DefaultTask_RaisesThePositionWeightOnly) {
  Task task = first_task();
  const polishing::Setting setting = polishing::make_setting(task);
  const polishing::FittedGains fitted = polishing::fit_gains(task, setting);
  const std::string& changes = fitted.changes;
  EXPECT_TRUE(fitted.meets);
  EXPECT_EQ(task.weights.position, 1e5);
  EXPECT_EQ(task.model_error.transient_scale, 6.0);
  EXPECT_EQ(task.model_error.bandwidth, 120.0);
  EXPECT_NEAR(*task.model_error.lag, 1e-3 + 2.5e-4 + 1.0 / (100.0 * std::numbers::pi), 1e-9);
  EXPECT_EQ(task.model_error.force_gain, 0.5);
  EXPECT_EQ(changes.find("model_error"), std::string::npos) << changes;
  EXPECT_NE(changes.find("weights.position 100000 in place of 10000"), std::string::npos)
      << changes;
  EXPECT_GE(polishing::margins(task, setting)->delay(), 2e-3);
}

TEST(TaskMargins, FitGains_WithoutALag_LowersTheTransientScale) {
  Task task = first_task();
  const polishing::Setting setting = polishing::make_setting(task);
  task.model_error.lag = 0.0;
  const std::string changes = polishing::fit_gains(task, setting).changes;
  EXPECT_EQ(task.model_error.transient_scale, 1.5);
  EXPECT_NE(changes.find("model_error.transient_scale 1.5 in place of 6"), std::string::npos)
      << changes;
}

TEST(TaskMargins, FitGains_StiffSurface_LowersTheForceGain) {
  Task task = first_task();
  task.stiffness = 1e6;
  task.damping = 50.0;
  task.model_error.transient_scale = 1.0;
  const polishing::Setting setting = polishing::make_setting(task);
  EXPECT_TRUE(polishing::fit_gains(task, setting).meets);
  EXPECT_LT(task.model_error.force_gain, 0.5);
}

TEST(TaskMargins, Delay_LargeForceGain_IsSmallerInContact) {
  Task task = first_task();
  task.weights.position = 1e5;
  task.model_error = {.bandwidth = 120.0, .transient_scale = 1.0, .lag = 4e-3, .force_gain = 0.5};
  const polishing::Setting setting = polishing::make_setting(task);
  const double usual = polishing::margins(task, setting)->contact.delay;
  task.model_error.force_gain = 3.0;
  EXPECT_LT(polishing::margins(task, setting)->contact.delay, usual - 1e-3);
}

TEST(TaskMargins, FitGains_StatedKeys_StayUnchanged) {
  Task task = first_task();
  const polishing::Setting setting = polishing::make_setting(task);
  task.weights.position = 1e4;
  EXPECT_EQ(polishing::fit_gains(task, setting).changes.find("position"), std::string::npos);
  EXPECT_EQ(task.weights.position, 1e4);
  EXPECT_EQ(task.model_error.transient_scale, 6.0);
  const std::string before = task_text(task);
  EXPECT_EQ(polishing::fit_gains(task, setting).changes, "")
      << "a second call must not change stated keys";
  EXPECT_EQ(task_text(task), before);
}

TEST(TaskMargins, FitGains_OtherDisturbances_ChoosesTheSameGains) {
  Task late = first_task(), ideal = first_task();
  late.disturbances = disturbance_preset("joint_friction");
  late.disturbances.command_delay = 4e-3;
  const polishing::Setting setting = polishing::make_setting(ideal);
  EXPECT_EQ(polishing::fit_gains(late, setting).changes,
            polishing::fit_gains(ideal, setting).changes);
  EXPECT_EQ(late.weights.position, ideal.weights.position);
}

TEST(TaskMargins, FitGains_LongDelay_AlsoSlowsTheObserver) {
  Task task = first_task();
  const polishing::Setting setting = polishing::make_setting(task);
  task.model_error.lag = 0.0;
  const polishing::RequiredMargins required{.delay = 5e-3, .gain = 1.5};
  const std::string changes = polishing::fit_gains(task, setting, required).changes;
  EXPECT_EQ(task.model_error.transient_scale, 1.0);
  EXPECT_LT(task.model_error.bandwidth, 120.0) << changes;
  EXPECT_EQ(task.weights.position, 1e4);
  EXPECT_GE(polishing::margins(task, setting)->delay(), 4.9e-3);
}

TEST(TaskMargins, FitGains_UnattainableMargin_IsReported) {
  Task task = first_task();
  const polishing::Setting setting = polishing::make_setting(task);
  EXPECT_FALSE(polishing::fit_gains(task, setting, {.delay = 2e-3, .gain = 100.0}).meets);
}

TEST(TaskMargins, RobotOnItsFeet_HasNoMargins) {
  Task task = polishing::read_task(std::string(BURNISH_TASKS_DIR) + "/polishing/standing.yaml");
  const polishing::Setting setting = polishing::make_setting(task);
  EXPECT_FALSE(polishing::margins(task, setting));
  EXPECT_EQ(polishing::fit_gains(task, setting).changes, "");
  EXPECT_EQ(task.weights.position, 1e4);
  EXPECT_EQ(task.model_error.transient_scale, 2.0) << "the value in the file must stay";
  EXPECT_EQ(task.model_error.lag, 0.0);
  EXPECT_EQ(task.model_error.force_gain, 0.0);
}

}  // namespace
}  // namespace burnish::test

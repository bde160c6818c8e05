// Joints without a rotor inertia: reported before a run, or given an assumed one.
#include "polishing/rotors.hpp"

#include <gtest/gtest.h>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "support/six_joint_arm.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

/// Task of an arm on a table under the preset `mismatch`, with a given inertia of the last link.
struct Arm {
  explicit Arm(double inertia, const std::vector<std::string>& overrides = {}) {
    task.robot =
        scratch.write("arm.urdf", six_joint_arm({.mass_at = 0.02, .inertia = inertia})).string();
    task.tool = "flange";
    put_on(task, "table");
    task.disturbances = disturbance_preset("mismatch");
    override_task(task, {"phases.polish_duration=0.5", "phases.reach_duration=0.2"});
    override_task(task, overrides);
  }
  Scratch scratch;
  Task task;
};

TEST(Rotors, LightWrist_IsNamedWithALineToPaste) {
  const Arm arm(3e-5);
  const std::vector<LightJoint> light = light_joints(arm.task, make_setting(arm.task));
  ASSERT_EQ(light.size(), 1U);
  EXPECT_EQ(light[0].joint, "j6");
  EXPECT_NEAR(light[0].inertia, 3e-5, 1e-6);
  EXPECT_GT(light[0].speed, light[0].limit);
  EXPECT_NEAR(light[0].armature, 2e-3 * 28.0 / 3.0, 1e-12);
  expect_words(light_joints_text(light),
               {"joint 'j6' (", "torque noise alone", "limit 3.6",
                "in robot.yaml, such as joints: {j6: {armature: 0.0186667}}"});
}

TEST(Rotors, UsualWristOrNoNoise_NamesNoJoint) {
  const Arm usual(1e-3);
  EXPECT_TRUE(light_joints(usual.task, make_setting(usual.task)).empty());
  const Arm ideal(3e-5, {"disturbances=none"});
  EXPECT_TRUE(light_joints(ideal.task, make_setting(ideal.task)).empty());
}

TEST(Rotors, LightWrist_PressesOnlyWithAnAssumedRotor) {
  Arm arm(3e-5);
  const RunResult bare = run_task({.task = arm.task});
  EXPECT_EQ(bare.fault.kind, FaultKind::SpeedLimit);
  EXPECT_TRUE(bare.setting.assumed_rotors.empty());
  arm.task.assume_rotors = true;
  const RunResult result = run_task({.task = arm.task});
  EXPECT_EQ(result.fault.kind, FaultKind::None) << result.outcome;
  ASSERT_EQ(result.setting.assumed_rotors.size(), 1U);
  EXPECT_EQ(assumed_rotors_text(result.setting), "joint 'j6' 0.0186667 kg m^2");
  EXPECT_TRUE(light_joints(arm.task, result.setting).empty());
}

TEST(Rotors, WristTooLightForTheControlLoop_IsNamed) {
  const Arm arm(1.2e-4);
  EXPECT_EQ(light_joints(arm.task, make_setting(arm.task)).size(), 1U);
}

TEST(Rotors, UsualWrist_GetsNoAssumedRotor) {
  Arm arm(1e-3);
  arm.task.assume_rotors = true;
  const Setting setting = make_setting(arm.task);
  EXPECT_TRUE(setting.assumed_rotors.empty());
  EXPECT_TRUE(setting.robot.model.armature.isZero(0.0));
}

}  // namespace
}  // namespace burnish::testing

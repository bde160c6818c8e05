// Pressing at a point while the arm moves aside: the file, and closed loops on both plants.
#include "burnish/tasks/press_hold/press_hold.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"

namespace burnish::press_hold {
namespace {

using testing::expect_words;
using testing::refusal;

Task arm7_task() {
  Task task = read_task(BURNISH_TASKS_DIR "/press_hold/arm7.yaml");
  task.robot = BURNISH_ROBOTS_DIR "/arm7";
  return task;
}

TEST(PressHold, holds_force_and_point_while_the_arm_moves_aside) {
  for (const PlantKind plant : {PlantKind::Ideal, PlantKind::Mujoco}) {
    if (plant == PlantKind::Mujoco && !has_mujoco()) continue;
    SCOPED_TRACE(name_of(plant));
    const RunResult run = run_task(arm7_task(), plant);
    EXPECT_TRUE(run.done) << run.outcome;
    ASSERT_TRUE(run.metrics) << run.outcome;
    EXPECT_GT(run.moved, 0.2) << "the posture does not go aside";
    EXPECT_LT(run.slip, 2e-3);
    EXPECT_LT(run.metrics->force_rmse, 0.5);
    EXPECT_EQ(run.metrics->without_contact, 0.0);
    // Through all phases, and off in the end.
    const Trace::Column phase = run.trace.column("phase");
    EXPECT_EQ(phase[run.trace.rows() - 1], 4.0);
    EXPECT_EQ(run.trace.column("in_contact")[run.trace.rows() - 1], 0.0);
  }
}

TEST(PressHold, waits_for_a_surface_that_is_farther_than_known) {
  Task task = arm7_task();
  task.surface_height = -0.01;
  const RunResult run = run_task(task, PlantKind::Ideal);
  EXPECT_TRUE(run.done) << run.outcome;
  task.surface_height = -0.1;
  const RunResult nothing = run_task(task, PlantKind::Ideal);
  EXPECT_FALSE(nothing.done);
  EXPECT_EQ(nothing.fault.kind, FaultKind::NoContact) << nothing.outcome;
}

TEST(PressHold, is_given_up_when_the_tool_slips) {
  Task task = arm7_task();
  task.slip = 2e-5;
  const RunResult run = run_task(task, PlantKind::Ideal);
  EXPECT_FALSE(run.done);
  EXPECT_EQ(run.fault.kind, FaultKind::Watched) << run.outcome;
  expect_words(run.outcome, {"slip of the tool, m", "allowed is 2e-05"});
}

TEST(PressHold, writes_a_file_that_reads_back) {
  Task task = arm7_task();
  task.posture = "bent";
  task.aside = {{"joint_3", -0.25}, {"joint_5", 0.5}};
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.robot, task.robot);
  EXPECT_EQ(back.aside, task.aside);
  EXPECT_EQ(back.mass_scale, 1.05);
}

TEST(PressHold, ends_when_it_is_told_to) {
  const RunResult run = run_task(arm7_task(), PlantKind::Ideal,
                                 [](double time, double end) { return time < 0.1 && end > 3.0; });
  EXPECT_FALSE(run.done);
  expect_words(run.outcome, {"interrupted at 0.1"});
}

TEST(PressHold, refuses_what_it_cannot_read_or_do) {
  const auto refused = [](const std::string& text) {
    return refusal([&] { make_setting(parse_task(text, "my.yaml")); });
  };
  expect_words(refused("force: 3\n"), {"my.yaml", "task"});
  expect_words(refused("task: press_hald\n"), {"my.yaml: line 1", "press_hold"});
  expect_words(refused("task: press_hold\nforse: 3\n"), {"my.yaml: line 2", "forse", "force"});
  expect_words(refused("task: press_hold\nforce: -3\n"), {"line 2", "force", "-3"});
  expect_words(refused("task: press_hold\nnormal: [0, 0, 0]\n"), {"line 2", "normal"});
  expect_words(refused("task: press_hold\nforce: 3\n"), {"touch_force of 5 N", "force of 3 N"});
  const std::string robot = std::string("task: press_hold\nrobot: ") + BURNISH_ROBOTS_DIR "/arm7\n";
  EXPECT_EQ(refused(robot), "");
  expect_words(refused(robot + "aside: {joint_33: 1}\n"), {"joint_33", "joint_3"});
  expect_words(refused(robot + "aside: {joint_3: 9}\n"), {"joint_3", "beyond its limits"});
  expect_words(refused(robot + "tool: tol\n"), {"tol"});
}

}  // namespace
}  // namespace burnish::press_hold

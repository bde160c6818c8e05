// Pressing at a point while the arm moves aside: the task file, and closed loops on both plants.
#include "burnish/tasks/press_hold/press_hold.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "press_hold/descriptions.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::press_hold {
namespace {

using testing::expect_words;
using testing::refusal;

const std::string shipped = BURNISH_TASKS_DIR "/press_hold/arm7.yaml";
const std::string arm7 = BURNISH_ROBOTS_DIR "/arm7";

Task arm7_task() { return read_task(shipped, {"robot=" + arm7}); }

RunResult run(const Task& task, PlantKind plant = PlantKind::Ideal) {
  return run_task({.task = task, .plant = plant});
}

TEST(PressHold, ArmMovesAside_KeepsForceAndPoint) {
  for (const PlantKind plant : {PlantKind::Ideal, PlantKind::Mujoco}) {
    if (plant == PlantKind::Mujoco && !has_mujoco()) continue;
    SCOPED_TRACE(name_of(plant));
    const RunResult result = run(arm7_task(), plant);
    EXPECT_TRUE(result.succeeded) << result.outcome;
    ASSERT_TRUE(result.metrics && result.hold) << result.outcome;
    EXPECT_GT(result.hold->moved_aside, 0.2) << "the arm does not move aside";
    EXPECT_LT(result.hold->slip, 2e-3);
    EXPECT_LT(result.metrics->force_rmse, 0.5);
    EXPECT_EQ(result.metrics->without_contact, 0.0);
    EXPECT_GT(result.plans.time.size(), 20U);
    EXPECT_GT(result.ticks.count, 3000);
    // The run passes through all phases, and the tool leaves the surface in the end.
    const Trace::Column phase = result.trace.column("phase");
    EXPECT_EQ(phase[result.trace.rows() - 1], 4.0);
    EXPECT_EQ(result.trace.column("in_contact")[result.trace.rows() - 1], 0.0);
  }
}

TEST(PressHold, AnotherRobot_SearchesAPostureAndMovesItsThirdJoint) {
  Task task = read_task(shipped, {std::string("robot=") + BURNISH_ROBOTS_DIR + "/talos:right_arm"});
  const Robot robot = load_task_robot(task);
  expect_words(refusal([&] { make_setting(task, robot); }), {"posture", "'ready'"});
  const std::vector<std::string> changes = fit_to_robot(task, robot);
  ASSERT_EQ(changes.size(), 2U);
  expect_words(changes[0], {"posture: robot 'talos' does not have the posture 'ready'", "found"});
  expect_words(changes[1], {"aside: ", "'joint_3'", "moves instead, by", " rad"});
  EXPECT_EQ(task.posture, searched_posture);
  ASSERT_EQ(task.aside.size(), 1U);
  EXPECT_GT(std::abs(task.aside.begin()->second), 0.1);
  EXPECT_NO_THROW(refuse_out_of_reach(task, make_setting(task, robot)));
  // A task that fits its robot stays unchanged.
  Task own = arm7_task();
  EXPECT_TRUE(fit_to_robot(own, load_task_robot(own)).empty());
  EXPECT_EQ(task_text(own), task_text(arm7_task()));
}

TEST(PressHold, SurfaceFarther_WaitsOrReportsNoContact) {
  Task task = arm7_task();
  task.disturbances.surface_height = -0.01;
  const RunResult result = run(task);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  task.disturbances.surface_height = -0.1;
  const RunResult nothing = run(task);
  EXPECT_FALSE(nothing.succeeded);
  EXPECT_EQ(nothing.fault.kind, FaultKind::NoContact) << nothing.outcome;
}

TEST(PressHold, ToolSlip_StopsTheRun) {
  Task task = arm7_task();
  task.slip = 2e-5;
  const RunResult result = run(task);
  EXPECT_FALSE(result.succeeded);
  EXPECT_EQ(result.fault.kind, FaultKind::Watched) << result.outcome;
  expect_words(result.outcome, {"slip of the tool, m", "allowed is 2e-05"});
}

TEST(PressHold, ProgressReturnsFalse_InterruptsTheRun) {
  RunSpec spec{.task = arm7_task(), .plant = PlantKind::Ideal};
  spec.progress = [](double time, double end) { return time < 0.1 && end > 3.0; };
  const RunResult result = run_task(spec);
  EXPECT_FALSE(result.succeeded);
  EXPECT_TRUE(result.interrupted);
  expect_words(result.outcome, {"interrupted at 0.1", "in phase approach"});
}

TEST(PressHold, RobotWithoutPostures_SearchesOne) {
  Task task = arm7_task();
  task.robot = arm7 + "/arm7.urdf";
  task.tool = "flange";
  task.posture = "";
  const Setting setting = make_setting(task);
  EXPECT_TRUE(setting.robot.postures.empty());
  EXPECT_TRUE(check_reach(task, setting).ok());
  EXPECT_EQ(make_setting(task).q_start, setting.q_start) << "two searches give different postures";
  task.search.tilt = 0.0;
  expect_words(refusal([&] { make_setting(task); }), {"posture: no posture was found"});
}

TEST(PressHold, ForceBeyondTheArm_IsRefused) {
  Task task = arm7_task();
  task.force = 2000.0;
  task.tool_limits.force = 5000.0;
  const std::string sentence = refusal([&] { run(task); });
  expect_words(sentence, {"out of reach: at the point, with the tool at", "pressing with 2000 N"});
}

TEST(PressHold, WrittenTask_ReadsBackUnchanged) {
  EXPECT_EQ(testing::contents(shipped), task_text(read_task(shipped)))
      << "burnish run tasks/press_hold/arm7.yaml --write-task FILE updates it";
  Task task = arm7_task();
  task.posture = "bent";
  task.tool_axis = Eigen::Vector3d(0.0, 1.0, 0.0);
  task.slip = range::end;
  task.aside = {{"joint_3", -0.25}, {"a joint: #5", 0.5}};
  const Task back = parse_task(task_text(task), "back.yaml");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.aside, task.aside);
  EXPECT_EQ(back.slip, range::end);
  EXPECT_EQ(back.disturbances.mass_scale, 1.05);
}

TEST(PressHold, PresetsAndOverrides_AreApplied) {
  const Task task = parse_task("task: press_hold\ndisturbances: sensors\n", "my.yaml",
                               {"disturbances.seed=7", "aside={joint_1: 0.1}", "tool.frame=tip"});
  EXPECT_EQ(task.disturbances.encoder_bits, 17);
  EXPECT_EQ(task.disturbances.seed, 7U);
  EXPECT_EQ(task.aside.at("joint_1"), 0.1);
  EXPECT_EQ(task.tool, "tip");
  expect_words(refusal([] { parse_task("task: press_hold\n", "my.yaml", {"forse=3"}); }),
               {"override 'forse=3'", "forse", "force"});
}

TEST(PressHold, InvalidFile_RefusalNamesTheLine) {
  const auto refused = [](const std::string& text, const std::vector<std::string>& overrides = {}) {
    return refusal([&] {
      const auto parsed = files::parse_said<Task>(text, "my.yaml", overrides);
      files::placed(parsed.texts, [&] {
        check_task(parsed.spec);
        make_setting(parsed.spec);
      });
    });
  };
  expect_words(refused("force: 3\n"), {"my.yaml", "task: press_hold"});
  expect_words(refused("task: press_hald\n"), {"my.yaml: line 1: task", "press_hold"});
  expect_words(refused("task: press_hold\nforse: 3\n"), {"my.yaml: line 2", "forse", "force"});
  expect_words(refused("task: press_hold\nforce: -3\n"), {"line 2: force", "-3"});
  expect_words(refused("task: press_hold\nsurface: {normal: [0, 0, 0]}\n"),
               {"line 2: surface.normal"});
  expect_words(refused("task: press_hold\nphases: {touch_force: 50}\n"),
               {"my.yaml: line 2: phases.touch_force: it is 50 N", "force of 20 N"});
  expect_words(
      refused("task: press_hold\nphases: {aside_duration: 0.2, hold_duration: 0.1}\n"),
      {"line 2: phases.hold_duration: it is 0.1 s, and 0.3 s together with phases.aside_duration",
       "0.5 s"});
  expect_words(refused("task: press_hold\naside: 3\n"), {"line 2: aside"});
  expect_words(refused("task: press_hold\nrobot: arm8\n"), {"my.yaml: line 2: robot", "arm8"});
  const std::string robot = "task: press_hold\nrobot: " + arm7 + "\n";
  EXPECT_EQ(refused(robot), "");
  expect_words(refused(robot + "tool: {frame: tol}\n"),
               {"my.yaml: line 3: tool.frame: ", "'tol'", "did you mean 'tool'?"});
  expect_words(refused(robot + "posture: redy\n"), {"my.yaml: line 3: posture: ", "'ready'"});
  expect_words(refused(robot + "aside: {joint_33: 1}\n"),
               {"my.yaml: line 3: aside.joint_33: ", "joint_3"});
  expect_words(refused(robot + "aside:\n  joint_1: 0.1\n  joint_3: 9\n"),
               {"my.yaml: line 5: aside.joint_3: ", "joint_3", "within its limits"});
  expect_words(refused(robot, {"posture=redy"}), {"override 'posture=redy': posture: ", "'ready'"});
  expect_words(refused("task: press_hold\nrobot: " + arm7 + ":floating\n"),
               {"my.yaml: line 2: robot: ", "floats free"});
}

}  // namespace
}  // namespace burnish::press_hold

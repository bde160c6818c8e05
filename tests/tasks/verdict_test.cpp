// Criteria of the verdict "polished": runs without a fault that nevertheless fail.
#include "polishing/verdict.hpp"

#include <gtest/gtest.h>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

constexpr double never = std::numeric_limits<double>::infinity();

/// Run of 1.5 s on the ideal plant with the baseline controller, which never faults.
RunSpec faultless_run() {
  RunSpec spec;
  put_on(spec.task, "table");
  spec.task.polish_duration = 1.5;
  spec.task.path.start_up = 0.5;
  spec.plant = PlantKind::Ideal;
  spec.controller = ControllerKind::Baseline;
  return spec;
}

/// Expects a complete run that did not polish, with `words` in its outcome.
void expect_failed(const RunResult& result, const std::vector<std::string>& words) {
  EXPECT_FALSE(result.succeeded);
  EXPECT_EQ(result.fault.kind, FaultKind::None);
  EXPECT_EQ(result.plant_status, Status::Ok);
  ASSERT_TRUE(result.verdict.has_value());
  expect_words(result.outcome, words);
}

TEST(PolishingVerdict, PlainRun_Passes) {
  const RunResult result = run_task(faultless_run());
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.verdict.has_value());
  EXPECT_EQ(result.verdict->contact_share, 1.0);
  EXPECT_LT(result.verdict->force_rmse, 1.0);
  EXPECT_NEAR(result.verdict->path_share, 1.0, 2e-3);
}

TEST(PolishingVerdict, LostContact_Fails) {
  RunSpec spec = faultless_run();
  spec.task.disturbances.pushes = {{1.6, 1.0, {0.0, 0.0, 100.0}}};
  const RunResult result = run_task(spec);
  expect_failed(result, {"not polished: in contact for ", "verdict.contact_share requires 99 %"});
  EXPECT_LT(result.verdict->contact_share, 0.9);
  // Without requirements on contact, force and path, joint limits decide.
  spec.task.verdict = {.contact_share = 0.0, .force_rmse = never, .path_share = 0.0};
  expect_words(run_task(spec).outcome, {"not polished: joint '", "beyond its limit"});
  spec.robot = load_task_robot(spec.task);
  spec.robot->model.q_lower.setConstant(-10.0);
  spec.robot->model.q_upper.setConstant(10.0);
  EXPECT_TRUE(run_task(spec).succeeded);
}

TEST(PolishingVerdict, ForceError_Fails) {
  RunSpec spec = faultless_run();
  spec.task.disturbances.pushes = {{1.5, 0.3, {0.0, 0.0, -12.0}}};
  spec.task.verdict.force_rmse = 1e-3;
  const RunResult result = run_task(spec);
  expect_failed(result, {"not polished: the force was off by ", "of 30 N",
                         "verdict.force_rmse allows 0.1 %"});
  EXPECT_GT(result.verdict->force_rmse, 0.03);
}

TEST(PolishingVerdict, PathMissed_Fails) {
  RunSpec spec = faultless_run();
  spec.task.disturbances.pushes = {{0.0, 100.0, {60.0, 0.0, 0.0}}};
  spec.task.baseline.kp = 900.0;  // low stiffness, so that the push displaces the tool
  spec.task.baseline.kd = 60.0;
  spec.task.baseline.ki_position = 0.0;
  spec.task.tip_radius = 0.005;
  spec.task.verdict = {.contact_share = 0.0, .force_rmse = never};
  const RunResult result = run_task(spec);
  expect_failed(result, {"not polished: the tool followed ", "verdict.path_share requires 99 %"});
  EXPECT_LT(result.verdict->path_share, 0.5);
}

TEST(PolishingVerdict, JointBeyondItsLimit_Fails) {
  RunSpec spec = faultless_run();
  Robot robot = load_task_robot(spec.task);
  const Setting setting = make_setting(spec.task, robot);
  // The path needs a wider range of the joint.
  const int elbow = robot.model.joints[3].q_index;
  robot.model.q_upper[elbow] = setting.q_start[elbow] + 5e-3;
  robot.model.q_lower[elbow] = setting.q_start[elbow] - 5e-3;
  spec.robot = robot;
  spec.check_reach = false;
  const RunResult result = run_task(spec);
  expect_failed(result, {"not polished: joint '" + robot.model.joints[3].name + "' was ",
                         " rad beyond its limit at "});
}

TEST(PolishingVerdict, PathTooLongForItsTime_IsJudgedOnItsReachablePart) {
  RunSpec spec = faultless_run();
  spec.task.path.kind = PathKind::Points;
  spec.task.path.points = {{0.05, 0.0}, {0.05, 0.5}, {-0.05, 0.5}, {-0.05, 0.0}};
  spec.check_reach = false;
  EXPECT_NEAR(path_time(spec.task), (0.05 + 0.5 + 0.1 + 0.5) / 0.07 * 1.875, 1e-9);
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  expect_words(result.outcome, {"polished: ", "cut short: ", "of the path in 1.5 s",
                                "the whole path takes 30.8 s"});
  EXPECT_NEAR(result.verdict->path_share, 0.05 / 1.15, 0.02);
  EXPECT_NEAR(result.verdict->path_allowed, result.verdict->path_share, 2e-3);
  VerdictFigures half = *result.verdict;
  half.path_share *= 0.5;
  expect_words(verdict_failure(spec.task, half), {"not polished: the tool followed ",
                                                  "while its time is enough for ", "cut short: "});
  // The notes of the task warn before the run.
  const std::vector<std::string> notes = task_notes(spec.task, true);
  ASSERT_EQ(notes.size(), 1U);
  expect_words(notes[0], {"the path takes 30.9 s", "phases.polish_duration is 1.5 s",
                          "covers only the first part of the path"});
}

TEST(PolishingVerdict, SeveralFailures_AreAllNamed) {
  const Task task;
  EXPECT_EQ(verdict_failure(task, {.contact_share = 0.99, .force_rmse = 3.0, .path_share = 0.99}),
            "");
  EXPECT_EQ(verdict_failure(task, {.contact_share = 0.32, .force_rmse = 22.9, .path_share = 0.5}),
            "not polished: in contact for 32 % of the time on the path (verdict.contact_share "
            "requires 99 %); the force was off by 22.9 N rms, 76.33 % of 30 N (verdict.force_rmse "
            "allows 10 "
            "%); the tool followed 50 % of the path (verdict.path_share requires 99 %)");
  const double nan = std::nan("");
  expect_words(verdict_failure(task, {.contact_share = nan, .force_rmse = nan, .path_share = nan}),
               {"verdict.contact_share", "verdict.force_rmse", "verdict.path_share"});
}

TEST(PolishingVerdict, StationaryPath_Passes) {
  RunSpec spec = faultless_run();
  spec.task.path.kind = PathKind::Points;
  spec.task.path.points = {{0.0, 0.0}};
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  EXPECT_EQ(result.verdict->path_share, 1.0);
}

}  // namespace
}  // namespace burnish::testing

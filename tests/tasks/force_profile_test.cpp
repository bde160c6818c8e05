// Force profiles along the path: values, refusals, and runs of the controllers.
#include "burnish/tasks/polishing/force_profile.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;
using Kind = ForceProfile::Kind;

Task task_with(const std::string& profile) {
  return parse_task("force: 20\nforce_profile: " + profile + "\n", "task");
}
double force_at(const Task& task, double t) { return task.force_profile.at(task.force, t); }

TEST(ForceProfile, StepsLinesAndSine_GiveTheirForces) {
  const Task steps = task_with("{kind: steps, points: [[1, 30], [2, 10]]}");
  EXPECT_EQ(force_at(steps, -1.0), 20.0);
  EXPECT_EQ(force_at(steps, 0.999), 20.0);
  EXPECT_EQ(force_at(steps, 1.0), 30.0);
  EXPECT_EQ(force_at(steps, 2.0), 10.0);
  EXPECT_EQ(force_at(steps, 9.0), 10.0);
  EXPECT_EQ(steps.force_profile.min_force(20.0), 10.0);
  EXPECT_EQ(steps.force_profile.max_force(20.0), 30.0);
  const Task lines = task_with("{kind: lines, points: [[1, 30], [3, 10]]}");
  EXPECT_EQ(force_at(lines, -1.0), 20.0);
  EXPECT_NEAR(force_at(lines, 0.5), 25.0, 1e-12);
  EXPECT_NEAR(force_at(lines, 1.5), 25.0, 1e-12);
  EXPECT_EQ(force_at(lines, 4.0), 10.0);
  const Task sine = task_with("{kind: sine, amplitude: 5, frequency: 2, start: 1}");
  EXPECT_EQ(force_at(sine, 0.5), 20.0);
  EXPECT_NEAR(force_at(sine, 1.125), 25.0, 1e-12);
  EXPECT_EQ(sine.force_profile.min_force(20.0), 15.0);
  EXPECT_EQ(force_at(task_with("constant"), 3.0), 20.0);
}

TEST(ForceProfile, WrittenProfile_ReadsBackAndTakesOverrides) {
  Task task = task_with("{kind: lines, points: [[0.5, 12.5], [1, 7]], preview: false}");
  const Task back = parse_task(task_text(task), "again");
  EXPECT_EQ(task_text(back), task_text(task));
  EXPECT_EQ(back.force_profile.points[1], Eigen::Vector2d(1.0, 7.0));
  EXPECT_FALSE(back.force_profile.preview);
  override_task(task, {"force_profile.kind=sine", "force_profile.amplitude=3"});
  EXPECT_EQ(task.force_profile.kind, Kind::Sine);
  EXPECT_EQ(task.force_profile.amplitude, 3.0);
}

TEST(ForceProfile, InvalidProfile_IsRefused) {
  const auto refused = [](const std::string& profile, const std::vector<std::string>& words) {
    expect_words(refusal([&] { task_with(profile); }), words);
  };
  refused("{kind: steps}", {"force_profile", "kind steps has no points"});
  refused("{kind: steps, points: [[1, -5]]}", {"points[0]", "-5 N", "more than 0"});
  refused("{kind: lines, points: [[1, 5], [1, 6]]}", {"points[1]", "more than 1 s"});
  refused("{kind: lines, points: [[-1, 5]]}", {"points[0]", "-1 s", "the start of the path"});
  refused("{kind: sine, amplitude: 20}", {"amplitude of 20 N about 20 N", "zero or negative"});
  refused("{kind: steps, points: [[1, 150]]}",
          {"largest force of the task, 150 N", "limits.force"});
  refused("{kind: stairs}", {"stairs", "did you mean 'steps'"});
}

/// Run that presses at one point.
RunSpec pressing(const ForceProfile& profile, ControllerKind controller) {
  RunSpec spec;
  put_on(spec.task, "table");
  spec.plant = PlantKind::Ideal;
  spec.controller = controller;
  spec.task.force = 20.0;
  spec.task.force_profile = profile;
  spec.task.path.kind = PathKind::Points;
  spec.task.path.points = {Eigen::Vector2d::Zero()};
  spec.task.polish_duration = 1.5;
  spec.task.reach_duration = 0.2;
  spec.task.update_rate = 200.0;
  spec.task.verdict.force_rmse = 1.0;
  return spec;
}

/// Returns the true force `since` seconds after the start of the path [N].
double true_force(const RunResult& result, double since) {
  const Trace& trace = result.trace;
  const Trace::Column time = trace.column("time"), phase = trace.column("phase");
  Eigen::Index row = 0;
  while (phase[row] != static_cast<double>(Phase::Track)) ++row;
  const double at = time[row] + since;
  while (time[row] < at) ++row;
  return trace.column("tool_force_z_world")[row];
}

TEST(ForceProfile, ForceStep_EveryControllerFollows) {
  const ForceProfile steps{.kind = Kind::Steps, .points = {{0.5, 30.0}}};
  for (const ControllerKind controller : {ControllerKind::Mpc, ControllerKind::Baseline}) {
    const RunResult result = run_task(pressing(steps, controller));
    EXPECT_TRUE(result.succeeded) << result.outcome;
    EXPECT_NEAR(true_force(result, 0.2), 20.0, 0.5) << name_of(controller);
    EXPECT_NEAR(true_force(result, 1.4), 30.0, 0.5) << name_of(controller);
    const Trace::Column target = result.trace.column("target_force");
    EXPECT_EQ(target.maxCoeff(), 30.0);
  }
}

TEST(ForceProfile, NoPreview_ForceChangesOnlyAfterTheStep) {
  ForceProfile steps{.kind = Kind::Steps, .points = {{0.5, 30.0}}};
  const RunResult with_preview = run_task(pressing(steps, ControllerKind::Mpc));
  steps.preview = false;
  const RunResult without_preview = run_task(pressing(steps, ControllerKind::Mpc));
  EXPECT_TRUE(without_preview.succeeded) << without_preview.outcome;
  const double before = 0.495;
  EXPECT_NEAR(true_force(without_preview, before), 20.0, 0.05);
  EXPECT_NEAR(true_force(without_preview, 1.4), 30.0, 0.5);
  // With preview, the force rises no later than without.
  EXPECT_GE(true_force(with_preview, 0.502), true_force(without_preview, 0.502) - 0.05);
}

}  // namespace
}  // namespace burnish::testing

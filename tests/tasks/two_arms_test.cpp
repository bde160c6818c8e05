// Two arms: one hand holds and moves a plate, the other polishes it.
#include <gtest/gtest.h>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

RunSpec plate_run() {
  RunSpec spec;
  spec.task = read_task(BURNISH_TASKS_DIR "/polishing/two_arms.yaml");
  spec.task.disturbances.seed = 3;
  spec.task.polish_duration = 3.0;
  return spec;
}

double span(const Trace& trace, const char* column) {
  const Trace::Column x = trace.column(column);
  return x.maxCoeff() - x.minCoeff();
}

TEST(TwoArms, MovingPlate_IsPolished) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  const RunResult result = run_task(plate_run());
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_LT(result.metrics->force_rmse, 0.5);
  EXPECT_LT(result.metrics->position_rmse, 1e-3);
  EXPECT_LT(result.metrics->normal_error, 1e-3);
  EXPECT_EQ(result.metrics->without_contact, 0.0);
  // The plate moved by 10 cm and turned by 20 degrees from side to side.
  EXPECT_GT(span(result.trace, "surface_y_world"), 0.08);
  EXPECT_GT(span(result.trace, "surface_normal_x_world"), 0.3);
}

TEST(TwoArms, PlateTiltAndHeightErrors_AreEstimated) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  RunSpec spec = plate_run();
  spec.task.shape = {.kind = SurfaceShape::Kind::Sphere, .radius = 0.3};
  spec.task.disturbances.surface_tilt_deg = {3.0, -2.0};
  spec.task.disturbances.surface_height = 3e-3;
  const RunResult estimated = run_task(spec);
  EXPECT_TRUE(estimated.succeeded) << estimated.outcome;
  spec.task.surface_estimate.enabled = false;
  const RunResult nominal = run_task(spec);
  ASSERT_TRUE(estimated.metrics && nominal.metrics);
  EXPECT_LT(estimated.metrics->force_rmse, 0.5);
  EXPECT_LT(3.0 * estimated.metrics->normal_error, nominal.metrics->normal_error);
}

TEST(TwoArms, InvalidTask_IsRefusedBeforeTheRun) {
  const auto refused = [](const std::vector<std::string>& words, const auto& change) {
    RunSpec spec = plate_run();
    change(spec);
    expect_words(refusal([&] { run_task(spec); }), words);
  };
  refused({"surface.frame", "plait", "plate"},
          [](RunSpec& spec) { spec.task.surface_frame = "plait"; });
  refused({"posture", "the search does not support a surface that the robot carries"},
          [](RunSpec& spec) { spec.task.posture = "search"; });
  refused({"surface.frame", "without a plan", "mpc"},
          [](RunSpec& spec) { spec.controller = ControllerKind::Baseline; });
  refused({"ideal plant", "carries"}, [](RunSpec& spec) { spec.plant = PlantKind::Ideal; });
}

}  // namespace
}  // namespace burnish::testing

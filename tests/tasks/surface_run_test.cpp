// Runs on surfaces of every shape, equal to or different from the nominal surface.
#include <gtest/gtest.h>

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;
using Kind = SurfaceShape::Kind;

RunSpec short_run(const SurfaceShape& shape = {}) {
  RunSpec spec;
  put_on(spec.task, "table");
  spec.task.shape = shape;
  spec.task.disturbances = disturbance_preset("mismatch");
  spec.task.disturbances.seed = 7;
  spec.task.polish_duration = 2.0;
  spec.task.path.rate = 2.0;
  spec.task.path.start_up = 1.0;
  spec.task.update_rate = 200.0;
  return spec;
}

std::vector<SurfaceShape> shapes() {
  return {{.kind = Kind::Sphere, .radius = 0.15},
          {.kind = Kind::Sphere, .radius = 0.4, .hollow = true},
          {.kind = Kind::Cylinder, .radius = 0.2, .turn_deg = 40.0},
          {.kind = Kind::Cone, .radius = 0.3, .half_angle = 0.4},
          {.kind = Kind::Torus, .radius = 0.2, .ring = 0.4},
          {.kind = Kind::Ellipsoid, .semi_axes = {0.3, 0.4, 0.3}},
          {.kind = Kind::Saddle, .curvature = {2.0, -3.0}}};
}

class PolishedShape : public ::testing::TestWithParam<SurfaceShape> {};

TEST_P(PolishedShape, Run_FollowsTheNormalOfTheShape) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  const RunResult result = run_task(short_run(GetParam()));
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_LT(result.metrics->force_rmse, 0.5);
  EXPECT_LT(result.metrics->position_p95, 1e-3);
  EXPECT_LT(result.metrics->normal_error, 0.01);
  EXPECT_EQ(result.metrics->without_contact, 0.0);
  // The tool turned with the normal.
  EXPECT_GT(result.metrics->orientation_drift, 0.05);
}

INSTANTIATE_TEST_SUITE_P(shapes, PolishedShape, ::testing::ValuesIn(shapes()),
                         [](const auto& test) {
                           return std::string(test.param.hollow ? "hollow_" : "") +
                                  name_of(test.param.kind);
                         });

TEST(SurfaceRun, TiltAndCurvatureErrors_AreEstimated) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  for (const SurfaceShape& shape : {SurfaceShape{}, shapes()[0]}) {
    RunSpec spec = short_run(shape);
    spec.task.disturbances.surface_tilt_deg = {5.0, -4.0};
    spec.task.disturbances.surface_height = 3e-3;
    spec.task.disturbances.surface_curvature = 1.2;
    const RunResult estimated = run_task(spec);
    EXPECT_TRUE(estimated.succeeded) << estimated.outcome;
    spec.task.surface_estimate.enabled = false;
    const RunResult nominal = run_task(spec);
    ASSERT_TRUE(estimated.metrics && nominal.metrics);
    EXPECT_LT(3.0 * estimated.metrics->force_rmse, nominal.metrics->force_rmse);
    EXPECT_LT(3.0 * estimated.metrics->normal_error, nominal.metrics->normal_error);
  }
}

TEST(SurfaceRun, SoftTiltedSurface_PathFollowsTheTrueNormal) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  RunSpec spec = short_run();
  spec.task.disturbances = {};
  spec.task.disturbances.surface_tilt_deg = {6.0, 0.0};
  // The tool sinks in by 5 mm; along the wrong normal, a tenth of it would be an error of the path.
  spec.task.stiffness = 6e3;
  spec.task.path.rate = 1.0;
  spec.task.path.start_up = 2.0;
  spec.task.polish_duration = 4.0;
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_LT(result.metrics->position_rmse, 1.5e-4);
}

TEST(SurfaceRun, NoForceSensor_StillPolishes) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  RunSpec spec = short_run();
  spec.task.force_sensor = false;
  spec.task.disturbances.surface_tilt_deg = {3.0, -2.0};
  const RunResult result = run_task(spec);
  EXPECT_TRUE(result.succeeded) << result.outcome;
  ASSERT_TRUE(result.metrics.has_value());
  EXPECT_LT(result.metrics->force_rmse, 2.0);
  EXPECT_EQ(result.metrics->without_contact, 0.0);
  // Noise of the force sensor changes nothing.
  spec.task.disturbances.force_noise = 50.0;
  const RunResult noisy = run_task(spec);
  ASSERT_TRUE(noisy.metrics.has_value());
  EXPECT_EQ(noisy.metrics->force_rmse, result.metrics->force_rmse);
}

TEST(SurfaceRun, ControllersWithoutPlans_FollowTheShape) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  for (const ControllerKind controller : {ControllerKind::Baseline, ControllerKind::Admittance}) {
    RunSpec spec = short_run(shapes()[1]);
    spec.controller = controller;
    spec.task.disturbances = {};
    const RunResult result = run_task(spec);
    EXPECT_TRUE(result.succeeded) << name_of(controller) << ": " << result.outcome;
  }
}

TEST(SurfaceRun, ShapeThatDoesNotFit_IsRefusedBeforeTheRun) {
  const auto refused = [](
                           const SurfaceShape& shape, const std::vector<std::string>& words,
                           const std::function<void(Task&)>& change = [](Task&) {}) {
    RunSpec spec = short_run(shape);
    change(spec.task);
    expect_words(refusal([&] { run_task(spec); }), words);
  };
  refused(
      {.kind = Kind::Sphere, .radius = 0.06},
      {"path: the path leaves the sphere of radius 0.06 m", "a smaller path or a larger shape"});
  refused({.kind = Kind::Sphere, .radius = 0.4},
          {"axes: the tool's axes do not turn with the normal of a sphere", "wanted surface"},
          [](Task& task) { task.axes = ForceAxes::Local; });
  refused({.kind = Kind::Sphere, .radius = 0.4},
          {"axes: the world's axes do not turn with the normal of a sphere", "wanted surface"},
          [](Task& task) { task.axes = ForceAxes::World; });
  refused({.kind = Kind::Cylinder, .radius = 0.015, .hollow = true},
          {"0.02 m does not fit into the hollow cylinder of radius 0.015 m"},
          [](Task& task) { task.path.radius = 0.001; });
  refused({.kind = Kind::Torus, .radius = 0.5, .ring = 0.2},
          {"the radius of its tube is 0.5 m", "the radius of its ring, 0.2 m"});
}

TEST(SurfaceRun, IdealPlantWithASphere_IsRefused) {
  RunSpec spec = short_run(shapes()[0]);
  spec.plant = PlantKind::Ideal;
  expect_words(refusal([&] { run_task(spec); }),
               {"the ideal plant's surface is a sphere", "MuJoCo"});
}

}  // namespace
}  // namespace burnish::testing

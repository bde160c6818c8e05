// Accuracy of the impedance controller in MuJoCo against a reference: force RMSE and peak [N] and
// circle RMSE [mm], measured with another implementation of controller and plant.
#include <gtest/gtest.h>

#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "support/allocation_guard.hpp"
#include "support/polishing_run.hpp"

namespace burnish::test {
namespace {

struct ReferenceFigures {
  std::string name;
  PolishingSurface surface;
  double friction, ki;
  bool noise;
  double force_rmse, force_peak, position_rmse;  ///< [N], [N], [mm]
};
void PrintTo(const ReferenceFigures& c, std::ostream* out) { *out << c.name; }

class Baseline : public ::testing::TestWithParam<ReferenceFigures> {};

TEST_P(Baseline, ImpedanceController_PolishesWithinTwiceTheReferenceErrors) {
  const ReferenceFigures& reference = GetParam();
  PolishingCase setup;
  setup.surface = reference.surface;
  setup.friction = reference.friction;
  setup.ki = reference.ki;
  if (reference.noise) setup.disturbances = sensor_noise(1.05);
  PolishingRun run(setup, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  ASSERT_EQ(run.run(9.5), Status::Ok);
  const Metrics metrics = run.metrics(3.0);
  EXPECT_EQ(metrics.without_contact, 0.0);
  EXPECT_LE(metrics.force_rmse_raw, 2.0 * reference.force_rmse) << metrics_text(metrics);
  EXPECT_LE(metrics.force_peak_raw, 2.0 * reference.force_peak) << metrics_text(metrics);
  EXPECT_LE(1e3 * metrics.position_rmse, 2.0 * reference.position_rmse) << metrics_text(metrics);
  // A much better result would mean that friction, noise or motion is missing.
  EXPECT_GE(1e3 * metrics.position_rmse, 0.5 * reference.position_rmse) << metrics_text(metrics);
  if (reference.noise) {
    EXPECT_GE(metrics.force_rmse_raw, 0.5 * reference.force_rmse) << metrics_text(metrics);
  }
  EXPECT_NEAR(metrics.force_mean, 30.0, 0.2);
  EXPECT_EQ(metrics.limited_torque, 0.0);
  EXPECT_GT(metrics.joint_margin, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    cases, Baseline,
    ::testing::Values(
        ReferenceFigures{"table_mu0_A", table(), 0.0, 0.0, false, 0.079, 0.109, 0.027},
        ReferenceFigures{"table_mu0_B", table(), 0.0, 10.0, false, 0.003, 0.005, 0.027},
        ReferenceFigures{"table_mu3_D", table(), 0.3, 10.0, true, 0.32, 0.95, 5.5},
        ReferenceFigures{"board_x_mu0_A", board_x(), 0.0, 0.0, false, 0.085, 0.13, 0.031},
        ReferenceFigures{"board_x_mu0_B", board_x(), 0.0, 10.0, false, 0.004, 0.007, 0.031},
        ReferenceFigures{"board_x_mu3_D", board_x(), 0.3, 10.0, true, 0.38, 1.1, 5.5}),
    [](const auto& test) { return test.param.name; });

TEST(BaselineMujoco, Run_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  PolishingCase setup;
  setup.friction = 0.3;
  setup.ki = 10.0;
  setup.disturbances = sensor_noise(1.05);
  setup.disturbances.joint_coulomb = 0.5;
  setup.disturbances.joint_viscous = 0.5;
  PolishingRun run(setup, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  const AllocationGuard guard;
  const Status status = run.run(1.0);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
  EXPECT_EQ(run.loop().command().phase, number_of(Phase::Track));
}

TEST(BaselineMujoco, UnmodelledTiltAndHeight_RaiseTheForceError) {
  PolishingCase setup;
  setup.ki = 10.0;
  setup.disturbances.surface_tilt_deg = {4.0, 0.0};
  setup.disturbances.surface_height = -2e-3;
  PolishingRun run(setup, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  ASSERT_EQ(run.run(6.0), Status::Ok);
  const Metrics metrics = run.metrics(3.0);
  EXPECT_GT(metrics.force_rmse, 0.05) << "on a level surface the error is 1e-2 N";
  EXPECT_LT(metrics.force_rmse, 3.0);
}

}  // namespace
}  // namespace burnish::test

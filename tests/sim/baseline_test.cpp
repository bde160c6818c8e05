// The impedance controller against MuJoCo reaches what such a controller is known to reach: force
// RMSE and peak (N) and circle RMSE (mm), measured with another implementation of both.
#include <gtest/gtest.h>

#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "support/allocation_guard.hpp"
#include "support/polishing_run.hpp"

namespace burnish::test {
namespace {

struct Published {
  std::string name;
  PolishingSurface surface;
  double friction, ki;
  bool noise;
  double force_rmse, force_peak, position_rmse;  ///< N, N, mm
};
void PrintTo(const Published& c, std::ostream* out) { *out << c.name; }

class Baseline : public ::testing::TestWithParam<Published> {};

TEST_P(Baseline, polishes_as_well_as_published_within_a_factor_of_two) {
  const Published& published = GetParam();
  PolishingCase wanted;
  wanted.surface = published.surface;
  wanted.friction = published.friction;
  wanted.ki = published.ki;
  if (published.noise) wanted.disturbances = sensor_noise(1.05);
  PolishingRun run(wanted, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  ASSERT_EQ(run.run(9.5), Status::Ok);
  const Metrics metrics = run.metrics(3.0);
  EXPECT_EQ(metrics.without_contact, 0.0);
  EXPECT_LE(metrics.force_rmse_raw, 2.0 * published.force_rmse) << metrics_text(metrics);
  EXPECT_LE(metrics.force_peak_raw, 2.0 * published.force_peak) << metrics_text(metrics);
  EXPECT_LE(1e3 * metrics.position_rmse, 2.0 * published.position_rmse) << metrics_text(metrics);
  // Better by far would mean that something is missing: friction, the noise, or the motion.
  EXPECT_GE(1e3 * metrics.position_rmse, 0.5 * published.position_rmse) << metrics_text(metrics);
  if (published.noise) {
    EXPECT_GE(metrics.force_rmse_raw, 0.5 * published.force_rmse) << metrics_text(metrics);
  }
  EXPECT_NEAR(metrics.force_mean, 30.0, 0.2);
  EXPECT_EQ(metrics.limited_torque, 0.0);
  EXPECT_GT(metrics.joint_margin, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    cases, Baseline,
    ::testing::Values(Published{"table_mu0_A", table(), 0.0, 0.0, false, 0.079, 0.109, 0.027},
                      Published{"table_mu0_B", table(), 0.0, 10.0, false, 0.003, 0.005, 0.027},
                      Published{"table_mu3_D", table(), 0.3, 10.0, true, 0.32, 0.95, 5.5},
                      Published{"board_x_mu0_A", board_x(), 0.0, 0.0, false, 0.085, 0.13, 0.031},
                      Published{"board_x_mu0_B", board_x(), 0.0, 10.0, false, 0.004, 0.007, 0.031},
                      Published{"board_x_mu3_D", board_x(), 0.3, 10.0, true, 0.38, 1.1, 5.5}),
    [](const auto& test) { return test.param.name; });

TEST(BaselineMujoco, allocates_nothing_in_a_run) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  PolishingCase wanted;
  wanted.friction = 0.3;
  wanted.ki = 10.0;
  wanted.disturbances = sensor_noise(1.05);
  wanted.disturbances.joint_coulomb = 0.5;
  wanted.disturbances.joint_viscous = 0.5;
  PolishingRun run(wanted, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  const AllocationGuard guard;
  const Status status = run.run(1.0);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
  EXPECT_EQ(run.loop().command().phase, number_of(Phase::Track));
}

TEST(BaselineMujoco, feels_a_tilt_a_height_error_and_pushes_that_it_does_not_know) {
  PolishingCase wanted;
  wanted.ki = 10.0;
  wanted.disturbances.surface_tilt_deg = {4.0, 0.0};
  wanted.disturbances.surface_height = -2e-3;
  PolishingRun run(wanted, [](const Model& model, const SceneSpec& scene) {
    return make_mujoco_plant(model, scene);
  });
  ASSERT_EQ(run.run(6.0), Status::Ok);
  const Metrics metrics = run.metrics(3.0);
  EXPECT_GT(metrics.force_rmse, 0.05) << "a level surface is followed to 1e-2 N";
  EXPECT_LT(metrics.force_rmse, 3.0);
}

}  // namespace
}  // namespace burnish::test

// Tests of controllers without a plan: phases, integrals, loops, and polishing accuracy.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "support/allocation_guard.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"
#include "support/tool_force.hpp"

namespace burnish::test {
namespace {

using MakeController = decltype(PolishingCase::make_controller);

std::unique_ptr<Plant> rigid_plant(const Model& model, const SceneSpec& scene) {
  return make_ideal_plant(model, scene);
}

MakeController make_impedance(const ImpedanceGains& gains = {}) {
  return [gains](const Model& model, const PressingPath& path, const PolishingCase& /*of*/) {
    return make_impedance_controller(model, {path, gains});
  };
}
MakeController make_admittance(const AdmittanceGains& gains = {}) {
  return [gains](const Model& model, const PressingPath& path, const PolishingCase& /*of*/) {
    return make_admittance_controller(model, {path, gains});
  };
}

PolishingCase with_friction(const MakeController& make) {
  PolishingCase setup;
  setup.friction = 0.3;
  setup.make_controller = make;
  return setup;
}

Metrics polished(const PolishingCase& setup, double duration = 6.0) {
  PolishingRun run(setup, rigid_plant);
  EXPECT_EQ(run.run(duration), Status::Ok);
  return run.metrics(3.0);
}

class PathController : public ::testing::TestWithParam<bool> {
 protected:
  static MakeController default_controller() {
    return GetParam() ? make_admittance() : make_impedance();
  }
};
INSTANTIATE_TEST_SUITE_P(both, PathController, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "admittance" : "impedance"; });

TEST_P(PathController, LongApproach_RampsTheForceFromContact) {
  PolishingCase setup;
  setup.clearance = 0.04;  // 0.8 s at 5 cm/s: longer than the ramp
  setup.make_controller = default_controller();
  PolishingRun run(setup, rigid_plant);
  ASSERT_EQ(run.run(2.0), Status::Ok);
  const Trace& trace = run.loop().trace();
  const Trace::Column phase = trace.column("phase"), target = trace.column("target_force");
  int ramp = 0, track = 0;
  while (phase[ramp] < static_cast<double>(Phase::Ramp)) ++ramp;
  track = ramp;
  while (phase[track] < static_cast<double>(Phase::Track)) ++track;
  EXPECT_GT(trace.at(ramp, 0), 0.75);
  EXPECT_NEAR(trace.at(track, 0) - trace.at(ramp, 0), 0.5, 3e-3);
  EXPECT_EQ(target[ramp], 2.0);
  EXPECT_NEAR(target[(ramp + track) / 2], 16.0, 0.3);
  EXPECT_EQ(target[track], 30.0);
}

TEST_P(PathController, UnmodelledFriction_IsTolerated) {
  const Metrics metrics = polished(with_friction(default_controller()));
  EXPECT_EQ(metrics.without_contact, 0.0);
  EXPECT_NEAR(metrics.force_mean, 30.0, 0.3) << metrics_text(metrics);
  EXPECT_LE(metrics.force_rmse, 1.0) << metrics_text(metrics);
  EXPECT_LE(metrics.position_rmse, 2e-3) << metrics_text(metrics);
}

TEST_P(PathController, Run_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  PolishingCase setup = with_friction(default_controller());
  setup.disturbances = sensor_noise(1.05);
  PolishingRun run(setup, rigid_plant);
  const AllocationGuard guard;
  const Status status = run.run(0.8);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
}

TEST_P(PathController, Reset_GivesTheSameForces) {
  PolishingCase setup = with_friction(default_controller());
  PolishingRun run(setup, rigid_plant);
  const auto force = [&] {
    EXPECT_EQ(run.run(0.7), Status::Ok);
    return Eigen::VectorXd(run.loop().trace().column("tool_force_z_world"));
  };
  const Eigen::VectorXd once = force();
  ASSERT_EQ(run.loop().reset(run.start(), Eigen::VectorXd::Zero(run.controller().nv())),
            Status::Ok);
  EXPECT_EQ(force(), once);
}

TEST_P(PathController, InvalidMeasurement_ReturnsAStatusAndTheLastTorque) {
  PolishingCase setup;
  setup.make_controller = default_controller();
  PolishingRun run(setup, rigid_plant);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  Measurement bad = run.loop().measurement();
  const Eigen::VectorXd before = run.controller().tick(bad).tau;
  bad.wrenches(2, 0) = std::nan("");
  EXPECT_EQ(run.controller().tick(bad).status, Status::NotFinite);
  EXPECT_EQ(run.controller().tick(bad).tau, before);
  bad.q = Eigen::VectorXd::Zero(2);
  EXPECT_EQ(run.controller().tick(bad).status, Status::WrongSize);
}

// Position integral of the impedance controller.

ImpedanceGains with_integral(double ki, double limit = 20.0) {
  ImpedanceGains gains;
  gains.kp = 900.0;
  gains.kd = 60.0;
  gains.ki_position = ki;
  gains.position_integral_limit = limit;
  return gains;
}

TEST(Impedance, PositionIntegral_RemovesTheErrorByFriction) {
  const Metrics without = polished(with_friction(make_impedance(with_integral(0.0))));
  const Metrics with = polished(with_friction(make_impedance(with_integral(8000.0))));
  EXPECT_GT(without.position_rmse, 4e-3);
  EXPECT_LT(with.position_rmse, 0.25 * without.position_rmse) << metrics_text(with);
  EXPECT_LT(with.force_rmse, 1.2 * without.force_rmse) << metrics_text(with);
  // A small integral limit bounds the correction.
  const Metrics bounded = polished(with_friction(make_impedance(with_integral(8000.0, 0.5))));
  EXPECT_GT(bounded.position_rmse, 2.0 * with.position_rmse);
  EXPECT_LT(bounded.position_rmse, without.position_rmse);
}

/// Returns the torques of a controller every 0.1 s, `count` times. Its robot is fixed 1 cm beside
/// the path and measures 20 N of 30 N.
std::vector<Eigen::VectorXd> torques_of_fixed_robot(const MakeController& make, double effort,
                                                    int count) {
  Eigen::VectorXd q;
  Model model = right_arm(&q);
  model.effort_limit.setConstant(effort);
  const Eigen::Vector3d p = frame_placement(model, q, "tool").translation();
  PressingPath path;
  path.posture = q;
  path.ramp = 0.0;
  path.task = [p](double) {
    return TaskPoint{.p_world = p + Eigen::Vector3d(0.01, 0.0, 0.0), .force = 30.0};
  };
  const auto controller = make(model, path, {});
  Measurement fixed;
  fixed.q = q;
  fixed.v = fixed.tau = Eigen::VectorXd::Zero(model.nv);
  set_tool_force(fixed, model, {0.0, 0.0, 20.0});
  std::vector<Eigen::VectorXd> torques;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 100; ++k) controller->tick(fixed);
    torques.push_back(controller->tick(fixed).tau);
  }
  return torques;
}

TEST(Impedance, Integrals_StopAtTheirLimitsAndAtTorqueLimits) {
  const MakeController make = make_impedance(with_integral(8000.0));
  const auto unlimited = torques_of_fixed_robot(make, 1e6, 80);
  EXPECT_GT((unlimited[2] - unlimited[1]).norm(), 0.5);
  EXPECT_EQ(unlimited[79], unlimited[78]);  // both bounds are reached within a second
  const auto limited = torques_of_fixed_robot(make, 1.0, 3);
  EXPECT_EQ(limited[2], limited[0]);
}

// Inner and outer loop of the admittance controller.

/// Admittance controller with a target of 30 N, on an arm that does not move.
struct FixedAdmittance {
  explicit FixedAdmittance(const AdmittanceGains& gains) {
    model = right_arm(&measured.q);
    const Eigen::Vector3d p = frame_placement(model, measured.q, "tool").translation();
    PressingPath path;
    path.posture = measured.q;
    path.task = [p](double) { return TaskPoint{.p_world = p, .force = 30.0}; };
    controller = make_admittance_controller(model, {path, gains});
    measured.v = measured.tau = Eigen::VectorXd::Zero(model.nv);
    press(0.0);
  }
  /// Sets the measured force, upwards [N].
  void press(double force) { set_tool_force(measured, model, {0.0, 0.0, force}); }

  Model model;
  Measurement measured;
  std::unique_ptr<Controller> controller;
};

TEST(Admittance, OuterLoopDelay_KeepsTheFirstTorqueUntilItPasses) {
  AdmittanceGains gains;
  gains.rate = 250.0;
  gains.delay = 6e-3;
  FixedAdmittance fixed(gains);
  const Eigen::VectorXd first = fixed.controller->tick(fixed.measured).tau;
  // The command to press is sent at the first tick and arrives with the seventh.
  for (int tick = 1; tick < 6; ++tick)
    EXPECT_EQ(fixed.controller->tick(fixed.measured).tau, first) << tick;
  EXPECT_NE(fixed.controller->tick(fixed.measured).tau, first);
}

TEST(Admittance, OuterLoopRate_SamplesTheForce) {
  AdmittanceGains gains;
  gains.rate = 100.0;  // every tenth tick
  gains.delay = 0.0;
  const auto last_torque = [&](int pushed_tick) {
    FixedAdmittance fixed(gains);
    Eigen::VectorXd tau;
    for (int tick = 0; tick < 45; ++tick) {
      fixed.press(tick == pushed_tick ? 60.0 : 20.0);
      tau = fixed.controller->tick(fixed.measured).tau;
    }
    return tau;
  };
  EXPECT_EQ(last_torque(35), last_torque(37));
  EXPECT_NE(last_torque(30), last_torque(37));
}

TEST(Admittance, InvalidOptions_AreRefused) {
  Eigen::VectorXd q;
  const Model model = right_arm(&q);
  AdmittanceSpec spec;
  const auto refused = [&](const std::vector<std::string>& words) {
    testing::expect_words(testing::refusal([&] { make_admittance_controller(model, spec); }),
                          words);
  };
  spec.path.posture = q;
  refused({"the admittance controller's task is empty"});
  spec.path.task = [](double) { return TaskPoint{}; };
  spec.gains.damping = 0.0;
  refused({"admittance controller's gains.damping is 0", "more than 0"});
  spec.gains = {};
  spec.path.tool = "tol";
  refused({"'tol'", "tool"});
}

}  // namespace
}  // namespace burnish::test

// Controllers without a plan: their phases, integrals, loops, and how well they polish.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "support/allocation_guard.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"

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

PolishingCase rubbing(const MakeController& make) {
  PolishingCase wanted;
  wanted.friction = 0.3;
  wanted.make_controller = make;
  return wanted;
}

Metrics polished(const PolishingCase& wanted, double duration = 6.0) {
  PolishingRun run(wanted, rigid_plant);
  EXPECT_EQ(run.run(duration), Status::Ok);
  return run.metrics(3.0);
}

class PathController : public ::testing::TestWithParam<bool> {
 protected:
  static MakeController shipped() { return GetParam() ? make_admittance() : make_impedance(); }
};
INSTANTIATE_TEST_SUITE_P(both, PathController, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "admittance" : "impedance"; });

TEST_P(PathController, ramps_the_force_however_long_the_approach_took) {
  PolishingCase wanted;
  wanted.clearance = 0.04;  // 0.8 s at 5 cm/s: longer than the ramp
  wanted.make_controller = shipped();
  PolishingRun run(wanted, rigid_plant);
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

TEST_P(PathController, polishes_in_spite_of_friction_that_it_does_not_know) {
  const Metrics metrics = polished(rubbing(shipped()));
  EXPECT_EQ(metrics.without_contact, 0.0);
  EXPECT_NEAR(metrics.force_mean, 30.0, 0.3) << metrics_text(metrics);
  EXPECT_LE(metrics.force_rmse, 1.0) << metrics_text(metrics);
  EXPECT_LE(metrics.position_rmse, 2e-3) << metrics_text(metrics);
}

TEST_P(PathController, allocates_nothing_in_a_run) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  PolishingCase wanted = rubbing(shipped());
  wanted.disturbances = sensor_noise(1.05);
  PolishingRun run(wanted, rigid_plant);
  const AllocationGuard guard;
  const Status status = run.run(0.8);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
}

TEST_P(PathController, gives_the_same_torques_again_after_a_reset) {
  PolishingCase wanted = rubbing(shipped());
  PolishingRun run(wanted, rigid_plant);
  const auto force = [&] {
    EXPECT_EQ(run.run(0.7), Status::Ok);
    return Eigen::VectorXd(run.loop().trace().column("tool_force_z_world"));
  };
  const Eigen::VectorXd once = force();
  ASSERT_EQ(run.loop().reset(run.start(), Eigen::VectorXd::Zero(run.controller().nv())),
            Status::Ok);
  EXPECT_EQ(force(), once);
}

TEST_P(PathController, answers_a_measurement_that_is_none_with_a_status_and_its_last_torque) {
  PolishingCase wanted;
  wanted.make_controller = shipped();
  PolishingRun run(wanted, rigid_plant);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  Measurement bad = run.loop().measurement();
  const Eigen::VectorXd before = run.controller().tick(bad).tau;
  bad.tool_force_world.z() = std::nan("");
  EXPECT_EQ(run.controller().tick(bad).status, Status::NotFinite);
  EXPECT_EQ(run.controller().tick(bad).tau, before);
  bad.q = Eigen::VectorXd::Zero(2);
  EXPECT_EQ(run.controller().tick(bad).status, Status::WrongSize);
}

// Position integral of the impedance.

ImpedanceGains with_integral(double ki, double most = 20.0) {
  ImpedanceGains gains;
  gains.kp = 900.0;
  gains.kd = 60.0;
  gains.ki_position = ki;
  gains.position_integral_limit = most;
  return gains;
}

TEST(Impedance, an_integral_takes_the_place_s_error_by_friction_away) {
  const Metrics without = polished(rubbing(make_impedance(with_integral(0.0))));
  const Metrics with = polished(rubbing(make_impedance(with_integral(8000.0))));
  EXPECT_GT(without.position_rmse, 4e-3);
  EXPECT_LT(with.position_rmse, 0.25 * without.position_rmse) << metrics_text(with);
  EXPECT_LT(with.force_rmse, 1.2 * without.force_rmse) << metrics_text(with);
  // It helps no more than it may.
  const Metrics bounded = polished(rubbing(make_impedance(with_integral(8000.0, 0.5))));
  EXPECT_GT(bounded.position_rmse, 2.0 * with.position_rmse);
  EXPECT_LT(bounded.position_rmse, without.position_rmse);
}

/// The torques of a controller whose robot is held a centimetre beside the path and feels 20 of 30
/// N, at the end of each of so many times 0.1 s.
std::vector<Eigen::VectorXd> torques_of_one_held(const MakeController& make, double effort,
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
  Measurement held;
  held.q = q;
  held.v = held.tau = Eigen::VectorXd::Zero(model.nv);
  held.tool_force_world = {0.0, 0.0, 20.0};
  std::vector<Eigen::VectorXd> torques;
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 100; ++k) controller->tick(held);
    torques.push_back(controller->tick(held).tau);
  }
  return torques;
}

TEST(Impedance, integrals_grow_to_their_limits_and_stand_still_while_a_torque_is_at_its_own) {
  const MakeController make = make_impedance(with_integral(8000.0));
  const auto free = torques_of_one_held(make, 1e6, 80);
  EXPECT_GT((free[2] - free[1]).norm(), 0.5);
  EXPECT_EQ(free[79], free[78]);  // both bounds are reached within a second
  const auto limited = torques_of_one_held(make, 1.0, 3);
  EXPECT_EQ(limited[2], limited[0]);
}

// The two loops of the admittance.

/// One that is to press with 30 N where its arm, which does not move, has its tool.
struct HeldAdmittance {
  explicit HeldAdmittance(const AdmittanceGains& gains) {
    const Model model = right_arm(&measured.q);
    const Eigen::Vector3d p = frame_placement(model, measured.q, "tool").translation();
    PressingPath path;
    path.posture = measured.q;
    path.task = [p](double) { return TaskPoint{.p_world = p, .force = 30.0}; };
    controller = make_admittance_controller(model, {path, gains});
    measured.v = measured.tau = Eigen::VectorXd::Zero(model.nv);
  }
  Measurement measured;
  std::unique_ptr<Controller> controller;
};

TEST(Admittance, holds_its_joints_until_the_outer_loop_s_command_arrives) {
  AdmittanceGains gains;
  gains.rate = 250.0;
  gains.delay = 6e-3;
  HeldAdmittance held(gains);
  const Eigen::VectorXd first = held.controller->tick(held.measured).tau;
  // The command to go down was sent at the first tick: it comes with the seventh.
  for (int tick = 1; tick < 6; ++tick)
    EXPECT_EQ(held.controller->tick(held.measured).tau, first) << tick;
  EXPECT_NE(held.controller->tick(held.measured).tau, first);
}

TEST(Admittance, reads_the_force_at_its_own_rate) {
  AdmittanceGains gains;
  gains.rate = 100.0;  // every tenth tick
  gains.delay = 0.0;
  const auto last_torque = [&](int pushed_tick) {
    HeldAdmittance held(gains);
    Eigen::VectorXd tau;
    for (int tick = 0; tick < 45; ++tick) {
      held.measured.tool_force_world = {0.0, 0.0, tick == pushed_tick ? 60.0 : 20.0};
      tau = held.controller->tick(held.measured).tau;
    }
    return tau;
  };
  EXPECT_EQ(last_torque(35), last_torque(37));
  EXPECT_NE(last_torque(30), last_torque(37));
}

TEST(Admittance, refuses_what_cannot_be) {
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

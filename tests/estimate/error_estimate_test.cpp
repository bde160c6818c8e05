// Tests of the values to which the model error estimates converge, mostly on an arm at rest.
#include "estimate/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/decomposition.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/part_specs.hpp"
#include "support/tool_force.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

ErrorEstimate estimate_of(const MpcSpec& spec) {
  return ErrorEstimate(error_estimate_spec(spec), MeasurementGate(gate_spec(spec)).state());
}

void update(ErrorEstimate& estimate, MeasurementGate& gate, double target,
            const Eigen::VectorXd& acted, int stage) {
  const Eigen::VectorXd targets =
      Eigen::VectorXd::Constant(gate.tool_forces_world().cols(), target);
  estimate.update(gate.state(), {.measurement = gate.last(),
                                 .tool_forces_world = gate.tool_forces_world(),
                                 .wrenches = gate.wrenches(),
                                 .dt = gate.dt(),
                                 .target_forces = targets,
                                 .sent = acted,
                                 .stage = stage,
                                 .schedule_time = gate.now(),
                                 .waits = false});
}

/// Arm that presses on a floor without moving.
struct Pressing {
  explicit Pressing(ModelErrorKind kind) {
    spec.model_error = {.kind = kind, .bandwidth = 100.0};
    spec.problem.contacts = {{.name = "floor", .tool = "tool", .directions = Directions::z()}};
    spec.problem.contacts[0].reference = Reference::surface_with_normal({0.0, 0.0, 1.0});
    spec.problem.stages[0].contacts = {"floor"};
    m = toy_measurement(spec);
    RigidBody body(spec.problem.model);
    (void)body.update(m.q, m.v);
    FrameDerivatives motion;
    body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
    jacobian = motion.jacobian.topRows(3);
    gravity = body.gravity_torque();
  }
  /// Sets the measured force, in world axes [N].
  void press(const Eigen::Vector3d& force_world) {
    pressed = force_world;
    set_tool_force(m, spec.problem.model, pressed);
  }
  /// Simulates one second at rest with the force in `m` on the tool and this command.
  void rest(ErrorEstimate& estimate, const Eigen::VectorXd& tau, double target, int stage = 0) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch;
    Status status = Status::Ok;
    for (int tick = 0; tick < 1000; ++tick) {
      m.time = 1e-3 * tick;
      m.tau = tau;
      gate.take(m, latch, status);
      update(estimate, gate, target, tau, stage);
    }
    ASSERT_FALSE(latch.is_set());
  }
  Eigen::VectorXd against(const Eigen::Vector3d& force_world) const {
    return gravity - jacobian.transpose() * force_world;
  }
  MpcSpec spec = toy_spec();
  Measurement m;
  Eigen::Vector3d pressed = Eigen::Vector3d::Zero();  ///< See press()
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd gravity;
};

TEST(ErrorEstimate, UnexplainedTorque_IsTheTorqueError) {
  Pressing arm(ModelErrorKind::Torque);
  ErrorEstimate estimate = estimate_of(arm.spec);
  const Eigen::VectorXd missing = Eigen::VectorXd::LinSpaced(7, -0.5, 0.7);
  arm.press({0.0, 0.0, 20.0});
  arm.rest(estimate, arm.against(arm.pressed) - missing, 20.0);
  EXPECT_LT((estimate.torque_error() - missing).norm(), 1e-3);
  EXPECT_EQ(estimate.force_error()[0], 0.0);
  estimate.reset();
  EXPECT_TRUE(estimate.torque_error().isZero(0.0) && estimate.forces_world().isZero(0.0));
}

TEST(ErrorEstimate, ForceDeviation_IsFedBackUpToItsLimit) {
  Pressing arm(ModelErrorKind::Torque);
  arm.spec.model_error.force_gain = 0.5;
  arm.spec.model_error.limit = 3.0;
  arm.press({1.0, -2.0, 22.0});
  const Eigen::VectorXd tau = arm.against(arm.pressed);
  const Eigen::VectorXd normal = arm.jacobian.transpose() * Eigen::Vector3d::UnitZ();
  ErrorEstimate estimate = estimate_of(arm.spec);
  const auto pushed = [&](double target) {
    arm.rest(estimate, tau, target);
    return estimate.force_feedback();
  };
  EXPECT_LT((pushed(20.0) - 0.5 * 2.0 * normal).norm(), 1e-9) << "the force exceeds its target";
  EXPECT_LT((pushed(23.0) + 0.5 * 1.0 * normal).norm(), 1e-9) << "the force is below its target";
  EXPECT_LT((pushed(40.0) + 0.5 * 3.0 * normal).norm(), 1e-9) << "the feedback reaches its limit";
  EXPECT_TRUE(pushed(0.0).isZero(0.0)) << "the target force is zero";
  arm.press({0.0, 0.0, 0.0});
  EXPECT_TRUE(pushed(20.0).isZero(0.0)) << "the tool is in free motion";
  estimate.reset();
  EXPECT_TRUE(estimate.force_feedback().isZero(0.0));
}

TEST(ErrorEstimate, FrictionTorque_ScalesWithTheTargetForce) {
  Pressing arm(ModelErrorKind::Torque);
  arm.press({5.0, -2.0, 20.0});
  const Eigen::VectorXd tau = arm.against(arm.pressed);
  const Eigen::VectorXd friction = arm.jacobian.transpose() * Eigen::Vector3d(5.0, -2.0, 0.0);
  for (const double target : {0.0, 20.0, 40.0}) {
    ErrorEstimate estimate = estimate_of(arm.spec);
    arm.rest(estimate, tau, target);
    EXPECT_LT((estimate.torque_error() - target / 20.0 * friction).norm(), 1e-3) << target;
  }
  // Below the contact threshold, the estimator assumes no contact.
  arm.spec.tools[0].contact_threshold = 21.0;
  ErrorEstimate estimate = estimate_of(arm.spec);
  arm.rest(estimate, tau, 40.0);
  EXPECT_LT(estimate.torque_error().norm(), 1e-3);
}

TEST(ErrorEstimate, PredictedSliding_TurnsTheFrictionWithTheMotion) {
  Pressing arm(ModelErrorKind::Torque);
  const double sensor_delay = 3e-3, torque_delay = 2e-3, friction = 6.0;  // [s], [s], [N]
  const auto direction = [](double t) {
    return Eigen::Vector3d(std::cos(5.0 * t), std::sin(5.0 * t), 0.0);
  };
  /// Slides the tool on a circle for 1.5 s with 6 N of friction. Returns the error of the
  /// compensated friction when torques act, as a fraction of the friction. `sign` 1 opposes the
  /// motion.
  const auto friction_error = [&](bool predicted, double speed, double sign) {
    ErrorEstimate estimate = estimate_of(arm.spec);
    MeasurementGate gate(gate_spec(arm.spec));
    FaultLatch latch;
    Status status = Status::Ok;
    double t = 0.0;
    for (int tick = 0; tick < 1500; ++tick) {
      t = 1e-3 * tick;
      arm.m.time = t;
      arm.press(Eigen::Vector3d(0.0, 0.0, 20.0) - sign * friction * direction(t - sensor_delay));
      arm.m.tau = arm.against(arm.pressed);
      gate.take(arm.m, latch, status);
      const double ahead =
          estimate.joint_friction().lead() + arm.spec.solver_delay + 0.5 * arm.spec.update_period;
      if (predicted) estimate.foresee(least_squares(arm.jacobian, speed * direction(t + ahead)));
      update(estimate, gate, 20.0, arm.m.tau, 0);
    }
    EXPECT_FALSE(latch.is_set());
    const Eigen::Vector3d compensated =
        least_squares(arm.jacobian.transpose(), estimate.torque_error());
    return (compensated + sign * friction * direction(t + torque_delay)).norm() / friction;
  };
  const double without_prediction = friction_error(false, 0.2, 1.0);
  EXPECT_GT(without_prediction, 0.05);
  EXPECT_LT(friction_error(true, 0.2, 1.0), 0.02);
  EXPECT_NEAR(friction_error(true, 1e-4, 1.0), without_prediction, 1e-3)
      << "a tool at rest has no sliding friction";
  EXPECT_NEAR(friction_error(true, 0.2, -1.0), friction_error(false, 0.2, -1.0), 1e-9)
      << "a force along the motion is not friction";
}

TEST(ErrorEstimate, UnpredictedForce_IsTheForceError) {
  Pressing arm(ModelErrorKind::Force);
  const Eigen::VectorXd tau = arm.against({0.0, 0.0, 20.0});
  arm.press({0.0, 0.0, 26.0});
  ErrorEstimate estimate = estimate_of(arm.spec);
  arm.rest(estimate, tau, 20.0);
  EXPECT_NEAR(estimate.force_error()[0], 6.0, 1e-3);
  EXPECT_NEAR(estimate.forces_world()(2, 0), 20.0, 1e-3);
  EXPECT_TRUE(estimate.torque_error().isZero(0.0));
  // In a stage without contact the force error is zero.
  arm.rest(estimate, tau, 20.0, 1);
  EXPECT_NEAR(estimate.force_error()[0], 0.0, 1e-3);
  EXPECT_TRUE(estimate.forces_world().isZero(0.0));
}

}  // namespace
}  // namespace burnish::test

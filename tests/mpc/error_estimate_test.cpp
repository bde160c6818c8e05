// What the estimates of the model's error settle at, on an arm that stands still.
#include "mpc/error_estimate.hpp"

#include <gtest/gtest.h>

#include "base/decomposition.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

/// The arm presses on a floor that it does not move on.
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
  /// A second at rest with this force on the tool and this command.
  void rest(ErrorEstimate& estimate, const Eigen::VectorXd& tau, double asked, int stage = 0) {
    MeasurementGate gate(spec);
    FaultLatch latch;
    Status status = Status::Ok;
    const Command command{.tau = tau, .target_force = asked};
    for (int tick = 0; tick < 1000; ++tick) {
      m.time = 1e-3 * tick;
      m.tau = tau;
      gate.take(m, latch, status);
      estimate.update(gate, command, stage, m.time);
    }
    ASSERT_FALSE(latch.is_set());
  }
  Eigen::VectorXd against(const Eigen::Vector3d& force) const {
    return gravity - jacobian.transpose() * force;
  }
  MpcSpec spec = toy_spec();
  Measurement m;
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd gravity;
};

TEST(ErrorEstimate, finds_what_no_force_and_no_command_explains) {
  Pressing arm(ModelErrorKind::Torque);
  ErrorEstimate estimate(arm.spec);
  const Eigen::VectorXd missing = Eigen::VectorXd::LinSpaced(7, -0.5, 0.7);
  arm.m.tool_force_world = {0.0, 0.0, 20.0};
  arm.rest(estimate, arm.against(arm.m.tool_force_world) - missing, 20.0);
  EXPECT_LT((estimate.torque_error() - missing).norm(), 1e-3);
  EXPECT_EQ(estimate.force_error(), 0.0);
  estimate.reset();
  EXPECT_TRUE(estimate.torque_error().isZero(0.0) && estimate.force_world().isZero(0.0));
}

TEST(ErrorEstimate, lets_friction_go_with_the_force_that_is_asked_for) {
  Pressing arm(ModelErrorKind::Torque);
  arm.m.tool_force_world = {5.0, -2.0, 20.0};
  const Eigen::VectorXd tau = arm.against(arm.m.tool_force_world);
  const Eigen::VectorXd friction = arm.jacobian.transpose() * Eigen::Vector3d(5.0, -2.0, 0.0);
  for (const double asked : {0.0, 20.0, 40.0}) {
    ErrorEstimate estimate(arm.spec);
    arm.rest(estimate, tau, asked);
    EXPECT_LT((estimate.torque_error() - asked / 20.0 * friction).norm(), 1e-3) << asked;
  }
  // Below the threshold nothing presses.
  arm.spec.contact_threshold = 21.0;
  ErrorEstimate estimate(arm.spec);
  arm.rest(estimate, tau, 40.0);
  EXPECT_LT(estimate.torque_error().norm(), 1e-3);
}

TEST(ErrorEstimate, turns_friction_to_where_a_plan_will_slide) {
  Pressing arm(ModelErrorKind::Torque);
  const auto joints_for = [&](const Eigen::Vector3d& v_tool) {
    return Eigen::VectorXd(least_squares(arm.jacobian, v_tool));
  };
  arm.m.tool_force_world = {-6.0, 0.0, 20.0};
  arm.m.v = joints_for({0.2, 0.0, 0.0});
  const auto torque_error = [&](const Eigen::Vector3d& v_ahead) {
    ErrorEstimate estimate(arm.spec);
    estimate.foresee(joints_for(v_ahead));
    arm.rest(estimate, arm.against(arm.m.tool_force_world), 20.0);
    return Eigen::VectorXd(estimate.torque_error());
  };
  const Eigen::VectorXd straight = torque_error({0.2, 0.0, 0.0});
  const auto differs_by = [&](const Eigen::Vector3d& v_ahead, const Eigen::Vector3d& force) {
    const Eigen::VectorXd torque = arm.jacobian.transpose() * force;
    return (torque_error(v_ahead) - straight - torque).norm() / torque.norm();
  };
  EXPECT_LT(differs_by({0.0, 0.2, 0.0}, {6.0, -6.0, 0.0}), 0.02);
  EXPECT_LT(differs_by({-0.2, 0.0, 0.0}, {12.0, 0.0, 0.0}), 0.02);
  EXPECT_LT(differs_by({0.0, 0.0, 0.2}, {6.0, 0.0, 0.0}), 0.02) << "off the surface nothing rubs";
  // Of a force that pushes a tool along, and of one that stands, nothing is friction of a slide.
  arm.m.tool_force_world = {6.0, 0.0, 20.0};
  EXPECT_LT((torque_error({0.0, 0.2, 0.0}) - torque_error({0.2, 0.0, 0.0})).norm(), 1e-9);
  arm.m.tool_force_world = {-6.0, 0.0, 20.0};
  arm.m.v.setZero();
  EXPECT_LT((torque_error({0.0, 0.2, 0.0}) - torque_error({0.2, 0.0, 0.0})).norm(), 1e-9);
}

TEST(ErrorEstimate, finds_the_force_that_the_model_does_not_predict) {
  Pressing arm(ModelErrorKind::Force);
  const Eigen::VectorXd tau = arm.against({0.0, 0.0, 20.0});
  arm.m.tool_force_world = {0.0, 0.0, 26.0};
  ErrorEstimate estimate(arm.spec);
  arm.rest(estimate, tau, 20.0);
  EXPECT_NEAR(estimate.force_error(), 6.0, 1e-3);
  EXPECT_NEAR(estimate.force_world().z(), 20.0, 1e-3);
  EXPECT_TRUE(estimate.torque_error().isZero(0.0));
  // A stage without contact has no force to be wrong.
  arm.rest(estimate, tau, 20.0, 1);
  EXPECT_NEAR(estimate.force_error(), 0.0, 1e-3);
  EXPECT_TRUE(estimate.force_world().isZero(0.0));
}

}  // namespace
}  // namespace burnish::test

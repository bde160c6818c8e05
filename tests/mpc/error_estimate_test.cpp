// What the estimates of the model's error settle at, on an arm that stands still.
#include "mpc/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

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
      estimate.update(gate, command, tau, stage, m.time, false);
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

TEST(ErrorEstimate, pushes_back_a_force_that_is_off) {
  Pressing arm(ModelErrorKind::Torque);
  arm.spec.model_error.force_gain = 0.5;
  arm.spec.model_error.limit = 3.0;
  arm.m.tool_force_world = {1.0, -2.0, 22.0};
  const Eigen::VectorXd tau = arm.against(arm.m.tool_force_world);
  const Eigen::VectorXd normal = arm.jacobian.transpose() * Eigen::Vector3d::UnitZ();
  ErrorEstimate estimate(arm.spec);
  const auto pushed = [&](double asked) {
    arm.rest(estimate, tau, asked);
    return estimate.force_feedback();
  };
  EXPECT_LT((pushed(20.0) - 0.5 * 2.0 * normal).norm(), 1e-9) << "it presses less";
  EXPECT_LT((pushed(23.0) + 0.5 * 1.0 * normal).norm(), 1e-9) << "it presses more";
  EXPECT_LT((pushed(40.0) + 0.5 * 3.0 * normal).norm(), 1e-9) << "by no more than the limit";
  EXPECT_TRUE(pushed(0.0).isZero(0.0)) << "nothing is asked for";
  arm.m.tool_force_world.setZero();
  EXPECT_TRUE(pushed(20.0).isZero(0.0)) << "in the air";
  estimate.reset();
  EXPECT_TRUE(estimate.force_feedback().isZero(0.0));
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
  const double late = 3e-3, until = 2e-3, pushed = 6.0;  // s of the sensor and of torques; N
  const auto direction = [](double t) {
    return Eigen::Vector3d(std::cos(5.0 * t), std::sin(5.0 * t), 0.0);
  };
  /// N that are given back after a tool slid around for 1.5 s with friction of 6 N, and how far
  /// that is from what rubs when torques act. Friction that is `sign` times against the way.
  const auto off_by = [&](bool foreseen, double speed, double sign) {
    ErrorEstimate estimate(arm.spec);
    MeasurementGate gate(arm.spec);
    FaultLatch latch;
    Status status = Status::Ok;
    double t = 0.0;
    for (int tick = 0; tick < 1500; ++tick) {
      t = 1e-3 * tick;
      arm.m.time = t;
      arm.m.tool_force_world =
          Eigen::Vector3d(0.0, 0.0, 20.0) - sign * pushed * direction(t - late);
      arm.m.tau = arm.against(arm.m.tool_force_world);
      gate.take(arm.m, latch, status);
      const double ahead =
          estimate.joint_friction().lead() + arm.spec.solver_delay + 0.5 * arm.spec.update_period;
      if (foreseen) estimate.foresee(least_squares(arm.jacobian, speed * direction(t + ahead)));
      estimate.update(gate, {.tau = arm.m.tau, .target_force = 20.0}, arm.m.tau, 0, t, false);
    }
    EXPECT_FALSE(latch.is_set());
    const Eigen::Vector3d given = least_squares(arm.jacobian.transpose(), estimate.torque_error());
    return (given + sign * pushed * direction(t + until)).norm() / pushed;
  };
  const double unforeseen = off_by(false, 0.2, 1.0);
  EXPECT_GT(unforeseen, 0.05);
  EXPECT_LT(off_by(true, 0.2, 1.0), 0.02);
  EXPECT_NEAR(off_by(true, 1e-4, 1.0), unforeseen, 1e-3) << "what stands does not rub";
  EXPECT_NEAR(off_by(true, 0.2, -1.0), off_by(false, 0.2, -1.0), 1e-9)
      << "what pushes the tool along is no friction";
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

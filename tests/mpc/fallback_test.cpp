// Tests of the fallback law, which stops and supports the robot after a fault.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"
#include "support/robots.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

/// Gravity torques b(q, 0) and mass matrix M(q).
struct Statics {
  Eigen::VectorXd gravity;
  Eigen::MatrixXd mass;
};
Statics statics(const Model& model, const Eigen::VectorXd& q) {
  ContactDynamics dynamics(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  EXPECT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  return {dynamics.bias(), dynamics.mass_matrix()};
}

/// Controller of any robot in free motion with measurements from the test. fail_at() sends its
/// second measurement too late.
class FedController {
 public:
  FedController(const TestRobot& robot, const Fallback& fallback)
      : model(robot.model()), mpc(spec_of(robot, model, fallback)) {
    m.q = model.q_neutral;
    m.wrenches.setZero(6, 1);
    m.v = m.tau = Eigen::VectorXd::Zero(model.nv);
    const auto& driven = mpc.problem().layout().actuated;
    actuated.assign(driven.begin(), driven.end());
  }
  const Eigen::VectorXd& tick(const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    m.q = q;
    m.v = v;
    m.time += 1e-3;
    return mpc.tick(m).tau;
  }
  void fail_at(const Eigen::VectorXd& q) {
    tick(q, Eigen::VectorXd::Zero(model.nv));
    m.time += 1.0;
    tick(q, Eigen::VectorXd::Zero(model.nv));
    ASSERT_EQ(mpc.fault().kind, FaultKind::StaleMeasurement) << mpc.fault().text();
  }
  /// Returns b(q, 0) - M x on the actuated joints, zero elsewhere; x is k e + c v.
  Eigen::VectorXd law(const Eigen::VectorXd& q, const Eigen::VectorXd& x) const {
    const Statics at = statics(model, q);
    Eigen::VectorXd driven = Eigen::VectorXd::Zero(model.nv), tau = driven;
    for (const int k : actuated) driven[k] = x[k];
    const Eigen::VectorXd pull = at.mass * driven;
    for (const int k : actuated) tau[k] = at.gravity[k] - pull[k];
    return tau;
  }

  Model model;
  MpcController mpc;
  Measurement m;
  std::vector<int> actuated;

 private:
  static MpcSpec spec_of(const TestRobot& robot, Model& model, const Fallback& fallback) {
    model.velocity_limit.setConstant(infinity);
    MpcSpec spec;
    spec.problem.model = model;
    spec.problem.stages = {{.name = "air",
                            .costs = {{.name = "state", .residual = residual::State{}},
                                      {.name = "torque", .residual = residual::Control{}}}}};
    spec.problem.horizon = {{"air", 5}};
    spec.problem.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
    spec.problem.initial_state.head(model.nq) = model.q_neutral;
    spec.schedule = {{.stage = "air"}};
    spec.tools = {{.frame = robot.tool}};
    spec.tick_period = 1e-3;
    spec.fallback = fallback;
    return spec;
  }
};

Eigen::VectorXd robot_at_home() {
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm").reference_configuration();
}

std::vector<TestRobot> robots() {
  return {{"talos:right_arm", Base::Fixed, "tool"},
          {"every_joint", Base::Fixed, "tip"},
          {"every_joint", Base::FreeFlyer, "tip"}};
}

TEST(Fallback, EveryJointKind_GetsASpringAndADamper) {
  std::mt19937_64 generator(4);
  const Fallback fallback{.stiffness = 300.0, .damping = 20.0, .saturation_fraction = 1.0};
  for (const TestRobot& robot : robots()) {
    FedController fed(robot, fallback);
    fed.model.effort_limit.setConstant(infinity);
    const Eigen::VectorXd q_hold = random_configuration(fed.model, generator);
    fed.fail_at(q_hold);
    for (int trial = 0; trial < 5; ++trial) {
      const Eigen::VectorXd e = random_vector(fed.model.nv, 0.01, generator);
      const Eigen::VectorXd v = random_vector(fed.model.nv, 0.01, generator);
      const Eigen::VectorXd q = integrate(fed.model, q_hold, e);
      const Eigen::VectorXd expected = fed.law(q, fallback.stiffness * e + fallback.damping * v);
      EXPECT_LT((fed.tick(q, v) - expected).norm(), 1e-9 * expected.norm()) << robot.label();
    }
  }
}

TEST(Fallback, SpringAtItsSaturationFraction_SlipsWithThePosition) {
  const Fallback fallback{.stiffness = 900.0, .damping = 0.0, .saturation_fraction = 0.1};
  const TestRobot robot = robots()[0];
  FedController fed(robot, fallback);
  const Eigen::VectorXd q_hold = robot_at_home(), zero = Eigen::VectorXd::Zero(6),
                        limit = fallback.saturation_fraction * fed.model.effort_limit;
  fed.fail_at(q_hold);
  const Eigen::VectorXd direction = Eigen::VectorXd::LinSpaced(6, 0.2, 0.7);
  const auto spring = [&](double along) {
    const Eigen::VectorXd q = q_hold + along * direction;
    return Eigen::VectorXd(fed.tick(q, zero) - statics(fed.model, q).gravity);
  };
  // Moving out, the torque stays at the saturation fraction on the joint that saturates first.
  for (const double along : {0.05, 0.2, 0.5}) {
    const Eigen::ArrayXd saturation = spring(along).array().abs() / limit.array();
    EXPECT_NEAR(saturation.maxCoeff(), 1.0, 1e-9) << along;
  }
  // After a small motion back the spring is slack; farther back, it pulls in the opposite
  // direction.
  const Eigen::VectorXd out = spring(0.5), back = spring(0.45);
  EXPECT_LT(out.dot(back), 0.0);
  EXPECT_NEAR((back.array().abs() / limit.array()).maxCoeff(), 1.0, 1e-9);
  // Below saturation the spring is elastic: returning to a position gives the same torque.
  const Eigen::VectorXd slack = spring(0.451);
  spring(0.4515);
  EXPECT_LT((spring(0.451) - slack).norm(), 1e-9);
}

TEST(Fallback, NoMeasurement_CompensatesGravityThenHoldsTheNewPosition) {
  const Fallback fallback{};
  FedController fed(robots()[0], fallback);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6), q_hold = robot_at_home(),
                        e = Eigen::VectorXd::Constant(6, 1e-4), nan = zero * std::nan("");
  fed.fail_at(q_hold);
  const Eigen::VectorXd q = q_hold + e, gravity = fed.law(q, zero),
                        held_torque = fed.law(q, fallback.stiffness * e);
  ASSERT_GT((held_torque - gravity).norm(), 0.1);
  EXPECT_LT((fed.tick(q, zero) - held_torque).norm(), 1e-9);
  // A gap of 10 ms is bridged with the last position; after that, only gravity is compensated.
  for (int i = 0; i < 10; ++i) EXPECT_LT((fed.tick(nan, nan) - held_torque).norm(), 1e-9) << i;
  for (int i = 0; i < 10; ++i) EXPECT_LT((fed.tick(nan, nan) - gravity).norm(), 1e-9) << i;
  const Eigen::VectorXd elsewhere = q_hold + 1e3 * e;
  EXPECT_LT((fed.tick(elsewhere, zero) - fed.law(elsewhere, zero)).norm(), 1e-9);
  const Eigen::VectorXd expected = fed.law(elsewhere + e, fallback.stiffness * e);
  EXPECT_LT((fed.tick(elsewhere + e, zero) - expected).norm(), 1e-9);
  // A sensor clock that stands still is treated as a missing measurement.
  for (int i = 0; i < 20; ++i) {
    fed.m.time -= 1e-3;
    fed.tick(elsewhere + e, zero);
  }
  EXPECT_LT((fed.tick(elsewhere, zero) - fed.law(elsewhere, zero)).norm(), 1e-9);
  EXPECT_EQ(fed.mpc.fault().kind, FaultKind::StaleMeasurement);
}

}  // namespace
}  // namespace burnish::test

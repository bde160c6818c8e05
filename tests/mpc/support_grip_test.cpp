// Feet that slip and motors that fail, as a controller of a robot on its feet finds them and what
// it makes of them.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/special_numbers.hpp"
#include "support/standing_problem.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

const std::vector<std::string> soles{"left_sole_link", "right_sole_link"};
constexpr double cone = 0.5, tick_period = 1e-3;

/// A biped that is to sway to its side, within what its feet bear.
MpcSpec swaying(const Model& model, const VectorXd& q) {
  MpcSpec spec;
  spec.problem = standing_problem(model, soles, q, 12);
  Stage& stand = spec.problem.stages[0];
  for (const std::string& sole : soles) {
    stand.constraints.push_back(
        {.name = "friction of " + sole, .residual = residual::FrictionCone{sole, cone}});
    stand.constraints.push_back(
        {.name = "pressure of " + sole,
         .residual = residual::CenterOfPressure{sole, 0.1, 0.05, cone / std::sqrt(2.0)}});
  }
  spec.schedule = {{.name = "stand", .stage = "stand"}};
  spec.tool = soles[0];
  spec.supports = soles;
  spec.support_sensors = true;
  spec.tick_period = tick_period;
  spec.update_period = 0.01;
  spec.model_error.kind = ModelErrorKind::None;
  spec.limits.torque_gap = 0.2;
  return spec;
}

/// Fed by hand: both feet bear half of the weight and rub along x with a share of that, as the base
/// and the feet with it are shoved along.
class Shoved : public ::testing::Test {
 protected:
  void SetUp() override { make(swaying(model, q)); }
  void make(const MpcSpec& spec) {
    mpc = std::make_unique<MpcController>(spec);
    measured.q = q;
    measured.v = measured.tau = VectorXd::Zero(model.nv);
    measured.support_wrenches.setZero(6, spec.support_sensors ? 2 : 0);
    lost.setOnes(model.nv);
  }
  const Command& step(double speed, double rubs) {
    measured.time += tick_period;
    measured.q[0] += tick_period * speed;
    measured.v[0] = speed;
    const double half = 0.5 * model.total_mass() * 9.81;
    for (Eigen::Index k = 0; k < measured.support_wrenches.cols(); ++k)
      measured.support_wrenches.col(k) << rubs * half, 0.0, half, 0.0, 0.0, 0.0;
    measured.tau = mpc->support_friction().size() > 0 && tau.size() > 0
                       ? VectorXd(lost.cwiseProduct(tau))
                       : VectorXd(VectorXd::Zero(model.nv));
    const Command& command = mpc->tick(measured);
    tau = command.tau;
    return command;
  }
  void steps(int count, double speed, double rubs) {
    for (int i = 0; i < count; ++i) step(speed, rubs);
  }

  Model model = biped::model(Base::FreeFlyer);
  VectorXd q = biped::half_sitting(model);
  VectorXd tau, lost;  ///< sent last; shares of it that motors give
  Measurement measured;
  std::unique_ptr<MpcController> mpc;
};

TEST_F(Shoved, plans_reckon_with_what_a_foot_was_felt_to_bear_while_it_slipped) {
  steps(20, 0.0, 0.04);
  EXPECT_EQ(mpc->support_friction(), VectorXd::Constant(2, cone));
  steps(300, 0.08, 0.04);
  const SlipOptions options;
  EXPECT_NEAR(mpc->support_friction()[0], options.share * 0.04, 0.004);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
  // The plan made last keeps within it, though the sway would take more.
  steps(20, 0.0, 0.0);
  const Problem& problem = mpc->problem();
  const MatrixView xs = mpc->solver().xs(), us = mpc->solver().us();
  Problem copy(problem.spec());
  double most = 0.0;
  for (int k = 0; k < problem.knots(); ++k) {
    const VectorXd forces = copy.forces(0, xs.row(k).transpose(), us.row(k).transpose());
    for (const Eigen::Index first : {0, 6})
      most = std::max(most, forces.segment<2>(first).norm() / forces[first + 2]);
  }
  EXPECT_LT(most, mpc->support_friction().maxCoeff() + 2e-3);
}

TEST_F(Shoved, trusts_the_ground_again_with_time_and_never_less_than_it_may) {
  steps(200, 0.08, 0.0);  // nothing was felt to rub
  EXPECT_NEAR(mpc->support_friction()[0], SlipOptions{}.least, 1e-3);
  steps(1000, 0.0, 0.0);
  EXPECT_NEAR(mpc->support_friction()[0], SlipOptions{}.least + SlipOptions{}.recovery, 0.01);
  mpc->reset();
  EXPECT_EQ(mpc->support_friction()[0], cone);
}

TEST_F(Shoved, takes_noise_creeping_and_light_feet_for_no_slip) {
  for (int i = 0; i < 300; ++i) step(i % 2 == 0 ? 0.05 : -0.05, 0.1);
  steps(300, 0.002, 0.1);
  EXPECT_EQ(mpc->support_friction(), VectorXd::Constant(2, cone));
}

TEST_F(Shoved, without_sensors_reckons_with_less_and_less) {
  MpcSpec spec = swaying(model, q);
  spec.support_sensors = false;
  make(spec);
  steps(20, 0.0, 0.0);
  steps(80, 0.08, 0.0);
  const double before = mpc->support_friction()[0];
  EXPECT_LT(before, 0.9 * cone);
  steps(100, 0.08, 0.0);
  EXPECT_LT(mpc->support_friction()[0], 0.5 * before);
}

TEST_F(Shoved, gives_up_with_a_foot_that_is_gone_too_far) {
  steps(10, 0.0, 0.1);
  int count = 0;
  while (mpc->fault().kind == FaultKind::None && ++count < 2000) step(0.5, 0.1);
  EXPECT_EQ(mpc->fault().kind, FaultKind::SupportSlipped);
  EXPECT_EQ(mpc->fault().quantity, soles[0]);
  EXPECT_NEAR(mpc->fault().value, SafetyLimits{}.support_way, 2e-3);
  EXPECT_TRUE(tau.allFinite());
}

TEST_F(Shoved, finds_the_motor_that_gives_nothing_and_holds_with_the_others) {
  MpcSpec spec = swaying(model, q);
  spec.limits.torque_gap = 0.05;
  make(spec);
  steps(200, 0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
  Eigen::Index joint = 0;
  ASSERT_GT(tau.cwiseAbs().maxCoeff(&joint), 10.0) << "else there is nothing to see";
  lost[joint] = 0.0;
  int count = 0;
  while (mpc->fault().kind == FaultKind::None && ++count < 500) step(0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::MotorLost);
  EXPECT_EQ(mpc->fault().joint, joint);
  EXPECT_LT(count, 100);
  // With that joint limp and the soles held, what is sent leaves all others where they are.
  step(0.0, 0.0);
  EXPECT_EQ(tau[joint], 0.0);
  std::vector<ContactSpec> held;
  for (const std::string& sole : soles) held.push_back({.name = sole, .tool = sole});
  ContactDynamics dynamics(model, held, {.mu = 1e-9});
  ASSERT_LE(dynamics.forward(q, VectorXd::Zero(model.nv), tau), Status::NotConverged);
  VectorXd moved = dynamics.a();
  moved.head<6>().setZero();
  EXPECT_LT(moved.norm(), 0.05);
}

TEST_F(Shoved, finds_nothing_wrong_with_motors_that_are_a_little_off) {
  lost.setConstant(0.85);
  steps(300, 0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
}

/// What is sent after a fault is for legs that stand, until their sensors say that they do not.
TEST_F(Shoved, lets_legs_hang_that_bear_nothing) {
  steps(5, 0.0, 0.0);
  measured.time += 1.0;  // stale
  step(0.0, 0.0);
  ASSERT_EQ(mpc->fault().kind, FaultKind::StaleMeasurement);
  step(0.0, 0.0);
  const VectorXd standing = tau;
  measured.support_wrenches.setZero();
  measured.time += tick_period;
  const VectorXd hanging = mpc->tick(measured).tau;
  ContactDynamics dynamics(model);
  const VectorXd zero = VectorXd::Zero(model.nv);
  ASSERT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  EXPECT_LT((hanging - dynamics.bias()).tail(model.nv - 6).norm(), 1e-3);
  EXPECT_GT((standing - hanging).norm(), 20.0);
  // A foot that bears a third of its part stands.
  measured.support_wrenches.row(2).setConstant(0.17 * model.total_mass() * 9.81);
  measured.time += tick_period;
  EXPECT_LT((mpc->tick(measured).tau - standing).norm(), 1e-3);
}

TEST_F(Shoved, allocates_nothing_while_it_slips_and_while_it_holds) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  MpcSpec spec = swaying(model, q);
  spec.limits.torque_gap = infinity;
  make(spec);
  steps(20, 0.0, 0.04);
  measured.time += tick_period;
  const AllocationGuard guard;
  for (int i = 0; i < 600; ++i) {
    measured.time += tick_period;
    measured.q[0] += tick_period * 0.8;
    measured.v[0] = 0.8;
    (void)mpc->tick(measured);
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::SupportSlipped);
}

}  // namespace
}  // namespace burnish::test

// Tests of the controller of a standing robot: whose wrenches it reads, and how it detects feet
// that slip and motors that fail and reacts.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"
#include "support/standing_problem.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

const std::vector<std::string> soles{"left_sole_link", "right_sole_link"};
constexpr double cone = 0.5, tick_period = 1e-3;

std::vector<TouchSensor> measured_soles() { return {{soles[0]}, {soles[1]}}; }

/// Biped that sways sideways within the friction cones and support areas of its feet.
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
  spec.supports = soles;
  spec.touches = measured_soles();
  spec.tick_period = tick_period;
  spec.update_period = 0.01;
  spec.model_error.kind = ModelErrorKind::None;
  spec.limits.torque_gap = 0.2;
  return spec;
}

/// Biped with measurements from the test. Each foot carries half of the weight, with a tangential
/// force along x as a fraction of it. Base and feet move along x.
class SupportGrip : public ::testing::Test {
 protected:
  void SetUp() override { make(swaying(model, q)); }
  void make(const MpcSpec& spec) {
    mpc = std::make_unique<MpcController>(spec);
    measured.q = q;
    measured.v = measured.tau = VectorXd::Zero(model.nv);
    measured.wrenches.setZero(6, static_cast<Eigen::Index>(spec.touches.size()));
    torque_scale.setOnes(model.nv);
  }
  const Command& step(double speed, double friction_ratio) {
    measured.time += tick_period;
    measured.q[0] += tick_period * speed;
    measured.v[0] = speed;
    const double half = 0.5 * model.total_mass() * 9.81;
    for (Eigen::Index k = 0; k < measured.wrenches.cols(); ++k)
      measured.wrenches.col(k) << friction_ratio * half, 0.0, half, 0.0, 0.0, 0.0;
    measured.tau = mpc->support_friction().size() > 0 && tau.size() > 0
                       ? VectorXd(torque_scale.cwiseProduct(tau))
                       : VectorXd(VectorXd::Zero(model.nv));
    const Command& command = mpc->tick(measured);
    tau = command.tau;
    return command;
  }
  void steps(int count, double speed, double friction_ratio) {
    for (int i = 0; i < count; ++i) step(speed, friction_ratio);
  }

  Model model = biped::model(Base::FreeFlyer);
  VectorXd q = biped::half_sitting(model);
  VectorXd tau, torque_scale;  ///< last command; fraction of it that each motor yields
  Measurement measured;
  std::unique_ptr<MpcController> mpc;
};

using Frames = std::vector<std::string>;

TEST_F(SupportGrip, Touches_AreTheToolAndThenTheStatedOnes) {
  for (const bool tool : {false, true})
    for (const bool sensors : {false, true}) {
      MpcSpec spec = swaying(model, q);
      if (tool) spec.tools = {{.frame = "tool"}};
      if (!sensors) spec.touches.clear();
      Frames expected;
      if (tool) expected.push_back("tool");
      if (sensors) expected.insert(expected.end(), soles.begin(), soles.end());
      EXPECT_EQ(touches_of(spec), expected) << tool << sensors;
      Frames read;
      const auto touches = MpcController(spec).touches();
      ASSERT_TRUE(touches.has_value());
      for (const TouchSensor& touch : *touches) read.push_back(touch.frame);
      EXPECT_EQ(read, expected) << tool << sensors;
    }
}

TEST_F(SupportGrip, ColumnOfAFrame_IsItsPlaceAmongTheTouchesIfItIsMeasured) {
  MpcSpec spec = swaying(model, q);
  spec.tools = {{.frame = "tool"}};
  EXPECT_EQ(wrench_column(spec, "tool"), 0);
  EXPECT_EQ(wrench_column(spec, soles[1]), 2);
  spec.touches = {{soles[0]}, {"tool", WrenchSensor::None}, {soles[1], WrenchSensor::None}};
  EXPECT_EQ(touches_of(spec), (Frames{soles[0], "tool", soles[1]}));
  EXPECT_EQ(wrench_column(spec, soles[0]), 0);
  for (const std::string& frame : {std::string("tool"), soles[1], std::string("no frame")})
    EXPECT_EQ(wrench_column(spec, frame), -1) << frame;
}

TEST_F(SupportGrip, AutomaticSensor_MeasuresMomentsOnlyOfSupports) {
  MpcSpec spec = swaying(model, q);
  spec.tools = {{.frame = "tool"}};
  spec.touches = {{soles[0]}, {"tool"}, {"left_hand"}};
  const std::vector<TouchSensor> sensors = touch_sensors(spec);
  ASSERT_EQ(sensors.size(), 3U);
  EXPECT_EQ(sensors[0].sensor, WrenchSensor::Wrench);
  EXPECT_EQ(sensors[1].sensor, WrenchSensor::Force);
  EXPECT_EQ(sensors[2].sensor, WrenchSensor::Force) << "a second tool, as in a scene";
}

TEST_F(SupportGrip, TouchesThatDoNotFit_AreRefused) {
  const auto refused = [&](const std::function<void(MpcSpec&)>& change) {
    MpcSpec spec = swaying(model, q);
    change(spec);
    return testing::refusal([&] { MpcController controller(spec); });
  };
  testing::expect_words(refused([](MpcSpec& s) { s.touches[0].frame = "left_sole_lnk"; }),
                        {"touch 'left_sole_lnk'", "'left_sole_link'"});
  testing::expect_words(refused([](MpcSpec& s) { s.touches[1] = s.touches[0]; }),
                        {"two entries", soles[0]});
  testing::expect_words(
      refused([](MpcSpec& s) { s.tools = {{.frame = soles[0]}}; }),
      {"tool '" + soles[0], "also the frame or the name of support", "a tool or a support"});
  testing::expect_words(refused([](MpcSpec& s) { s.touches[1].sensor = WrenchSensor::Force; }),
                        {soles[1], "no moment", "force and moment"});
  testing::expect_words(refused([](MpcSpec& s) {
                          s.problem.stages.push_back(s.problem.stages[0]);
                          s.problem.stages[1].name = "left foot lifted";
                          s.problem.stages[1].contacts = {soles[1]};
                          s.touches.erase(s.touches.begin());
                        }),
                        {"'left foot lifted'", "support '" + soles[0], "touches"});
}

/// One foot has a sensor. The other foot is held by its contact.
TEST_F(SupportGrip, OneMeasuredFoot_StandsStillAndSlipsAsWithTwo) {
  MpcSpec spec = swaying(model, q);
  spec.touches = {{soles[1]}};
  spec.model_error.kind = ModelErrorKind::Torque;
  spec.limits.torque_gap = infinity;
  MpcController controller(spec);
  Measurement m;
  m.q = q;
  m.v = m.tau = VectorXd::Zero(model.nv);
  m.wrenches.setZero(6, 1);
  m.wrenches(2, 0) = 0.5 * model.total_mass() * 9.81;
  double largest = 0.0;
  for (int tick = 0; tick < 200; ++tick) {
    m.time = tick_period * tick;
    const Command& command = controller.tick(m);
    EXPECT_TRUE(is_usable(command.status));
    m.tau = command.tau;
    largest = std::max(largest, command.tau.cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(controller.fault().kind, FaultKind::None) << controller.fault().text();
  EXPECT_LT(largest, 500.0);
  m.time += tick_period;
  m.wrenches(4, 0) = std::nan("");
  (void)controller.tick(m);
  EXPECT_FALSE(is_usable(controller.tick(m).status)) << "the moment of this foot is needed";
}

/// A controller with a tool reads the wrenches on the feet from the columns after the first.
TEST_F(SupportGrip, ToolBeforeTheFeet_DoesNotChangeTheFriction) {
  const auto friction_of = [&](bool tool) {
    MpcSpec spec = swaying(model, q);
    if (tool) spec.tools = {{.frame = "tool"}};
    spec.limits.torque_gap = infinity;
    MpcController controller(spec);
    Measurement m;
    m.q = q;
    m.v = m.tau = VectorXd::Zero(model.nv);
    m.wrenches.setZero(6, tool ? 3 : 2);
    m.wrenches.rightCols(2).row(0).setConstant(0.02 * model.total_mass() * 9.81);
    m.wrenches.rightCols(2).row(2).setConstant(0.5 * model.total_mass() * 9.81);
    for (int tick = 0; tick < 100; ++tick) {
      m.time = tick_period * tick;
      m.q[0] = q[0] + 0.08 * m.time;
      m.v[0] = 0.08;
      (void)controller.tick(m);
    }
    EXPECT_EQ(controller.fault().kind, FaultKind::None) << controller.fault().text();
    return VectorXd(controller.support_friction());
  };
  EXPECT_LT(friction_of(false).maxCoeff(), 0.9 * cone) << "no slip: this test checks nothing";
  EXPECT_EQ(friction_of(true), friction_of(false));
}

TEST_F(SupportGrip, RestingSupport_CarriesNothing) {
  MpcSpec spec = swaying(model, q);
  const std::string left = spec.supports[0], right = spec.supports[1];
  spec.resting_supports = {right};
  make(spec);
  step(0.0, 0.0);
  EXPECT_EQ(mpc->support_friction().size(), 1) << "only the left foot carries the robot";
  EXPECT_EQ(touches_of(spec).size(), 2U) << "the force of the right foot is measured";
  spec.resting_supports = {"right_sol"};
  testing::expect_words(testing::refusal([&] { MpcController controller(spec); }),
                        {"resting support", "right_sol", "not one of the supports"});
  spec.resting_supports = {left};
  spec.touches = {{right}};
  testing::expect_words(testing::refusal([&] { MpcController controller(spec); }),
                        {left, "not measured", "sensor of force and moment", "touches"});
}

TEST_F(SupportGrip, SlippingFeet_LowerThePlannedFriction) {
  steps(20, 0.0, 0.04);
  EXPECT_EQ(mpc->support_friction(), VectorXd::Constant(2, cone));
  steps(300, 0.08, 0.04);
  const SlipOptions options;
  EXPECT_NEAR(mpc->support_friction()[0], options.friction_fraction * 0.04, 0.004);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
  // The last plan keeps within the friction estimate, although swaying would need more.
  steps(20, 0.0, 0.0);
  const Problem& problem = mpc->problem();
  const MatrixView xs = mpc->solver().xs(), us = mpc->solver().us();
  Problem copy(problem.spec());
  double max_ratio = 0.0;
  for (int k = 0; k < problem.knots(); ++k) {
    const VectorXd forces = copy.forces(0, xs.row(k).transpose(), us.row(k).transpose());
    for (const Eigen::Index first : {0, 6})
      max_ratio = std::max(max_ratio, forces.segment<2>(first).norm() / forces[first + 2]);
  }
  EXPECT_LT(max_ratio, mpc->support_friction().maxCoeff() + 2e-3);
}

TEST_F(SupportGrip, FrictionAfterASlip_RecoversFromItsMinimum) {
  steps(200, 0.08, 0.0);  // no tangential force was measured
  EXPECT_NEAR(mpc->support_friction()[0], SlipOptions{}.min_friction, 1e-3);
  steps(1000, 0.0, 0.0);
  EXPECT_NEAR(mpc->support_friction()[0], SlipOptions{}.min_friction + SlipOptions{}.recovery,
              0.01);
  mpc->reset();
  EXPECT_EQ(mpc->support_friction()[0], cone);
}

TEST_F(SupportGrip, NoiseAndSlowCreep_AreNotTakenForSlip) {
  for (int i = 0; i < 300; ++i) step(i % 2 == 0 ? 0.05 : -0.05, 0.1);
  steps(300, 0.002, 0.1);
  EXPECT_EQ(mpc->support_friction(), VectorXd::Constant(2, cone));
}

TEST_F(SupportGrip, SlipWithoutFootSensors_LowersTheFrictionWithTime) {
  MpcSpec spec = swaying(model, q);
  spec.touches.clear();
  make(spec);
  steps(20, 0.0, 0.0);
  steps(80, 0.08, 0.0);
  const double before = mpc->support_friction()[0];
  EXPECT_LT(before, 0.9 * cone);
  steps(100, 0.08, 0.0);
  EXPECT_LT(mpc->support_friction()[0], 0.5 * before);
}

TEST_F(SupportGrip, LongSlip_IsAFaultThatNamesTheFoot) {
  steps(10, 0.0, 0.1);
  int count = 0;
  while (mpc->fault().kind == FaultKind::None && ++count < 2000) step(0.5, 0.1);
  EXPECT_EQ(mpc->fault().kind, FaultKind::SupportSlipped);
  EXPECT_EQ(mpc->fault().quantity, soles[0]);
  EXPECT_NEAR(mpc->fault().value, SafetyLimits{}.support_slip, 2e-3);
  EXPECT_TRUE(tau.allFinite());
}

TEST_F(SupportGrip, LostMotor_IsFoundAndTheOthersHoldTheRobot) {
  MpcSpec spec = swaying(model, q);
  spec.limits.torque_gap = 0.05;
  make(spec);
  steps(200, 0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
  Eigen::Index joint = 0;
  ASSERT_GT(tau.cwiseAbs().maxCoeff(&joint), 10.0) << "the joint needs a torque to lose";
  torque_scale[joint] = 0.0;
  int count = 0;
  while (mpc->fault().kind == FaultKind::None && ++count < 500) step(0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::MotorLost);
  EXPECT_EQ(mpc->fault().joint, joint);
  EXPECT_LT(count, 100);
  // With that joint limp and the soles fixed, the command leaves all other joints at rest.
  step(0.0, 0.0);
  EXPECT_EQ(tau[joint], 0.0);
  std::vector<ContactSpec> fixed_soles;
  for (const std::string& sole : soles) fixed_soles.push_back({.name = sole, .tool = sole});
  ContactDynamics dynamics(model, fixed_soles, {.mu = 1e-9});
  ASSERT_LE(dynamics.forward(q, VectorXd::Zero(model.nv), tau), Status::NotConverged);
  VectorXd moved = dynamics.a();
  moved.head<6>().setZero();
  EXPECT_LT(moved.norm(), 0.05);
}

TEST_F(SupportGrip, SmallTorqueDeviation_IsNoFault) {
  torque_scale.setConstant(0.85);
  steps(300, 0.0, 0.0);
  EXPECT_EQ(mpc->fault().kind, FaultKind::None) << mpc->fault().text();
}

/// The fallback torques assume standing legs until the foot sensors measure no load.
TEST_F(SupportGrip, UnloadedLegsAfterAFault_OnlyCompensateGravity) {
  steps(5, 0.0, 0.0);
  measured.time += 1.0;  // makes the measurement stale
  step(0.0, 0.0);
  ASSERT_EQ(mpc->fault().kind, FaultKind::StaleMeasurement);
  step(0.0, 0.0);
  const VectorXd standing = tau;
  measured.wrenches.setZero();
  measured.time += tick_period;
  const VectorXd hanging = mpc->tick(measured).tau;
  ContactDynamics dynamics(model);
  const VectorXd zero = VectorXd::Zero(model.nv);
  ASSERT_EQ(dynamics.forward(q, zero, zero), Status::Ok);
  EXPECT_LT((hanging - dynamics.bias()).tail(model.nv - 6).norm(), 1e-3);
  EXPECT_GT((standing - hanging).norm(), 20.0);
  // A foot with a third of its nominal load counts as standing.
  measured.wrenches.row(2).setConstant(0.17 * model.total_mass() * 9.81);
  measured.time += tick_period;
  EXPECT_LT((mpc->tick(measured).tau - standing).norm(), 1e-3);
}

TEST_F(SupportGrip, SlipAndFallback_AllocateNothing) {
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

// Tests of joint friction, estimated from a torque error that reverses with the joint velocities.
#include "estimate/joint_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "mpc/part_specs.hpp"
#include "support/allocation_guard.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

JointFriction friction_of(const MpcSpec& spec) {
  return JointFriction(spec.problem.model, spec.model_error, loop_times(spec), {});
}

/// Joints that oscillate, all with the same friction, and a torque error observer for the error
/// that the compensation leaves.
struct SwingingJoints {
  explicit SwingingJoints(double coulomb_of_plant, double viscous_of_plant, bool enabled = true)
      : coulomb(coulomb_of_plant), viscous(viscous_of_plant) {
    spec = toy_spec();
    spec.model_error.kind = ModelErrorKind::Torque;
    spec.model_error.bandwidth = bandwidth;
    spec.model_error.joint_friction = enabled;
    friction.emplace(friction_of(spec));
    const int nv = spec.problem.model.nv;
    noise_speed = v = v_ahead = error = first = Eigen::VectorXd::Zero(nv);
  }

  void run(double duration) {
    for (const double end = time + duration; time < end; time += dt) step();
  }
  void step() {
    const double filter_gain = -std::expm1(-bandwidth * dt);
    for (Eigen::Index k = 0; k < v.size(); ++k) {
      noise_speed[k] += 0.02 * (velocity_noise * 20.0 * noise(random) - noise_speed[k]);
      v[k] = speed(k, time - dt) + noise_speed[k];
    }
    friction->learn(error, v, bandwidth, dt);
    for (Eigen::Index k = 0; k < v_ahead.size(); ++k)
      v_ahead[k] = speed(k, time + friction->lead());
    friction->foresee(v_ahead.data());
    friction->advance(dt);
    for (Eigen::Index k = 0; k < error.size(); ++k) {
      const double now = speed(k, time);
      const double drift = 2.0 + 0.3 * std::sin(0.7 * time + static_cast<double>(k));
      const double lost = std::copysign(coulomb, now) + viscous * now;
      const double remaining = drift + push + friction->torque()[k] - lost + noise(random);
      first[k] += filter_gain * (remaining - first[k]);
      error[k] += filter_gain * (first[k] - error[k]);
    }
  }
  static double speed(Eigen::Index k, double t) {
    return 0.1 * std::sin(t + static_cast<double>(k));
  }

  static constexpr double dt = 5e-4, bandwidth = 150.0;
  double coulomb, viscous, push = 0.0, time = 0.0;
  double velocity_noise = 0.0;  ///< noise of measured velocities [rad/s]
  MpcSpec spec;
  std::optional<JointFriction> friction;
  Eigen::VectorXd noise_speed, v, v_ahead, error, first;
  std::mt19937 random{1};
  std::normal_distribution<double> noise{0.0, 0.5};
};

TEST(JointFriction, PlaceholderEffortLimit_GivesThePriorOfAnUnlimitedJoint) {
  MpcSpec spec = toy_spec();
  spec.model_error.kind = ModelErrorKind::Torque;
  spec.problem.model.effort_limit.setConstant(1e9);
  const JointFriction placeholder = friction_of(spec);
  spec.problem.model.effort_limit.setConstant(std::numeric_limits<double>::infinity());
  const JointFriction unlimited = friction_of(spec);
  spec.problem.model.effort_limit.setConstant(10.0);
  const JointFriction limited = friction_of(spec);
  EXPECT_EQ(placeholder.deviation(0), unlimited.deviation(0));
  EXPECT_DOUBLE_EQ(limited.deviation(0), 0.3);
}

TEST(JointFriction, JointsThatReversed_AreCompensated) {
  SwingingJoints swing(1.0, 0.5);
  swing.run(8.0);
  for (int k = 0; k < swing.v_ahead.size(); ++k) {
    EXPECT_NEAR(swing.friction->coulomb(k), 1.0, 0.15) << k;
    EXPECT_LT(swing.friction->deviation(k), 0.2) << k;
    // The compensation matches the friction, except briefly where the joint reverses.
    const double v = SwingingJoints::speed(k, swing.time);
    if (std::abs(v) < 0.03) continue;
    EXPECT_NEAR(swing.friction->torque()[k], std::copysign(1.0, v) + 0.5 * v, 0.3) << k;
  }
}

TEST(JointFriction, FrictionlessJoints_GetAlmostNoCompensation) {
  SwingingJoints swing(0.0, 0.0);
  swing.run(8.0);
  EXPECT_LT(swing.friction->torque().cwiseAbs().maxCoeff(), 0.1);
}

TEST(JointFriction, ShortPush_DoesNotChangeTheEstimate) {
  SwingingJoints swing(1.0, 0.0);
  swing.run(6.0);
  swing.push = 8.0;
  swing.run(0.1);
  swing.push = 0.0;
  swing.run(0.5);
  for (int k = 0; k < swing.v_ahead.size(); ++k)
    EXPECT_NEAR(swing.friction->coulomb(k), 1.0, 0.25) << k;
}

TEST(JointFriction, JointsAtRest_GetNoCompensation) {
  SwingingJoints swing(1.0, 0.5);
  swing.run(6.0);
  swing.v_ahead.setZero();
  for (int i = 0; i < 1000; ++i) {
    swing.friction->foresee(swing.v_ahead.data());
    swing.friction->advance(SwingingJoints::dt);
  }
  EXPECT_LT(swing.friction->torque().cwiseAbs().maxCoeff(), 1e-2);
}

TEST(JointFriction, DisabledOrReset_GivesNoCompensation) {
  SwingingJoints off(1.0, 0.5, false);
  off.run(2.0);
  EXPECT_TRUE(off.friction->torque().isZero(0.0));
  SwingingJoints swing(1.0, 0.5);
  swing.run(6.0);
  swing.friction->reset();
  EXPECT_TRUE(swing.friction->torque().isZero(0.0));
  EXPECT_EQ(swing.friction->coulomb(0), 0.0);
}

/// Noise throws a light joint to and fro about rest. The sign of its velocity is uncertain, and
/// full compensation would drive the joint.
TEST(JointFriction, VelocityNoise_ReducesTheCompensation) {
  SwingingJoints swing(1.0, 0.0);
  swing.run(6.0);
  swing.velocity_noise = 0.8;
  swing.run(1.0);
  EXPECT_LT(swing.friction->torque().cwiseAbs().maxCoeff(), 0.5);
  swing.velocity_noise = 0.0;
  swing.run(4.0);
  EXPECT_GT(swing.friction->torque().cwiseAbs().maxCoeff(), 0.8);
}

TEST(JointFriction, Update_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  SwingingJoints swing(1.0, 0.5);
  swing.step();
  const AllocationGuard guard;
  swing.run(0.05);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace burnish::test

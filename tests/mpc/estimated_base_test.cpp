// What stands between sensing and a controller: a measurement whose base is estimated.
#include "burnish/mpc/estimated_base.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

/// A biped that stands still, and what its sensors say.
struct StandingBiped {
  StandingBiped() {
    options.feet = {{"left_sole_link", FootKind::Sole}, {"right_sole_link", FootKind::Sole}};
    measured.q = biped::half_sitting(model);
    measured.v = VectorXd::Zero(model.nv);
    ContactDynamics dynamics(model);
    RigidBody body(model);
    EXPECT_EQ(body.update(measured.q, measured.v), Status::Ok);
    EXPECT_EQ(dynamics.inverse(measured.q, measured.v, measured.v, VectorXd()), Status::Ok);
    measured.tau = dynamics.tau();
    FrameDerivatives by;
    const double weight = -model.total_mass() * model.gravity.z();
    for (const FootSpec& foot : options.feet) {
      const int frame = body.frame(foot.frame);
      body.frame_derivatives(frame, Reference::centered(), by);
      Vector6 wrench;
      wrench.head<3>() << 0.0, 0.0, 0.5 * weight;
      wrench.tail<3>() = (body.com() - body.placement(frame).translation())
                             .cross(Eigen::Vector3d(wrench.head<3>()));
      measured.tau -= by.jacobian.transpose() * wrench;
    }
    EXPECT_LT(measured.tau.head<6>().norm(), 1e-6);
    measured.imu = ImuReading{Eigen::Vector3d::Zero(), -model.gravity};
    truth = measured.q;
    measured.q.head<7>().setConstant(nan);  // nobody measures these
    measured.v.head<6>().setConstant(nan);
  }
  Measurement at(int tick) {
    measured.time = 1e-3 * tick;
    return measured;
  }
  /// Sensors in the feet: shares of the weight, straight up, in axes of the soles.
  void load(double left, double right) {
    RigidBody body(model);
    EXPECT_EQ(body.update(truth, VectorXd::Zero(model.nv)), Status::Ok);
    measured.support_wrenches.setZero(6, 2);
    const double shares[] = {left, right};
    for (int k = 0; k < 2; ++k) {
      const Eigen::Matrix3d R =
          body.placement(body.frame(options.feet[static_cast<std::size_t>(k)].frame)).linear();
      measured.support_wrenches.col(k).head<3>() =
          -shares[k] * model.total_mass() * (R.transpose() * model.gravity);
    }
  }
  Model model = biped::model(Base::FreeFlyer);
  BaseEstimatorOptions options;
  Measurement measured;
  VectorXd truth;
};

TEST(EstimatedBase, TellsTheBaseByTorquesOrByFootSensors) {
  for (const bool sensors : {false, true}) {
    StandingBiped biped;
    EstimatedBase base(biped.model, biped.options);
    ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
    const double weight = -biped.model.total_mass() * biped.model.gravity.z();
    if (sensors) biped.load(0.5, 0.5);
    for (int tick = 0; tick < 200; ++tick) {
      const Measurement& told = base.update(biped.at(tick));
      ASSERT_EQ(base.status(), Status::Ok) << tick;
      ASSERT_TRUE(told.q.allFinite() && told.v.allFinite());
      EXPECT_EQ(told.time, biped.measured.time);
      EXPECT_LT((told.q - biped.truth).norm(), 1e-6);
      EXPECT_LT(told.v.norm(), 1e-6);
      EXPECT_TRUE(told.tau == biped.measured.tau);
      EXPECT_EQ(told.support_wrenches.cols(), sensors ? 2 : 0);
    }
    EXPECT_EQ(base.estimator().feet_that_count(), 3U);
    EXPECT_NEAR(base.contacts().forces()[0], 0.5 * weight, 1e-3 * weight);
    // One foot is unloaded.
    if (!sensors) continue;
    biped.load(1.0, 0.0);
    for (int tick = 200; tick < 300; ++tick) base.update(biped.at(tick));
    EXPECT_EQ(base.estimator().feet_that_count(), 1U);
  }
}

TEST(EstimatedBase, WhatCannotBeUsedLeavesTheBaseAndIsBridged) {
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options);
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  for (int tick = 0; tick < 50; ++tick) base.update(biped.at(tick));
  const VectorXd told = base.update(biped.at(50)).q.head<7>();
  Measurement bad = biped.at(51);
  bad.imu.reset();
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), told);
  EXPECT_EQ(base.status(), Status::WrongSize);
  bad = biped.at(52);
  bad.q[10] = nan;
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), told);
  EXPECT_EQ(base.status(), Status::NotFinite);
  bad = biped.at(40);  // time goes back
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), told);
  EXPECT_EQ(base.status(), Status::NotFinite);
  bad = biped.at(53);
  bad.support_wrenches.setOnes(6, 1);
  base.update(bad);
  EXPECT_EQ(base.status(), Status::WrongSize);
  bad = biped.at(54);
  bad.tau = Eigen::Vector3d::Ones();
  base.update(bad);
  EXPECT_EQ(base.status(), Status::WrongSize);
  const Measurement& good = base.update(biped.at(55));
  EXPECT_EQ(base.status(), Status::Ok);
  EXPECT_LT((good.q - biped.truth).norm(), 1e-6);
}

TEST(EstimatedBase, ASilentUnitIsDoneWithoutAndTakenBack) {
  for (const bool sensors : {false, true}) {
    StandingBiped biped;
    EstimatedBase base(biped.model, biped.options);
    ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
    if (sensors) biped.load(0.5, 0.5);
    for (int tick = 0; tick < 1200; ++tick) {
      Measurement measured = biped.at(tick);
      const bool silent = tick >= 100 && tick < 300;
      measured.imu->gyro.x() = 1e-9 * (tick % 2);  // one that repeats itself is not taken back
      if (silent) measured.imu.reset();
      const Measurement& told = base.update(measured);
      EXPECT_LT((told.q - biped.truth).norm(), 1e-6) << tick;
      EXPECT_EQ(told.base_lost_for, 0.0);
      if (tick > 104) {
        EXPECT_EQ(base.status(), Status::Ok) << tick;
      }
      if (tick > 104 && tick < 790) {
        EXPECT_EQ(base.base().source(), BaseSource::Feet) << tick;
      }
    }
    EXPECT_EQ(base.base().source(), BaseSource::Filter);
    EXPECT_EQ(base.base().takeovers(), 1);
  }
}

TEST(EstimatedBase, SaysForHowLongNothingTellsTheBase) {
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options);
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  biped.load(0.5, 0.5);
  for (int tick = 0; tick < 100; ++tick) base.update(biped.at(tick));
  biped.load(0.0, 0.0);
  double longest = 0.0;
  for (int tick = 100; tick < 300; ++tick) {
    Measurement measured = biped.at(tick);
    measured.imu.reset();
    const Measurement& told = base.update(measured);
    ASSERT_TRUE(told.q.allFinite() && told.v.allFinite());
    longest = told.base_lost_for;
  }
  EXPECT_NEAR(longest, 0.185, 0.015);  // forces fade out for some ms
  EXPECT_EQ(base.update(biped.at(300)).base_lost_for, 0.0) << "a unit that speaks is something";
}

TEST(EstimatedBase, TicksAllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options);
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  const AllocationGuard guard;
  for (int tick = 0; tick < 20; ++tick) {
    biped.measured.time = 1e-3 * tick;
    base.update(biped.measured);
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(base.status(), Status::Ok);
}

}  // namespace
}  // namespace burnish::test

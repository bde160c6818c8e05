// Tests of EstimatedBase, which replaces the base in measurements by its estimate.
#include "burnish/estimate/estimated_base.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "support/allocation_guard.hpp"
#include "support/biped.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

/// Biped that stands still, with the readings of its sensors.
struct StandingBiped {
  explicit StandingBiped(const Model& carried = biped::model(Base::FreeFlyer)) : model(carried) {
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
    measured.q.head<7>().setConstant(nan);  // not measured
    measured.v.head<6>().setConstant(nan);
  }
  Measurement at(int tick) {
    measured.time = 1e-3 * tick;
    return measured;
  }
  /// Sets the foot sensors to vertical forces, each a fraction of the weight, in the axes of the
  /// soles.
  void load(double left, double right) {
    RigidBody body(model);
    EXPECT_EQ(body.update(truth, VectorXd::Zero(model.nv)), Status::Ok);
    measured.wrenches.setZero(6, 2);
    const double fractions[] = {left, right};
    for (int k = 0; k < 2; ++k) {
      const Eigen::Matrix3d R =
          body.placement(body.frame(options.feet[static_cast<std::size_t>(k)].frame)).linear();
      measured.wrenches.col(k).head<3>() =
          -fractions[k] * model.total_mass() * (R.transpose() * model.gravity);
    }
  }
  Model model;
  BaseEstimatorOptions options;
  Measurement measured;
  VectorXd truth;
};

TEST(EstimatedBase, StandingBiped_EstimatesTheBaseFromTorquesOrFootSensors) {
  for (const bool sensors : {false, true}) {
    StandingBiped biped;
    EstimatedBase base(biped.model, biped.options);
    ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
    const double weight = -biped.model.total_mass() * biped.model.gravity.z();
    if (sensors) biped.load(0.5, 0.5);
    for (int tick = 0; tick < 200; ++tick) {
      const Measurement& estimated = base.update(biped.at(tick));
      ASSERT_EQ(base.status(), Status::Ok) << tick;
      ASSERT_TRUE(estimated.q.allFinite() && estimated.v.allFinite());
      EXPECT_EQ(estimated.time, biped.measured.time);
      EXPECT_LT((estimated.q - biped.truth).norm(), 1e-6);
      EXPECT_LT(estimated.v.norm(), 1e-6);
      EXPECT_TRUE(estimated.tau == biped.measured.tau);
      if (sensors) {
        EXPECT_EQ(estimated.wrenches, biped.measured.wrenches);
      } else {
        EXPECT_EQ(estimated.wrenches.cols(), 2);
        EXPECT_TRUE(estimated.wrenches.array().isNaN().all());
      }
    }
    EXPECT_EQ(base.estimator().feet_that_count(), 3U);
    EXPECT_NEAR(base.contacts().forces()[0], 0.5 * weight, 1e-3 * weight);
    // The right foot is unloaded.
    if (!sensors) continue;
    biped.load(1.0, 0.0);
    for (int tick = 200; tick < 300; ++tick) base.update(biped.at(tick));
    EXPECT_EQ(base.estimator().feet_that_count(), 1U);
  }
}

TEST(EstimatedBase, FeetInAnotherOrderOfTouches_GiveTheSameBits) {
  StandingBiped biped;
  biped.load(0.7, 0.3);
  EstimatedBase base(biped.model, biped.options);
  EstimatedBase other(biped.model, biped.options, {},
                      {"hand", "right_sole_link", "left_sole_link", "tool"});
  for (EstimatedBase* each : {&base, &other})
    ASSERT_EQ(each->reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  for (int tick = 0; tick < 100; ++tick) {
    const Measurement measured = biped.at(tick);
    Measurement reordered = measured;
    // Nothing is measured at the hand. The wrench on the tool would show if it counted as a foot.
    reordered.wrenches.setConstant(6, 4, nan);
    reordered.wrenches.col(1) = measured.wrenches.col(1);
    reordered.wrenches.col(2) = measured.wrenches.col(0);
    reordered.wrenches.col(3).setConstant(500.0);
    const Measurement& expected = base.update(measured);
    const Measurement& estimated = other.update(reordered);
    ASSERT_EQ(base.status(), Status::Ok) << tick;
    ASSERT_EQ(other.status(), Status::Ok) << tick;
    ASSERT_TRUE(estimated.q == expected.q && estimated.v == expected.v) << tick;
    ASSERT_EQ(other.contacts().forces(), base.contacts().forces()) << tick;
    ASSERT_TRUE(estimated.wrenches.col(0).array().isNaN().all());
    ASSERT_EQ(estimated.wrenches.rightCols(3), reordered.wrenches.rightCols(3));
  }
  EXPECT_GT(base.contacts().forces()[0], 1.5 * base.contacts().forces()[1])
      << "equal forces do not show the order";
}

/// The sensors show another force than the torques, which carry half of the weight on each foot.
TEST(EstimatedBase, UnmeasuredForceOnAFoot_IsReplacedByTheTorques) {
  StandingBiped biped;
  biped.load(0.8, 0.2);
  const double weight = -biped.model.total_mass() * biped.model.gravity.z();
  const auto force_on_the_left = [&](int row, int column) {
    EstimatedBase base(biped.model, biped.options);
    EXPECT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
    for (int tick = 0; tick < 200; ++tick) {
      Measurement measured = biped.at(tick);
      measured.wrenches(row, column) = nan;
      EXPECT_LT((base.update(measured).q - biped.truth).norm(), 1e-6);
      EXPECT_EQ(base.status(), Status::Ok) << tick;
    }
    return base.contacts().forces()[0];
  };
  for (const int column : {0, 1}) {
    EXPECT_NEAR(force_on_the_left(2, column), 0.5 * weight, 1e-3 * weight) << column;
    // Moments are not used.
    EXPECT_NEAR(force_on_the_left(5, column), 0.8 * weight, 1e-3 * weight) << column;
  }
}

TEST(EstimatedBase, OtherNumberOfWrenchesThanTouches_IsAWrongSize) {
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options, {}, {"tool", "left_sole_link", "right_sole_link"});
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  int tick = 0;
  base.update(biped.at(tick++));
  for (const int columns : {1, 2, 4}) {
    Measurement measured = biped.at(tick++);
    measured.wrenches.setOnes(6, columns);
    const Measurement& estimated = base.update(measured);
    EXPECT_EQ(base.status(), Status::WrongSize) << columns;
    EXPECT_EQ(estimated.wrenches.cols(), 3) << columns;
    EXPECT_TRUE(estimated.wrenches.array().isNaN().all()) << columns;
  }
  base.update(biped.at(tick++));  // no columns
  EXPECT_EQ(base.status(), Status::Ok);
}

/// Without foot sensors, the forces on the feet are computed from torques, which include the load.
TEST(EstimatedBase, Payload_CountsInTheForcesOnTheFeet) {
  InertiaSpec load;
  load.mass = 8.0;
  load.com = {0.05, 0.0, 0.1};
  load.inertia_at_com = 0.02 * Eigen::Matrix3d::Identity();
  const Model bare = biped::model(Base::FreeFlyer);
  const std::string frame = bare.frames.back().name;
  StandingBiped biped(with_payload(bare, {frame, load}));
  const double weight = -biped.model.total_mass() * biped.model.gravity.z();
  const auto total_load = [&](bool is_set) {
    EstimatedBase base(bare, biped.options);
    if (is_set) {
      EXPECT_EQ(base.set_payload(frame, load), Status::Ok);
    }
    EXPECT_EQ(base.reset(biped.truth, VectorXd::Zero(bare.nv)), Status::Ok);
    for (int tick = 0; tick < 100; ++tick) {
      const Measurement& estimated = base.update(biped.at(tick));
      EXPECT_EQ(estimated.base_payload, is_set ? load.mass : 0.0);
      EXPECT_LT((estimated.q - biped.truth).norm(), 1e-6);
    }
    return base.contacts().forces().sum();
  };
  EXPECT_NEAR(total_load(true), weight, 1e-6 * weight);
  EXPECT_LT(total_load(false), 0.99 * weight) << "the load has no effect: this test checks nothing";
  EstimatedBase base(bare, biped.options);
  InertiaSpec bad = load;
  bad.inertia_at_com(0, 0) = 1.0;
  EXPECT_EQ(base.set_payload(frame, bad), Status::NotPhysical);
  EXPECT_THROW((void)base.set_payload("no frame", load), Error);
}

TEST(EstimatedBase, InvalidMeasurement_KeepsTheLastBase) {
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options);
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  for (int tick = 0; tick < 50; ++tick) base.update(biped.at(tick));
  const VectorXd estimated = base.update(biped.at(50)).q.head<7>();
  Measurement bad = biped.at(51);
  bad.imu.reset();
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), estimated);
  EXPECT_EQ(base.status(), Status::WrongSize);
  bad = biped.at(52);
  bad.q[10] = nan;
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), estimated);
  EXPECT_EQ(base.status(), Status::NotFinite);
  bad = biped.at(40);  // time goes back
  EXPECT_EQ(VectorXd(base.update(bad).q.head<7>()), estimated);
  EXPECT_EQ(base.status(), Status::NotFinite);
  bad = biped.at(53);
  bad.wrenches.setOnes(6, 1);
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

TEST(EstimatedBase, SilentImu_FallsBackToTheFeetUntilItReturns) {
  for (const bool sensors : {false, true}) {
    StandingBiped biped;
    EstimatedBase base(biped.model, biped.options);
    ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
    if (sensors) biped.load(0.5, 0.5);
    for (int tick = 0; tick < 1200; ++tick) {
      Measurement measured = biped.at(tick);
      const bool silent = tick >= 100 && tick < 300;
      measured.imu->gyro.x() =
          1e-9 * (tick % 2);  // a reading that repeats itself is not accepted again
      if (silent) measured.imu.reset();
      const Measurement& estimated = base.update(measured);
      EXPECT_LT((estimated.q - biped.truth).norm(), 1e-6) << tick;
      EXPECT_EQ(estimated.base_lost_for, 0.0);
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

TEST(EstimatedBase, LostImuAndFeet_ReportTheTimeWithoutAnEstimate) {
  StandingBiped biped;
  EstimatedBase base(biped.model, biped.options);
  ASSERT_EQ(base.reset(biped.truth, VectorXd::Zero(biped.model.nv)), Status::Ok);
  biped.load(0.5, 0.5);
  for (int tick = 0; tick < 100; ++tick) base.update(biped.at(tick));
  biped.load(0.0, 0.0);
  double lost_for = 0.0;
  for (int tick = 100; tick < 300; ++tick) {
    Measurement measured = biped.at(tick);
    measured.imu.reset();
    const Measurement& estimated = base.update(measured);
    ASSERT_TRUE(estimated.q.allFinite() && estimated.v.allFinite());
    lost_for = estimated.base_lost_for;
  }
  EXPECT_NEAR(lost_for, 0.185, 0.015);  // the estimated forces decay within some milliseconds
  EXPECT_EQ(base.update(biped.at(300)).base_lost_for, 0.0) << "the IMU reads again";
}

TEST(EstimatedBase, Update_AllocatesNothing) {
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

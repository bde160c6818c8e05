// Tests of the base estimator on robots: consistency with encoder and IMU noise, drift, feet that
// slip, invalid input.
#include "burnish/estimate/base_estimator.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "burnish/dynamics/placement.hpp"
#include "estimate/chi_square.hpp"
#include "estimate/on_feet.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using burnish::testing::expect_words;
using burnish::testing::refusal;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sets the options to the true noise: encoder noise only, and feet that do not creep.
BaseEstimatorOptions with_true_noise(BaseEstimatorOptions options) {
  options.place_noise = 1e-6;
  options.turn_noise = 1e-6;
  options.slip_noise = options.sole_turn_noise = 0.0;
  options.encoder_noise = 3e-4;
  options.yaw_deviation = 0.01;
  options.gate = 1.0 - 1e-9;
  return options;
}

void expect_consistent(LeggedRobot robot, const RobotMotion& motion, const std::string& name) {
  constexpr int seeds = 50;
  robot.options = with_true_noise(robot.options);
  const std::vector<std::size_t> check_ticks = {10, motion.q.size() / 3, motion.q.size() - 1};
  std::vector<double> observable(check_ticks.size(), 0.0), whole(check_ticks.size(), 0.0);
  double squares = 0.0;
  long rows = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    Estimation run(robot, motion, seed);
    for (std::size_t i = 1, sample = 0; i < motion.q.size(); ++i) {
      ASSERT_EQ(run.tick(i), Status::Ok);
      ASSERT_EQ(run.estimator.feet_that_slip(), 0U) << seed << " " << i;
      if (sample == check_ticks.size() || i != check_ticks[sample]) continue;
      observable[sample] += run.observable_square(i) / seeds;
      whole[sample++] += run.whole_square(i) / seeds;
    }
    squares += run.squared_innovations();
    rows += run.innovation_rows();
  }
  const auto check = [&](double mean, int dof, const std::string& label) {
    EXPECT_GT(mean, chi_square_quantile(dof * seeds, 0.5e-4) / seeds) << label;
    EXPECT_LT(mean, chi_square_quantile(dof * seeds, 1.0 - 0.5e-4) / seeds) << label;
    ::testing::Test::RecordProperty(label, std::to_string(mean / dof));
  };
  for (std::size_t i = 0; i < check_ticks.size(); ++i) {
    check(observable[i], 11, name + "_observable_at_" + std::to_string(check_ticks[i]));
    check(whole[i], 15, name + "_all_at_" + std::to_string(check_ticks[i]));
  }
  const double mean = squares / static_cast<double>(rows);
  EXPECT_NEAR(mean, 1.0, 4.0 * std::sqrt(2.0 / static_cast<double>(rows))) << rows;
  ::testing::Test::RecordProperty(name + "_innovations", std::to_string(mean));
}

TEST(BaseEstimator, StandingOnTwoSoles_IsConsistent) {
  const LeggedRobot robot = humanoid_on_soles();
  expect_consistent(robot, standing_motion(robot, 4.0, 0.005), "soles");
}

#if BURNISH_HAS_ROBOTS
TEST(BaseEstimator, Trot_IsConsistent) {
  const LeggedRobot robot = quadruped();
  expect_consistent(robot, trotting_motion(robot, 4.0, 0.005), "trot");
}
#endif

TEST(BaseEstimator, NoNoise_GivesTheExactState) {
  LeggedRobot robot = humanoid_on_soles();
  robot.options = with_true_noise(robot.options);
  BaseEstimatorOptions& o = robot.options;
  const RobotMotion motion = standing_motion(robot, 1.0, 0.001);
  BaseEstimator estimator(robot.model, o);
  ASSERT_EQ(estimator.reset(motion.q[0], motion.v[0]), Status::Ok);
  for (std::size_t i = 1; i < motion.q.size(); ++i)
    ASSERT_EQ(
        estimator.update(motion.imu[i], motion.q[i], motion.v[i], motion.standing[i], motion.dt),
        Status::Ok);
  EXPECT_LT((estimator.q() - motion.q.back()).norm(), 1e-6);
  EXPECT_LT((estimator.v() - motion.v.back()).head<3>().norm(), 1e-5);
  // The estimated angular velocity is the gyroscope's mean over the last tick.
  EXPECT_LT((estimator.v() - motion.v.back()).norm(), 1e-3);
}

TEST(BaseEstimator, ImuOnTheTrunk_EstimatesTheBase) {
  LeggedRobot robot = humanoid_on_soles();
  const std::string unit = has_robot_files ? "torso_2_link" : "arm_1_link";
  robot.options.imu_frame = unit;
  const Model& model = robot.model;
  RobotMotion motion = standing_motion(robot, 0.5, 0.001);
  // Joints between IMU and base move, too.
  RigidBody body(model);
  const auto twisted = [&](double t, VectorXd q) {
    VectorXd step = VectorXd::Zero(model.nv);
    for (int k = 6; k < model.nv; ++k)
      if (model.v_name(k).starts_with("torso") || model.v_name(k).starts_with("arm"))
        step[k] = 0.1 * (1.0 - std::cos(6.0 * t));
    return integrate(model, q, step);
  };
  for (std::size_t i = 0; i < motion.q.size(); ++i) {
    const double t = static_cast<double>(i) * motion.dt;
    motion.q[i] = twisted(t, motion.q[i]);
    for (int k = 6; k < model.nv; ++k)
      if (model.v_name(k).starts_with("torso") || model.v_name(k).starts_with("arm"))
        motion.v[i][k] = 0.6 * std::sin(6.0 * t);
  }
  const auto state_of_unit = [&](std::size_t i) {
    EXPECT_EQ(body.update(motion.q[i], motion.v[i]), Status::Ok);
    const int frame = body.frame(unit);
    return std::pair<Matrix3d, Vector3d>{body.placement(frame).linear(),
                                         body.velocity(frame, Reference::centered()).head<3>()};
  };
  BaseEstimator estimator(model, robot.options);
  ASSERT_EQ(estimator.reset(motion.q[0], motion.v[0]), Status::Ok);
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    const auto [R_0, v_0] = state_of_unit(i - 1);
    const auto [R_1, v_1] = state_of_unit(i);
    ImuReading reading;
    reading.gyro = log3(R_0.transpose() * R_1) / motion.dt;
    const Vec3<double> phi = from_eigen(Vector3d(reading.gyro * motion.dt));
    reading.accelerometer = to_eigen(gamma_1(phi, rotation_series(phi))).inverse() *
                            (R_0.transpose() * ((v_1 - v_0) / motion.dt - gravity));
    ASSERT_EQ(estimator.update(reading, motion.q[i], motion.v[i], motion.standing[i], motion.dt),
              Status::Ok);
  }
  EXPECT_LT((estimator.q() - motion.q.back()).norm(), 1e-5);
  EXPECT_LT((estimator.v() - motion.v.back()).head<3>().norm(), 1e-3);
  EXPECT_LT((estimator.v() - motion.v.back()).norm(), 1e-2);
}

TEST(BaseEstimator, StandingMotion_FindsBiasesAndTiltWithLittleDrift) {
  LeggedRobot robot = humanoid_on_soles();
  robot.options.encoder_noise = 3e-4;
  const RobotMotion motion = standing_motion(robot, 6.0, 0.005);
  double yaw = 0.0, place = 0.0, tilt = 0.0, gyro = 0.0;
  constexpr int runs = 10;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Estimation run(robot, motion, seed);
    for (std::size_t i = 1; i < motion.q.size(); ++i) ASSERT_EQ(run.tick(i), Status::Ok);
    const VectorXd e = run.error(motion.q.size() - 1);
    yaw += e[2] * e[2] / runs;
    place += e.segment<3>(6).squaredNorm() / runs;
    tilt += e.head<2>().squaredNorm() / runs;
    gyro += e.segment<3>(9).squaredNorm() / runs;
  }
  EXPECT_LT(std::sqrt(tilt), 0.25 * robot.options.tilt_deviation * std::sqrt(2.0) * 2.0);
  EXPECT_LT(std::sqrt(gyro), 0.2 * robot.options.gyro_bias_deviation * std::sqrt(3.0));
  EXPECT_LT(std::sqrt(place), 0.03);
  EXPECT_LT(std::sqrt(yaw), 0.02);
}

/// Drift of position and yaw from a time to the end of the motion: standard deviations over runs
/// [m, rad], true and as claimed by the estimator, and time per update [us].
struct Drift {
  double place = 0.0, height = 0.0, yaw = 0.0, tilt = 0.0, velocity = 0.0;
  double claimed_place = 0.0, claimed_yaw = 0.0, time = 0.0;
};
Drift drift_of(const LeggedRobot& robot, const RobotMotion& motion, double from) {
  constexpr int runs = 10;
  const auto first = static_cast<std::size_t>(std::lround(from / motion.dt));
  const std::size_t last = motion.q.size() - 1;
  Drift d;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Estimation run(robot, motion, seed, true);
    VectorXd before = VectorXd::Zero(15);
    for (std::size_t i = 1; i <= last; ++i) {
      EXPECT_EQ(run.tick(i), Status::Ok);
      if (i == first) before = run.error(i);
    }
    const VectorXd e = run.error(last), moved = e - before;
    d.place += moved.segment<2>(6).squaredNorm() / runs;
    d.height += moved[8] * moved[8] / runs;
    d.yaw += moved[2] * moved[2] / runs;
    d.tilt += e.head<2>().squaredNorm() / runs;
    d.velocity += e.segment<3>(3).squaredNorm() / runs;
    d.claimed_place += run.estimator.covariance().block<2, 2>(6, 6).trace() / runs;
    d.claimed_yaw += run.estimator.covariance()(2, 2) / runs;
  }
  for (double* square :
       {&d.place, &d.height, &d.yaw, &d.tilt, &d.velocity, &d.claimed_place, &d.claimed_yaw})
    *square = std::sqrt(*square);
  BaseEstimator timed(robot.model, robot.options);
  EXPECT_EQ(timed.reset(motion.q[0], motion.v[0]), Status::Ok);
  // Takes the quickest 20 updates, because other work on the machine only adds time.
  d.time = infinity;
  auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 1; i <= last; ++i) {
    EXPECT_EQ(timed.update(motion.imu[i], motion.q[i], motion.v[i], motion.standing[i], motion.dt),
              Status::Ok);
    if (i % 20 != 0) continue;
    const auto now = std::chrono::steady_clock::now();
    d.time = std::min(d.time, 1e6 * std::chrono::duration<double>(now - start).count() / 20.0);
    start = now;
  }
  return d;
}
void print(const char* label, const Drift& d, double per, const char* of) {
  std::printf(
      "%-9s per %s: place %.2f mm, height %.2f mm, yaw %.3f deg; claimed over the whole: place "
      "%.2f "
      "mm, yaw %.3f deg; tilt %.3f deg, velocity %.2f mm/s; %.1f us per update\n",
      label, of, 1e3 * d.place / per, 1e3 * d.height / per, 180.0 / M_PI * d.yaw / per,
      1e3 * d.claimed_place, 180.0 / M_PI * d.claimed_yaw, 180.0 / M_PI * d.tilt, 1e3 * d.velocity,
      d.time);
}

/// Prints the drift figures of docs/state_estimation.md. Runs only if BURNISH_TEST_LONG is set.
TEST(BaseEstimator, Drift_StaysWithinThreeTimesTheClaimedDeviation) {
  if (std::getenv("BURNISH_TEST_LONG") == nullptr) GTEST_SKIP() << "set BURNISH_TEST_LONG";
  const LeggedRobot robot = humanoid_on_soles();
  const Drift stands = drift_of(robot, standing_motion(robot, 20.0, 0.002), 5.0);
  print("stands", stands, 15.0 / 60.0, "minute");
  EXPECT_LT(stands.place, 3.0 * stands.claimed_place);
  EXPECT_LT(stands.yaw, 3.0 * stands.claimed_yaw);
#if BURNISH_HAS_ROBOTS
  const LeggedRobot walker = quadruped();
  const RobotMotion trot = trotting_motion(walker, 12.0, 0.002);
  const Drift walks = drift_of(walker, trot, 2.0);
  const double distance = trot.q.back()[0] - trot.q[1000][0];
  print("trots", walks, distance, "metre");
  EXPECT_LT(walks.place, 3.0 * walks.claimed_place);
#endif
}

/// Motion in which foot 0 slides over the ground for a while.
struct SlidingFoot {
  LeggedRobot robot;
  RobotMotion motion;
};
SlidingFoot sliding(double speed, double from, double to, double duration) {
  SlidingFoot result{humanoid_on_soles(), {}};
  std::vector<FootOverTime> feet;
  for (const FootSpec& foot : result.robot.options.feet) {
    const Pose at = frame_pose(result.robot, foot.frame);
    const bool slides = feet.empty();
    feet.push_back({foot.frame, true,
                    [=](double t) {
                      Pose pose = at;
                      if (slides) pose.p.x() += speed * (std::clamp(t, from, to) - from);
                      return pose;
                    },
                    [](double) { return true; }});
  }
  result.motion = robot_motion(result.robot.model, result.robot.q,
                               swaying(base_of(result.robot.q), 0.5), feet, duration, 0.002);
  return result;
}

TEST(BaseEstimator, SlippingFoot_IsLeftOutUntilItStops) {
  const SlidingFoot s = sliding(0.15, 1.0, 1.4, 2.0);
  const auto last = s.motion.q.size() - 1;
  double with_gate = 0.0, without = 0.0;
  for (const bool gated : {true, false}) {
    LeggedRobot robot = s.robot;
    if (!gated) robot.options.gate = 1.0 - 1e-15;
    if (!gated) robot.options.encoder_noise = 0.05;  // so large that no innovation exceeds the gate
    Estimation run(robot, s.motion, 5, true);
    run.encoder_noise = s.robot.options.encoder_noise;
    bool slipped = false;
    for (std::size_t i = 1; i <= last; ++i) {
      ASSERT_EQ(run.tick(i), Status::Ok);
      const double t = static_cast<double>(i) * s.motion.dt;
      const BaseEstimator::Feet out = run.estimator.feet_that_slip();
      EXPECT_EQ(out & 2U, 0U) << "the foot at rest is left out at " << t;
      if (t < 1.0) {
        EXPECT_EQ(out, 0U) << t;
      }
      slipped = slipped || (out & 1U) != 0;
      if (gated && t > 1.03 && t < 1.4) {
        EXPECT_EQ(out, 1U) << t;
      }
      if (t > 1.55) {
        EXPECT_EQ(out, 0U) << t;
      }
    }
    (gated ? with_gate : without) = run.error(last).segment<3>(6).norm();
    EXPECT_EQ(slipped, gated);
    if (gated) {
      EXPECT_EQ(run.estimator.feet_that_count(), 3U);
    }
  }
  EXPECT_LT(with_gate, 0.01);
  EXPECT_GT(without, 0.02);  // half of the distance that the foot slid
}

/// Feet on soft ground: they tilt by 2 mrad as the load comes and yaw by 0.3 mrad/s, each about its
/// center. A simulated robot moved like this.
RobotMotion pivoting_motion(const LeggedRobot& robot, double duration, double dt) {
  std::vector<FootOverTime> feet;
  for (const FootSpec& foot : robot.options.feet) {
    const Pose at = frame_pose(robot, foot.frame);
    feet.push_back({foot.frame, true,
                    [at](double t) {
                      const double tilt = 2e-3 * -std::expm1(-t * t / 0.1);
                      return Pose{exp3({tilt, 0.3 * tilt, -0.3e-3 * t}) * at.R, at.p};
                    },
                    [](double) { return true; }});
  }
  return robot_motion(robot.model, robot.q, swaying(base_of(robot.q), 0.1), feet, duration, dt);
}

TEST(BaseEstimator, PivotingFeet_LeaveTheEstimatedYaw) {
  LeggedRobot robot = humanoid_on_soles();
  BaseEstimatorOptions& o = robot.options;
  o.place_noise = 5e-4;
  o.turn_noise = 2e-3;
  o.slip_noise = 1e-5;
  const RobotMotion motion = pivoting_motion(robot, 6.0, 0.004);
  const auto error = [&](double sole_turn_noise) -> VectorXd {
    o.sole_turn_noise = sole_turn_noise;
    BaseEstimator estimator(robot.model, o);
    EXPECT_EQ(estimator.reset(motion.q[0], motion.v[0]), Status::Ok);
    for (std::size_t i = 1; i < motion.q.size(); ++i) {
      EXPECT_EQ(estimator.update(motion.imu[i], motion.q[i], motion.v[i], 3U, motion.dt),
                Status::Ok);
      EXPECT_EQ(estimator.feet_that_count(), 3U) << i;
    }
    const Pose truth = base_of(motion.q.back()), estimate = base_of(estimator.q());
    VectorXd e(6);
    e << log3(truth.R * estimate.R.transpose()), truth.p - estimate.p;
    return e;
  };
  // If feet may rotate, their positions determine yaw; if not, the estimated yaw follows the feet.
  const VectorXd rotating = error(3e-3), fixed = error(1e-5);
  EXPECT_LT(std::abs(rotating[2]), 1e-4);
  EXPECT_LT(rotating.head<2>().norm(), 2e-4);
  EXPECT_LT(rotating.tail<3>().norm(), 3e-4);
  EXPECT_GT(std::abs(fixed[2]), 5e-4);
}

TEST(BaseEstimator, AllFeetRejected_AreAcceptedAgain) {
  // The IMU reads an acceleration that did not happen, which shifts the estimated base.
  LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 1.0, 0.002, 0.2);
  Estimation run(robot, motion, 3, true);
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    ImuReading exact = motion.imu[i];
    if (i >= 100 && i < 110) exact.accelerometer.x() += 60.0;
    ASSERT_EQ(run.tick(i, motion.standing[i], exact), Status::Ok);
    if (i == 115) {
      EXPECT_NE(run.estimator.feet_that_slip(), 0U);
    }
  }
  EXPECT_EQ(run.estimator.feet_that_slip(), 0U);
  EXPECT_EQ(run.estimator.feet_that_count(), 3U);
}

TEST(BaseEstimator, FeetInTheAir_AreNotUsed) {
  LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 0.4, 0.002, 0.2);
  Estimation run(robot, motion, 4, true);
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    const BaseEstimator::Feet standing = i < 50 ? 3U : i < 100 ? 2U : i < 150 ? 0U : 3U;
    const MatrixXd before = run.estimator.covariance();
    ASSERT_EQ(run.tick(i, standing, motion.imu[i]), Status::Ok);
    EXPECT_EQ(run.estimator.feet_that_count(), standing);
    if (standing == 0U) {
      EXPECT_GT(run.estimator.covariance()(3, 3), before(3, 3));  // in flight the covariance grows
      EXPECT_EQ(run.estimator.innovation().rows, 0);
    }
  }
}

TEST(BaseEstimator, InvalidInput_ReturnsAStatusAndChangesNothing) {
  const LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 0.02, 0.002);
  Estimation run(robot, motion, 1);
  BaseEstimator& e = run.estimator;
  for (std::size_t i = 1; i < motion.q.size(); ++i) ASSERT_EQ(run.tick(i), Status::Ok);
  const VectorXd q = e.q(), v = e.v(), still = VectorXd::Zero(robot.model.nv);
  const MatrixXd P = e.covariance();
  const ImuReading good = motion.imu.back();
  ImuReading bad = good;
  bad.gyro.y() = nan;
  EXPECT_EQ(e.update(bad, q, v, 3, 0.002), Status::NotFinite);
  bad = good;
  bad.accelerometer.x() = infinity;
  EXPECT_EQ(e.update(bad, q, v, 3, 0.002), Status::NotFinite);
  bad.accelerometer.x() = 1e300;
  EXPECT_EQ(e.update(bad, q, v, 3, 0.002), Status::NotFinite);
  for (const double dt : {0.0, -0.001, nan, infinity})
    EXPECT_EQ(e.update(good, q, v, 3, dt), Status::NotFinite);
  EXPECT_EQ(e.update(good, q.head(q.size() - 1), v, 3, 0.002), Status::WrongSize);
  EXPECT_EQ(e.update(good, q, v.head(v.size() - 1), 3, 0.002), Status::WrongSize);
  VectorXd wrong = q;
  wrong[9] = nan;
  EXPECT_EQ(e.update(good, wrong, v, 3, 0.002), Status::NotFinite);
  wrong = v;
  wrong[9] = infinity;
  EXPECT_EQ(e.update(good, q, wrong, 3, 0.002), Status::NotFinite);
  EXPECT_EQ(e.reset(q.head(3), v), Status::WrongSize);
  wrong = q;
  wrong[3] = nan;
  EXPECT_EQ(e.reset(wrong, v), Status::NotFinite);
  wrong[3] = 2.0;
  EXPECT_EQ(e.reset(wrong, v), Status::NotNormalized);
  EXPECT_EQ(e.reset(q, v, MatrixXd::Identity(14, 14)), Status::WrongSize);
  EXPECT_EQ(e.reset(q, v, -MatrixXd::Identity(15, 15)), Status::NotPhysical);
  EXPECT_TRUE(e.q() == q && e.v() == v);
  EXPECT_TRUE(e.covariance() == P);
  EXPECT_EQ(e.update(good, q, v, 3, 0.002), Status::Ok);
  // Bits beyond the feet are ignored.
  EXPECT_EQ(e.update(good, q, v, ~0U, 0.002), Status::Ok);
  EXPECT_EQ(e.feet_that_count() & ~3U, 0U);
}

TEST(BaseEstimator, Update_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 0.1, 0.002);
  BaseEstimator estimator(robot.model, robot.options);
  ASSERT_EQ(estimator.reset(motion.q[0], motion.v[0]), Status::Ok);
  const AllocationGuard guard;
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    const BaseEstimator::Feet standing = i < 20 ? 3U : i < 30 ? 1U : 3U;
    ASSERT_EQ(estimator.update(motion.imu[i], motion.q[i], motion.v[i], standing, motion.dt),
              Status::Ok);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST(BaseEstimator, Reset_SetsStateAndCovariance) {
  const LeggedRobot robot = humanoid_on_soles();
  BaseEstimator estimator(robot.model, robot.options);
  std::mt19937_64 generator(8);
  const VectorXd q = random_configuration(robot.model, generator);
  const VectorXd v = random_vector(robot.model.nv, 1.0, generator);
  ASSERT_EQ(estimator.reset(q, v), Status::Ok);
  EXPECT_TRUE(estimator.q() == q && estimator.v() == v);
  VectorXd sigma(15);
  const BaseEstimatorOptions& o = robot.options;
  sigma << o.tilt_deviation, o.tilt_deviation, o.yaw_deviation,
      VectorXd::Constant(3, o.velocity_deviation), VectorXd::Constant(3, o.position_deviation),
      VectorXd::Constant(3, o.gyro_bias_deviation),
      VectorXd::Constant(3, o.accelerometer_bias_deviation);
  EXPECT_LT((estimator.covariance().diagonal().cwiseSqrt() - sigma).norm(), 1e-9);
  EXPECT_EQ(estimator.feet_that_count(), 0U);
}

TEST(BaseEstimator, InvalidOptions_AreRefused) {
  const LeggedRobot robot = humanoid_on_soles();
  const auto refused = [&](const std::function<void(BaseEstimatorOptions&)>& change) {
    BaseEstimatorOptions options = robot.options;
    change(options);
    return refusal([&] { BaseEstimator(robot.model, options); });
  };
  expect_words(refused([](auto& o) { o.feet.clear(); }), {"0 feet", "1 to 32"});
  expect_words(refused([](auto& o) { o.feet[1] = o.feet[0]; }), {"left_sole_link", "twice"});
  expect_words(refused([](auto& o) { o.feet[0].frame = "left_sole_lnk"; }), {"left_sole_link"});
  expect_words(refused([](auto& o) { o.gyro_noise = -1.0; }), {"gyro_noise", "-1"});
  expect_words(refused([](auto& o) { o.gate = 1.0; }), {"gate", "1"});
  expect_words(refused([](auto& o) { o.place_noise = 0.0; }), {"place_noise", "0"});
  expect_words(refused([](auto& o) { o.imu_frame = "imu"; }), {"imu"});
}

}  // namespace
}  // namespace burnish::test

// Tests of the readings of a simulated IMU.
#include "burnish/sim/imu_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/model/state.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/sim/sensing.hpp"
#include "estimate/strapdown.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using burnish::testing::expect_words;
using burnish::testing::refusal;
using Eigen::Vector3d;
using Eigen::VectorXd;

TEST(ImuSensor, IntegratedReadings_GiveTheTrueRotationAndVelocity) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  std::mt19937_64 generator(1);
  const std::string frame = "tip";
  RigidBody body(model);
  ImuSensor sensor(model, frame, {});
  const VectorXd q_0 = random_configuration(model, generator);
  const VectorXd v_0 = random_vector(model.nv, 1.0, generator);
  ASSERT_EQ(body.update(q_0, v_0), Status::Ok);
  const auto state = [&] {
    const Eigen::Isometry3d at = body.placement(body.frame(frame));
    return InertialState<double>{
        from_eigen(Eigen::Matrix3d(at.linear())),
        from_eigen(Vector3d(body.velocity(body.frame(frame), Reference::centered()).head<3>())),
        from_eigen(Vector3d(at.translation()))};
  };
  InertialState<double> integrated = state();
  constexpr double dt = 0.01;
  const ImuReading first = sensor.measure(q_0, v_0, dt);
  const Eigen::Matrix3d R = to_eigen(integrated.R);
  EXPECT_LT((first.gyro -
             R.transpose() * body.velocity(body.frame(frame), Reference::centered()).tail<3>())
                .norm(),
            1e-12);
  EXPECT_LT((first.accelerometer + R.transpose() * model.gravity).norm(), 1e-12);
  VectorXd q = q_0, v = v_0;
  for (int tick = 0; tick < 20; ++tick) {
    v += dt * random_vector(model.nv, 10.0, generator);
    q = integrate(model, q, dt * v);
    const ImuReading& reading = sensor.measure(q, v, dt);
    integrated = strapdown(integrated, from_eigen(reading.gyro), from_eigen(reading.accelerometer),
                           from_eigen(model.gravity), dt);
    ASSERT_EQ(body.update(q, v), Status::Ok);
    const InertialState<double> now = state();
    EXPECT_LT((to_eigen(now.R) - to_eigen(integrated.R)).norm(), 1e-10);
    EXPECT_LT((to_eigen(now.v) - to_eigen(integrated.v)).norm(), 1e-9);
  }
}

TEST(ImuSensor, Disturbances_SetBiasNoiseAndResolution) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  const VectorXd q = model.q_neutral, rest = VectorXd::Zero(model.nv);
  Disturbances d;
  d.seed = 4;
  d.gyro_bias_range = 0.02;
  d.accelerometer_bias_range = 0.3;
  ImuSensor biased(model, "", d);
  (void)biased.measure(q, rest, 0.01);
  EXPECT_TRUE(biased.reading().gyro == biased.gyro_bias());
  EXPECT_GT(biased.gyro_bias().norm(), 0.0);
  EXPECT_LE(biased.gyro_bias().cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LE(biased.accelerometer_bias().cwiseAbs().maxCoeff(), 0.3);

  // Noise: readings deviate by density / sqrt(dt), a random walk by density sqrt(t).
  Disturbances n;
  n.gyro_noise = 0.01;
  n.accelerometer_noise = 0.2;
  n.accelerometer_bias_walk = 0.5;
  constexpr double dt = 0.0025;
  constexpr int ticks = 4000;
  ImuSensor noisy(model, "", n);
  double gyro = 0.0;
  for (int tick = 0; tick < ticks; ++tick)
    gyro += noisy.measure(q, rest, dt).gyro.squaredNorm() / (3.0 * ticks);
  EXPECT_NEAR(std::sqrt(gyro), 0.01 / std::sqrt(dt), 0.05 * 0.01 / std::sqrt(dt));
  EXPECT_TRUE(noisy.gyro_bias().isZero(0.0));
  double walk = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    n.seed = seed;
    ImuSensor walker(model, "", n);
    for (int tick = 0; tick < 40; ++tick) (void)walker.measure(q, rest, dt);
    walk += walker.accelerometer_bias().squaredNorm() / 600.0;
  }
  EXPECT_NEAR(std::sqrt(walk), 0.5 * std::sqrt(40 * dt), 0.1 * 0.5 * std::sqrt(40 * dt));

  Disturbances stepped;
  stepped.gyro_step = 0.01;
  stepped.accelerometer_step = 0.5;
  ImuSensor coarse(model, "", stepped);
  const ImuReading& reading =
      coarse.measure(q, random_vector(model.nv, 1.0, *std::make_unique<std::mt19937_64>(2)), dt);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(std::remainder(reading.gyro[k], 0.01), 0.0, 1e-12);
    EXPECT_NEAR(std::remainder(reading.accelerometer[k], 0.5), 0.0, 1e-12);
  }
}

TEST(ImuSensor, Reset_RepeatsTheRandomNumbers) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  const VectorXd q = model.q_neutral, rest = VectorXd::Zero(model.nv);
  Disturbances d;
  d.seed = 9;
  d.gyro_noise = d.accelerometer_noise = d.gyro_bias_walk = 0.1;
  ImuSensor sensor(model, "", d);
  const ImuReading first = sensor.measure(q, rest, 0.01);
  const ImuReading second = sensor.measure(q, rest, 0.01);
  EXPECT_NE(first.gyro, second.gyro);
  sensor.reset();
  EXPECT_EQ(sensor.measure(q, rest, 0.01).gyro, first.gyro);
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const AllocationGuard guard;
  EXPECT_EQ(sensor.measure(q, rest, 0.01).accelerometer, second.accelerometer);
  EXPECT_EQ(guard.count(), 0);
}

TEST(ImuSensor, Faults_ChangeReadingsOnlyWhileTheyLast) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  const VectorXd q = model.q_neutral, rest = VectorXd::Zero(model.nv);
  constexpr double dt = 0.01;
  Disturbances d;
  d.seed = 3;
  d.gyro_noise = d.accelerometer_noise = d.gyro_bias_walk = 0.1;
  ImuSensor reference(model, "", d);
  const Vector3d turn(0.0, 0.3, 0.0), pull(0.0, 0.0, -2.0);
  d.imu_faults = {{.start = 0.1, .duration = 0.1, .gyro_offset = turn},
                  {.start = 0.15, .duration = 0.1, .accelerometer_offset = pull},
                  {.start = 0.3, .duration = 0.1, .frozen = true},
                  {.start = 0.5, .duration = 0.1, .silent = true},
                  {.start = 0.8, .silent = true}};
  ImuSensor faulty(model, "", d);
  Vector3d last = Vector3d::Zero();
  for (int tick = 0; tick < 100; ++tick) {
    const double time = tick * dt;
    const ImuReading& truth = reference.measure(q, rest, dt, time);
    const ImuReading& read = faulty.measure(q, rest, dt, time);
    if (tick < 30 || tick >= 40) {
      const bool steps = tick >= 10 && tick < 20, pulls = tick >= 15 && tick < 25;
      EXPECT_EQ(read.gyro, steps ? Vector3d(truth.gyro + turn) : truth.gyro) << tick;
      EXPECT_EQ(read.accelerometer,
                pulls ? Vector3d(truth.accelerometer + pull) : truth.accelerometer)
          << tick;
      last = read.gyro;
    } else {
      EXPECT_EQ(read.gyro, last) << tick;
    }
    EXPECT_EQ(faulty.is_silent(), (tick >= 50 && tick < 60) || tick >= 80) << tick;
  }
  faulty.reset();
  EXPECT_FALSE(faulty.is_silent());
  d.imu_faults = {
      {.start = 0.0, .frozen = true}};  // without an earlier reading, the first one freezes
  ImuSensor stuck(model, "", d);
  const ImuReading first = stuck.measure(q, rest, dt);
  EXPECT_EQ(stuck.measure(q, rest, dt, dt).gyro, first.gyro);
}

TEST(ImuSensor, InvalidFrameOrNoise_IsRefused) {
  const Model model = named_robot("every_joint", Base::FreeFlyer);
  expect_words(refusal([&] { ImuSensor(model, "tap", {}); }), {"'tap'", "'tip'"});
  expect_words(refusal([&] { ImuSensor(model, "world", {}); }), {"fixed to the world"});
  Disturbances d;
  d.gyro_noise = -1.0;
  expect_words(refusal([&] { ImuSensor(model, "", d); }), {"gyro_noise", "-1"});
  d = {};
  d.imu_faults = {{}, {.duration = -0.1}};
  expect_words(refusal([&] { ImuSensor(model, "", d); }), {"imu_faults[1].duration", "-0.1"});
  d.imu_faults = {{.gyro_offset = {0.0, std::nan(""), 0.0}}};
  expect_words(refusal([&] { ImuSensor(model, "", d); }), {"imu_faults[0].gyro_offset", "nan"});
}

TEST(Sensing, MountedImu_AddsItsReadings) {
  const Model model = arm7::model(Base::Fixed);
  const auto plant = make_ideal_plant(model, {});
  Disturbances d;
  d.imu_faults = {{.start = 1.5 * plant->dt(), .silent = true}};
  Sensing with_imu(model, d, plant->scene(), {}), without_imu(model, {}, plant->scene(), {});
  with_imu.mount_imu(model, "tool");
  const VectorXd q = model.q_neutral, rest = VectorXd::Zero(model.nv);
  ASSERT_LE(plant->reset(q, rest), Status::NotConverged);
  EXPECT_FALSE(without_imu.measure(*plant, rest).imu.has_value());
  const Measurement first = with_imu.measure(*plant, rest);
  ASSERT_TRUE(first.imu.has_value());
  EXPECT_NEAR(first.imu->accelerometer.norm(), 9.81, 1e-12);
  // The arm falls freely; the accelerometer measures acceleration minus gravity at the tool.
  ASSERT_LE(plant->step(rest), Status::NotConverged);
  const Measurement second = with_imu.measure(*plant, rest);
  RigidBody body(model);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector3d speed = body.velocity(body.frame("tool"), Reference::centered()).head<3>();
  EXPECT_NEAR(second.imu->accelerometer.norm(), (speed / plant->dt() - model.gravity).norm(), 1e-9);
  ASSERT_LE(plant->step(rest), Status::NotConverged);
  EXPECT_FALSE(with_imu.measure(*plant, rest).imu.has_value())
      << "the IMU is silent from its fault on";
}

}  // namespace
}  // namespace burnish::test

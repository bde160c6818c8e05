// Tests of a base whose IMU fails or falls silent: the feet alone then estimate the base.
#include "burnish/estimate/guarded_base.hpp"

#include <gtest/gtest.h>

#include "estimate/on_feet.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/special_numbers.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

constexpr double one_degree = M_PI / 180.0;

/// Changes a reading at a time; returns false if there is no reading.
using Spoil = std::function<bool(ImuReading&, double)>;

/// Guarded base that is fed with noisy sensor readings of a motion.
class GuardedRun {
 public:
  GuardedRun(const LeggedRobot& robot, const RobotMotion& motion, std::uint64_t seed)
      : guarded(robot.model, robot.options), robot_(&robot), motion_(&motion), generator_(seed) {
    const BaseEstimatorOptions& o = robot.options;
    imu_ = {{o.gyro_noise, o.accelerometer_noise, o.gyro_bias_walk, o.accelerometer_bias_walk, 0.0,
             0.0},
            motion.dt,
            &generator_,
            normal3(generator_, o.gyro_bias_deviation),
            normal3(generator_, o.accelerometer_bias_deviation)};
    if (guarded.reset(motion.q[0], motion.v[0]) != Status::Ok) throw Error("no start");
  }

  Status tick(std::size_t i, FootSet standing, const VectorXd& loads = {}) {
    VectorXd noise = VectorXd::Zero(robot_->model.nv);
    std::normal_distribution<double> draw(0.0, robot_->options.encoder_noise);
    for (Eigen::Index k = 6; k < noise.size(); ++k) noise[k] = draw(generator_);
    const VectorXd q = integrate(robot_->model, motion_->q[i], noise);
    ImuReading reading = imu_.read(motion_->imu[i]);
    const double time = static_cast<double>(i) * motion_->dt;
    const bool reads = !spoil || spoil(reading, time);
    const double since = motion_->dt * (1.0 + waited_);
    const Status status =
        guarded.update(reads ? &reading : nullptr, q, motion_->v[i], standing, loads, since);
    waited_ = status == Status::Ok ? 0 : waited_ + 1;
    return status;
  }
  Status tick(std::size_t i) { return tick(i, motion_->standing[i]); }

  double turn_error(std::size_t i) const {
    return log3(base_of(motion_->q[i]).R * base_of(guarded.q()).R.transpose()).norm();
  }
  double place_error(std::size_t i) const {
    return (base_of(motion_->q[i]).p - base_of(guarded.q()).p).norm();
  }

  GuardedBase guarded;
  Spoil spoil;

 private:
  const LeggedRobot* robot_;
  const RobotMotion* motion_;
  std::mt19937_64 generator_;
  NoisyImu imu_{};
  int waited_ = 0;
};

/// Effects of a fault that starts at fault_time.
struct Outcome {
  double turn = 0.0, place = 0.0;  ///< largest errors [rad], [m]
  double found_after = infinity;   ///< time from the fault to its detection [s]
  double jump = 0.0;               ///< largest jump of the estimate in a tick [m]
  int takeovers = 0;
};
constexpr double fault_time = 1.0;

Outcome outcome(const LeggedRobot& robot, const RobotMotion& motion, const Spoil& spoil,
                std::uint64_t seed) {
  GuardedRun run(robot, motion, seed);
  run.spoil = [&](ImuReading& reading, double time) {
    return time < fault_time || spoil(reading, time);
  };
  Outcome result;
  VectorXd before = motion.q[0];
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    const Status status = run.tick(i);
    const double time = static_cast<double>(i) * motion.dt;
    EXPECT_TRUE(status == Status::Ok || time >= fault_time) << time;
    EXPECT_TRUE(run.guarded.q().allFinite() && run.guarded.v().allFinite());
    result.turn = std::max(result.turn, run.turn_error(i));
    result.place = std::max(result.place, run.place_error(i));
    if (run.guarded.source() != BaseSource::Filter)
      result.found_after = std::min(result.found_after, time - fault_time);
    const Vector3d moved = run.guarded.q().head<3>() - before.head<3>();
    const Vector3d true_motion = motion.q[i].head<3>() - motion.q[i - 1].head<3>();
    if (time > fault_time) result.jump = std::max(result.jump, (moved - true_motion).norm());
    before = run.guarded.q();
  }
  result.takeovers = run.guarded.takeovers();
  return result;
}

/// Sets small initial deviations, because runs start at the true state. Otherwise the filter
/// mistakes a bias for initial tilt.
LeggedRobot with_exact_start(LeggedRobot robot) {
  robot.options.tilt_deviation = 2e-3;
  robot.options.velocity_deviation = 0.01;
  return robot;
}
std::vector<std::pair<std::string, LeggedRobot>> standing_robots() {
  std::vector<std::pair<std::string, LeggedRobot>> result = {
      {"two soles", with_exact_start(humanoid_on_soles())}};
#if BURNISH_HAS_ROBOTS
  result.emplace_back("four point feet", with_exact_start(quadruped()));
#endif
  return result;
}

/// Expects small errors and a takeover within `latest` [s], over several seeds and axes.
void expect_tolerated(const std::string& fault, const std::function<Spoil(const Vector3d&)>& along,
                      double latest) {
  for (const auto& [name, robot] : standing_robots()) {
    const RobotMotion motion = standing_motion(robot, 2.5, 0.002);
    Outcome worst;
    worst.found_after = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Outcome o = outcome(robot, motion, along(Vector3d::Unit(axis)), seed);
        worst.turn = std::max(worst.turn, o.turn);
        worst.place = std::max(worst.place, o.place);
        worst.jump = std::max(worst.jump, o.jump);
        worst.found_after = std::max(worst.found_after, o.found_after);
        EXPECT_EQ(o.takeovers, latest < infinity ? 1 : o.takeovers) << fault << name << axis;
      }
    EXPECT_LT(worst.turn, 1.0 * one_degree) << fault << ", " << name;
    EXPECT_LT(worst.place, 0.01) << fault << ", " << name;
    EXPECT_LE(worst.found_after, latest) << fault << ", " << name;
    EXPECT_LT(worst.jump, 3e-3) << fault << ", " << name;
    const auto record = [&, &robot_name = name](const char* figure, double value) {
      std::string key = fault + " " + robot_name + " " + figure;
      std::replace(key.begin(), key.end(), ' ', '_');
      ::testing::Test::RecordProperty(key, std::to_string(value));
    };
    record("deg", worst.turn / one_degree);
    record("mm", 1e3 * worst.place);
    record("found ms", 1e3 * worst.found_after);
    record("jump mm", 1e3 * worst.jump);
  }
}

TEST(GuardedBase, GyroscopeStep_IsDetected) {
  const auto step = [](double size) {
    return [size](const Vector3d& axis) -> Spoil {
      return [=](ImuReading& reading, double) {
        reading.gyro += size * axis;
        return true;
      };
    };
  };
  expect_tolerated("gyro 0.1", step(0.1), 0.5);
  expect_tolerated("gyro 0.3", step(0.3), 0.05);
  expect_tolerated("gyro 1", step(1.0), 0.02);
  expect_tolerated("gyro 30", step(30.0), 0.003);
}

TEST(GuardedBase, AccelerometerStep_IsDetected) {
  const auto step = [](double size) {
    return [size](const Vector3d& axis) -> Spoil {
      return [=](ImuReading& reading, double) {
        reading.accelerometer += size * axis;
        return true;
      };
    };
  };
  expect_tolerated("accelerometer 1", step(1.0), 0.3);
  expect_tolerated("accelerometer 5", step(5.0), 0.1);
  expect_tolerated("accelerometer 50", step(50.0), 0.03);
}

TEST(GuardedBase, UndetectableStep_CausesLittleError) {
  expect_tolerated(
      "gyro 0.03",
      [](const Vector3d& axis) -> Spoil {
        return [=](ImuReading& reading, double) {
          reading.gyro += 0.03 * axis;
          return true;
        };
      },
      infinity);
}

TEST(GuardedBase, FrozenOrSilentImu_IsReplacedByTheFeet) {
  expect_tolerated(
      "frozen",
      [](const Vector3d&) -> Spoil {
        return [last = std::optional<ImuReading>()](ImuReading& reading, double) mutable {
          if (!last) last = reading;
          reading = *last;
          return true;
        };
      },
      infinity);
  expect_tolerated(
      "silent", [](const Vector3d&) -> Spoil { return [](ImuReading&, double) { return false; }; },
      0.0061);
  expect_tolerated(
      "not finite",
      [](const Vector3d& axis) -> Spoil {
        return [=](ImuReading& reading, double) {
          reading.gyro += nan * axis;
          return true;
        };
      },
      0.0061);
}

TEST(GuardedBase, RecoveredImu_IsUsedAgain) {
  for (const auto& [name, robot] : standing_robots()) {
    const RobotMotion motion = standing_motion(robot, 4.0, 0.002);
    for (const bool silent : {false, true}) {
      GuardedRun run(robot, motion, 5);
      run.spoil = [&](ImuReading& reading, double time) {
        if (time < 1.0 || time > 1.5) return true;
        reading.gyro.x() += 0.5;
        return !silent;
      };
      double back = 0.0;
      for (std::size_t i = 1; i < motion.q.size(); ++i) {
        const double time = static_cast<double>(i) * motion.dt;
        (void)run.tick(i);
        const bool by_feet = run.guarded.source() == BaseSource::Feet;
        if (time > 1.05 && time < 1.95) {
          EXPECT_TRUE(by_feet) << name << time;
        }
        if (by_feet) back = time;
        EXPECT_LT(run.turn_error(i), 1.0 * one_degree) << name << time;
        EXPECT_LT(run.place_error(i), 0.01) << name << time;
      }
      EXPECT_GT(back, 1.95) << name;
      EXPECT_LT(back, 2.6) << name;
      EXPECT_EQ(run.guarded.takeovers(), 1) << name;
      EXPECT_LT((run.guarded.v() - motion.v.back()).head<6>().norm(), 0.1) << name;
    }
  }
}

/// Foot 0 slides over the ground while the robot sways.
RobotMotion sliding_motion(const LeggedRobot& robot, double speed, double duration, double dt) {
  std::vector<FootOverTime> feet;
  for (const FootSpec& foot : robot.options.feet) {
    const Pose at = frame_pose(robot, foot.frame);
    const bool slides = feet.empty();
    feet.push_back({foot.frame, foot.kind == FootKind::Sole,
                    [=](double t) {
                      Pose pose = at;
                      if (slides) pose.p.x() += speed * (std::clamp(t, 1.0, 1.4) - 1.0);
                      return pose;
                    },
                    [](double) { return true; }});
  }
  return robot_motion(robot.model, robot.q, swaying(base_of(robot.q), 0.5), feet, duration, dt);
}

TEST(GuardedBase, NoiseAndSlippingFeet_AreNoImuFault) {
  for (const auto& [name, robot] : standing_robots()) {
    std::vector<RobotMotion> motions = {standing_motion(robot, 4.0, 0.002)};
    for (const double speed : {0.03, 0.15, 0.5})
      motions.push_back(sliding_motion(robot, speed, 2.0, 0.002));
#if BURNISH_HAS_ROBOTS
    if (name == "four point feet") motions.push_back(trotting_motion(robot, 3.0, 0.002));
#endif
    for (std::size_t m = 0; m < motions.size(); ++m)
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        GuardedRun run(robot, motions[m], seed);
        for (std::size_t i = 1; i < motions[m].q.size(); ++i) ASSERT_EQ(run.tick(i), Status::Ok);
        EXPECT_EQ(run.guarded.takeovers(), 0) << name << ", motion " << m << ", seed " << seed;
      }
  }
}

/// The rigid robot tips about the front edges of its feet.
TEST(GuardedBase, TippingRobot_IsNoImuFault) {
  for (const auto& [name, robot] : standing_robots()) {
    int taken = 0;
    const Vector3d edge =
        frame_pose(robot, robot.options.feet[0].frame).p + Vector3d(0.1, 0.0, 0.0);
    const Pose start = base_of(robot.q);
    for (const double rate : {0.2, 0.6}) {
      const auto tipped = [=](const Pose& pose, double t) {
        const double s = std::clamp(t - 1.0, 0.0, 0.3);  // starts smoothly
        const Matrix3d R = exp3({0.0, rate * s * s / 0.6, 0.0});
        return Pose{R * pose.R, edge + R * (pose.p - edge)};
      };
      std::vector<FootOverTime> feet;
      for (const FootSpec& foot : robot.options.feet) {
        const Pose at = frame_pose(robot, foot.frame);
        feet.push_back({foot.frame, foot.kind == FootKind::Sole,
                        [=](double t) { return tipped(at, t); }, [](double) { return true; }});
      }
      const RobotMotion motion = robot_motion(
          robot.model, robot.q, [=](double t) { return tipped(start, t); }, feet, 1.4, 0.002);
      for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        GuardedRun run(robot, motion, seed);
        for (std::size_t i = 1; i < motion.q.size(); ++i) (void)run.tick(i);
        taken += run.guarded.takeovers();
      }
    }
    // The travel of the feet shows that the robot tips. It is ambiguous for the quadruped, whose
    // IMU is low.
    EXPECT_LE(taken, name == "two soles" ? 0 : 1) << name;
  }
}

TEST(GuardedBase, SlippingOrLiftedFoot_IsToleratedWithoutImu) {
  const LeggedRobot robot = with_exact_start(humanoid_on_soles());
  const RobotMotion motion = sliding_motion(robot, 0.15, 2.5, 0.002);
  for (const bool lifts : {false, true}) {
    GuardedRun run(robot, motion, 7);
    run.spoil = [](ImuReading&, double time) { return time < 0.8; };
    Eigen::Vector2d loads(300.0, 600.0);  // the right foot, which does not slip, carries more
    for (std::size_t i = 1; i < motion.q.size(); ++i) {
      const double time = static_cast<double>(i) * motion.dt;
      const bool is_up = lifts && time > 0.95 && time < 1.45;
      (void)run.tick(i, is_up ? 2U : 3U, loads);
      EXPECT_LT(run.turn_error(i), 1.0 * one_degree) << time;
      EXPECT_LT(run.place_error(i), 0.01) << time;
    }
    EXPECT_EQ(run.guarded.source(), BaseSource::Feet);
    EXPECT_EQ(run.guarded.lost_for(), 0.0);
  }
}

TEST(GuardedBase, NoImuAndNoFeet_LoseTheBase) {
  for (const auto& [name, robot] : standing_robots()) {
    const RobotMotion motion = standing_motion(robot, 2.0, 0.002, 0.1);
    GuardedRun run(robot, motion, 8);
    run.spoil = [](ImuReading&, double time) { return time < 0.5 || time > 1.0; };
    double max_lost_for = 0.0;
    for (std::size_t i = 1; i < motion.q.size(); ++i) {
      const double time = static_cast<double>(i) * motion.dt;
      (void)run.tick(i, time > 0.7 && time < 1.2 ? 0U : motion.standing[i]);
      if (time > 0.51 && time < 0.7) {
        EXPECT_EQ(run.guarded.source(), BaseSource::Feet) << time;
      }
      if (time > 0.71 && time < 1.0) {
        EXPECT_EQ(run.guarded.source(), BaseSource::None) << time;
      }
      if (time > 1.01) {
        EXPECT_EQ(run.guarded.source(), BaseSource::Filter) << name << time;
        EXPECT_EQ(run.guarded.lost_for(), 0.0);
      }
      max_lost_for = std::max(max_lost_for, run.guarded.lost_for());
      EXPECT_TRUE(run.guarded.q().allFinite() && run.guarded.v().allFinite());
    }
    EXPECT_NEAR(max_lost_for, 0.3, 0.01) << name;
    EXPECT_LT(run.turn_error(motion.q.size() - 1), 2.0 * one_degree) << name;
  }
}

TEST(GuardedBase, InvalidInput_ReturnsAStatusAndChangesNothing) {
  const LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 0.1, 0.002);
  GuardedRun run(robot, motion, 1);
  for (std::size_t i = 1; i < motion.q.size(); ++i) ASSERT_EQ(run.tick(i), Status::Ok);
  GuardedBase& g = run.guarded;
  const VectorXd q = g.q(), v = g.v(), none;
  const ImuReading good = motion.imu.back();
  ImuReading bad = good;
  bad.gyro.x() = nan;
  EXPECT_EQ(g.update(&bad, q, v, 3, none, 0.002), Status::NotFinite);
  EXPECT_EQ(g.update(nullptr, q, v, 3, none, 0.002), Status::WrongSize);
  for (const double dt : {0.0, -0.001, nan, infinity})
    EXPECT_EQ(g.update(&good, q, v, 3, none, dt), Status::NotFinite);
  EXPECT_EQ(g.update(&good, q, v, 3, Vector3d::Ones(), 0.002), Status::WrongSize);
  EXPECT_EQ(g.update(&good, q.head(3), v, 3, none, 0.002), Status::WrongSize);
  VectorXd wrong = q;
  wrong[9] = nan;
  EXPECT_EQ(g.update(nullptr, wrong, v, 3, none, 0.1), Status::NotFinite);
  EXPECT_TRUE(g.q() == q && g.v() == v);
  EXPECT_EQ(g.source(), BaseSource::Filter);
  bad.accelerometer.setConstant(1e300);
  bad.gyro.setConstant(1e300);
  for (int i = 0; i < 10; ++i) {
    (void)g.update(&bad, q, v, 3, none, 0.002);
    EXPECT_TRUE(g.q().allFinite() && g.v().allFinite());
  }
  EXPECT_EQ(g.source(), BaseSource::Feet);
  LeggedRobot other = robot;
  other.options.watch.window = 0.0;
  burnish::testing::expect_words(
      burnish::testing::refusal([&] { GuardedBase(other.model, other.options); }),
      {"watch.window", "0"});
}

TEST(GuardedBase, Update_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  const LeggedRobot robot = humanoid_on_soles();
  const RobotMotion motion = standing_motion(robot, 2.0, 0.002);
  GuardedBase guarded(robot.model, robot.options);
  ASSERT_EQ(guarded.reset(motion.q[0], motion.v[0]), Status::Ok);
  const Eigen::Vector2d loads(400.0, 500.0);
  const AllocationGuard guard;
  for (std::size_t i = 1; i < motion.q.size(); ++i) {
    const double time = static_cast<double>(i) * motion.dt;
    const bool reads = time < 0.8 || time > 1.2;
    (void)guarded.update(reads ? &motion.imu[i] : nullptr, motion.q[i], motion.v[i],
                         time > 1.0 && time < 1.1 ? 0U : 3U, loads, reads ? motion.dt : 0.004);
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(guarded.takeovers(), 1);
  EXPECT_EQ(guarded.source(), BaseSource::Filter);
}

}  // namespace
}  // namespace burnish::test

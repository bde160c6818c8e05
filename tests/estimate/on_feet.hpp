// Legged robots, their motions, and an estimator that is fed with noisy sensor readings of a
// motion.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

#include "burnish/dynamics/placement.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "estimate/truth.hpp"
#include "support/robots.hpp"

namespace burnish::test {

/// Robot on its feet, with the IMU in its base.
struct LeggedRobot {
  Model model;
  Eigen::VectorXd q;
  BaseEstimatorOptions options;
};

inline LeggedRobot humanoid_on_soles() {
  LeggedRobot robot;
  if (has_robot_files) {
    robot.model = named_robot("talos", Base::FreeFlyer);
#if BURNISH_HAS_ROBOTS
    robot.q = load_robot(std::string(BURNISH_ROBOTS_DIR) + "/talos").reference_configuration();
#endif
  } else {
    robot.model = biped::model(Base::FreeFlyer);
    robot.q = biped::half_sitting(robot.model);
  }
  robot.options.feet = {{"left_sole_link", FootKind::Sole}, {"right_sole_link", FootKind::Sole}};
  return robot;
}

#if BURNISH_HAS_ROBOTS
inline LeggedRobot quadruped() {
  LeggedRobot robot;
  const auto loaded = load_robot(std::string(BURNISH_ROBOTS_DIR) + "/quadruped");
  robot.model = loaded.model;
  robot.q = loaded.reference_configuration();
  for (const char* foot : {"fl_foot", "fr_foot", "rl_foot", "rr_foot"})
    robot.options.feet.push_back({foot, FootKind::Ball});
  return robot;
}
#endif

inline Pose base_of(const Eigen::VectorXd& q) {
  return {Eigen::Quaterniond(q[6], q[3], q[4], q[5]).toRotationMatrix(), q.head<3>()};
}
inline Pose frame_pose(const LeggedRobot& robot, const std::string& frame) {
  const Eigen::Isometry3d at = frame_placement(robot.model, robot.q, frame);
  return {at.linear(), at.translation()};
}

/// Motion with all feet at rest on the ground.
inline RobotMotion standing_motion(const LeggedRobot& robot, double duration, double dt,
                                   double size = 1.0) {
  std::vector<FootOverTime> feet;
  for (const FootSpec& foot : robot.options.feet) {
    const Pose at = frame_pose(robot, foot.frame);
    feet.push_back({foot.frame, foot.kind == FootKind::Sole, [at](double) { return at; },
                    [](double) { return true; }});
  }
  return robot_motion(robot.model, robot.q, swaying(base_of(robot.q), size), feet, duration, dt);
}

#if BURNISH_HAS_ROBOTS
/// Trot at 0.3 m/s after a moment on all feet, two feet at a time.
inline RobotMotion trotting_motion(const LeggedRobot& robot, double duration, double dt) {
  constexpr double speed = 0.3, cycle = 0.4, down = 0.6, begin = 0.2;
  const Pose start = base_of(robot.q);
  const auto walked = [](double t) {  // starts smoothly
    const double s = std::max(0.0, t - begin);
    return speed * (s < cycle ? s * s / (2.0 * cycle) : s - 0.5 * cycle);
  };
  const PoseOverTime base = [=](double t) {
    const double w = 2.0 * M_PI / cycle, s = std::max(0.0, t - begin),
                 grown = s * s / (0.1 + s * s);
    Pose pose = start;
    pose.p +=
        Vector3d(walked(t), 0.005 * grown * std::sin(w * s), 0.004 * grown * std::sin(2.0 * w * s));
    pose.R = exp3(grown * Vector3d(0.02 * std::sin(w * s), 0.015 * std::sin(2.0 * w * s), 0.0));
    return pose;
  };
  std::vector<FootOverTime> feet;
  for (std::size_t k = 0; k < robot.options.feet.size(); ++k) {
    const std::string frame = robot.options.feet[k].frame;
    const Pose first = frame_pose(robot, frame);
    const double offset = k == 0 || k == 3 ? 0.0 : 0.5;
    // A foot stands from lift-off to lift-off, half a stride ahead of the hip in between.
    const auto cycles = [=](double t) { return (t - begin) / cycle + offset; };
    const auto place = [=](double n) {  // position of the foot in cycle n
      if (n < 1.0) return Vector3d(first.p);
      const double middle = begin + (n - offset + 0.5 * down) * cycle;
      return Vector3d(first.p + Vector3d(walked(middle), 0.0, 0.0));
    };
    const auto stands = [=](double t) {
      const double n = cycles(t), phase = n - std::floor(n);
      return n < 1.0 ? n < down : phase < down;
    };
    const auto pose = [=](double t) {
      const double n = std::max(0.0, std::floor(cycles(t))), phase = cycles(t) - n;
      Pose at = first;
      at.p = place(n);
      if (phase <= down) return at;
      const double s = (phase - down) / (1.0 - down),
                   smooth = s * s * s * (10.0 + s * (6.0 * s - 15.0));
      at.p += smooth * (place(n + 1.0) - place(n));
      at.p.z() += 0.05 * 16.0 * s * s * (1.0 - s) * (1.0 - s);
      return at;
    };
    feet.push_back({frame, false, pose, stands});
  }
  return robot_motion(robot.model, robot.q, base, feet, duration, dt);
}
#endif

/// Estimator that is fed with noisy sensor readings of a motion.
class Estimation {
 public:
  Estimation(const LeggedRobot& robot, const RobotMotion& motion, std::uint64_t seed,
             bool exact_start = false)
      : estimator(robot.model, robot.options),
        encoder_noise(robot.options.encoder_noise),
        robot_(&robot),
        motion_(&motion),
        generator_(seed) {
    const BaseEstimatorOptions& o = robot.options;
    imu_ = {{o.gyro_noise, o.accelerometer_noise, o.gyro_bias_walk, o.accelerometer_bias_walk, 0.0,
             0.0},
            motion.dt,
            &generator_,
            normal3(generator_, o.gyro_bias_deviation),
            normal3(generator_, o.accelerometer_bias_deviation)};
    Eigen::VectorXd q = motion.q[0], v = motion.v[0];
    if (!exact_start) {
      Vector3d turn = normal3(generator_, o.tilt_deviation);
      turn.z() *= o.yaw_deviation / o.tilt_deviation;
      const Pose truth = base_of(q);
      const Matrix3d R = exp3(turn).transpose() * truth.R;
      q.segment<4>(3) = Eigen::Quaterniond(R).coeffs();
      q.head<3>() -= normal3(generator_, o.position_deviation);
      const Vector3d v_world = truth.R * v.head<3>() - normal3(generator_, o.velocity_deviation);
      v.head<3>() = R.transpose() * v_world;
    }
    if (estimator.reset(q, v) != Status::Ok) throw Error("no start");
  }

  Status tick(std::size_t i, BaseEstimator::Feet standing, const ImuReading& exact) {
    Eigen::VectorXd noise = Eigen::VectorXd::Zero(robot_->model.nv);
    std::normal_distribution<double> draw(0.0, encoder_noise);
    for (Eigen::Index k = 6; k < noise.size(); ++k) noise[k] = draw(generator_);
    const Eigen::VectorXd q = integrate(robot_->model, motion_->q[i], noise);
    const Status status =
        estimator.update(imu_.read(exact), q, motion_->v[i], standing, motion_->dt);
    squared_ += estimator.innovation().squared;
    rows_ += estimator.innovation().rows;
    return status;
  }
  Status tick(std::size_t i) { return tick(i, motion_->standing[i], motion_->imu[i]); }

  /// Error of the estimate in the convention of reset()'s covariance: world axes, at the IMU (here
  /// the base).
  Eigen::VectorXd error(std::size_t i) const {
    const Pose truth = base_of(motion_->q[i]), estimate = base_of(estimator.q());
    Eigen::VectorXd e(15);
    e << log3(truth.R * estimate.R.transpose()),
        truth.R * motion_->v[i].head<3>() - estimate.R * estimator.v().head<3>(),
        truth.p - estimate.p, imu_.b_gyro - estimator.gyro_bias(),
        imu_.b_accelerometer - estimator.accelerometer_bias();
    return e;
  }
  /// Normalized squared error of the 11 observable quantities: tilt, velocity seen from the base,
  /// biases.
  double observable_square(std::size_t i) const {
    const Vector3d v = base_of(estimator.q()).R * estimator.v().head<3>();
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(11, 15);
    T.topLeftCorner(2, 2).setIdentity();
    T.block<3, 3>(2, 3).setIdentity();
    // d(R^T v) = R^T (dv + v x theta)
    T.block<3, 3>(2, 0) << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    T.bottomRightCorner(6, 6).setIdentity();
    return square(T, i);
  }
  double whole_square(std::size_t i) const { return square(Eigen::MatrixXd::Identity(15, 15), i); }
  double squared_innovations() const { return squared_; }
  long innovation_rows() const { return rows_; }

  BaseEstimator estimator;
  double encoder_noise;

 private:
  double square(const Eigen::MatrixXd& T, std::size_t i) const {
    const Eigen::VectorXd e = T * error(i);
    return e.dot((T * estimator.covariance() * T.transpose()).ldlt().solve(e));
  }

  const LeggedRobot* robot_;
  const RobotMotion* motion_;
  std::mt19937_64 generator_;
  NoisyImu imu_{};
  double squared_ = 0.0;
  long rows_ = 0;
};

}  // namespace burnish::test

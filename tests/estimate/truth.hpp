// Motions of an IMU and of robots with exact states, and sensor readings of them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/model/state.hpp"
#include "estimate/contact_filter.hpp"
#include "math/logarithm.hpp"

namespace burnish::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

inline const Vector3d gravity(0.0, 0.0, -9.81);

inline Matrix3d exp3(const Vector3d& phi) {
  const Vec3<double> w = from_eigen(phi);
  return to_eigen(exp_matrix(w, rotation_series(w)));
}
inline Vector3d log3(const Matrix3d& R) {
  double angle;
  return to_eigen(log_rotation(from_eigen(R), angle));
}
inline Vector3d normal3(std::mt19937_64& generator, double deviation) {
  std::normal_distribution<double> draw(0.0, 1.0);
  const double x = draw(generator), y = draw(generator), z = draw(generator);
  return deviation * Vector3d(x, y, z);
}

/// Pose of a frame in the world over time.
struct Pose {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero();
};
using PoseOverTime = std::function<Pose(double)>;

/// Motion of a standing robot's base: it sways, bows and squats about its initial pose.
inline PoseOverTime swaying(const Pose& start, double size = 1.0) {
  return [start, size](double t) {
    const double w = 2.0 * M_PI * 0.6;
    const auto swing = [](double x) { return 1.0 - std::cos(x); };
    Pose pose = start;
    pose.p += size * Vector3d(0.02 * swing(0.9 * w * t), 0.03 * swing(0.7 * w * t),
                              -0.03 * swing(1.1 * w * t));
    pose.R = start.R * exp3(size * Vector3d(0.05 * swing(0.8 * w * t), 0.08 * swing(w * t),
                                            0.1 * swing(0.5 * w * t)));
    return pose;
  };
}

inline Vector3d velocity_at(const PoseOverTime& pose, double t) {
  constexpr double h = 1e-5;
  return (pose(t + h).p - pose(t - h).p) / (2.0 * h);
}
/// Angular velocity in body axes.
inline Vector3d turning_at(const PoseOverTime& pose, double t) {
  constexpr double h = 1e-5;
  return log3(pose(t - h).R.transpose() * pose(t + h).R) / (2.0 * h);
}

/// IMU reading without noise between t and t + dt. Held constant, it leads from the first rotation
/// and velocity to the second.
inline ImuReading exact_reading(const PoseOverTime& pose, double t, double dt) {
  const Pose before = pose(t), after = pose(t + dt);
  ImuReading reading;
  reading.gyro = log3(before.R.transpose() * after.R) / dt;
  const Vec3<double> phi = from_eigen(Vector3d(reading.gyro * dt));
  const Vector3d change = (velocity_at(pose, t + dt) - velocity_at(pose, t)) / dt - gravity;
  reading.accelerometer =
      to_eigen(gamma_1(phi, rotation_series(phi))).inverse() * (before.R.transpose() * change);
  return reading;
}

/// IMU readings with white noise and random-walk biases.
struct NoisyImu {
  FilterNoise noise;
  double dt;
  std::mt19937_64* generator;
  Vector3d b_gyro, b_accelerometer;

  ImuReading read(ImuReading exact) {
    const double per_reading = 1.0 / std::sqrt(dt), walk = std::sqrt(dt);
    exact.gyro += b_gyro + normal3(*generator, noise.gyro * per_reading);
    exact.accelerometer += b_accelerometer + normal3(*generator, noise.accelerometer * per_reading);
    b_gyro += normal3(*generator, noise.gyro_bias * walk);
    b_accelerometer += normal3(*generator, noise.accelerometer_bias * walk);
    return exact;
  }
};

/// Motion of a robot at the ticks of a clock: states, readings of the IMU in the base over the time
/// before each tick (zero at the first), and standing feet.
struct RobotMotion {
  double dt = 0.0;
  std::vector<Eigen::VectorXd> q, v;
  std::vector<ImuReading> imu;
  std::vector<FootSet> standing;
};

/// Pose of a foot over time, and whether it stands.
struct FootOverTime {
  std::string frame;
  bool sole = false;
  std::function<Pose(double)> pose;
  std::function<bool(double)> stands;
};

/// Computes leg joints that put the feet at their poses, by Newton's method from the previous tick.
inline RobotMotion robot_motion(const Model& model, const Eigen::VectorXd& q_start,
                                const PoseOverTime& base, const std::vector<FootOverTime>& feet,
                                double duration, double dt) {
  RigidBody body(model);
  RobotMotion motion;
  motion.dt = dt;
  Eigen::VectorXd q = q_start;
  PlacementDerivatives by_q;
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  const auto ticks = static_cast<int>(std::lround(duration / dt));
  for (int i = 0; i <= ticks; ++i) {
    const double t = i * dt;
    const Pose at = base(t);
    q.head<3>() = at.p;
    q.segment<4>(3) = Eigen::Quaterniond(at.R).coeffs();
    for (int iteration = 0; iteration < (i == 0 ? 30 : 4); ++iteration) {
      Eigen::VectorXd step = rest;
      if (body.update(q, rest) != Status::Ok)
        throw Error("motion: the robot's state cannot be evaluated");
      for (const FootOverTime& foot : feet) {
        const int frame = body.frame(foot.frame);
        const Pose wanted = foot.pose(t);
        Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
        target.linear() = wanted.R;
        target.translation() = wanted.p;
        body.placement_derivatives(frame, target, by_q);
        Eigen::MatrixXd J = by_q.position;
        Eigen::VectorXd error = body.placement(frame).translation() - wanted.p;
        if (foot.sole) {
          J.conservativeResize(6, model.nv);
          J.bottomRows(3) = by_q.rotation_error;
          error.conservativeResize(6);
          error.tail(3) = log3(wanted.R.transpose() * body.placement(frame).linear());
        }
        J.leftCols(6).setZero();
        // Joints between base and trunk do not move the feet; each leg has as many joints as rows.
        step -= J.transpose() * (J * J.transpose()).ldlt().solve(error);
      }
      q = integrate(model, q, step);
      if (step.norm() < 1e-13) break;
    }
    motion.q.push_back(q);
    motion.imu.push_back(i == 0 ? ImuReading{} : exact_reading(base, t - dt, dt));
    FootSet standing = 0;
    for (std::size_t k = 0; k < feet.size(); ++k)
      if (feet[k].stands(t)) standing |= foot_bit(static_cast<int>(k));
    motion.standing.push_back(standing);
  }
  for (int i = 0; i <= ticks; ++i) {
    const int before = std::max(i - 1, 0), after = std::min(i + 1, ticks);
    const auto at = [&](int k) -> const Eigen::VectorXd& {
      return motion.q[static_cast<std::size_t>(k)];
    };
    Eigen::VectorXd v = difference(model, at(before), at(after)) / ((after - before) * dt);
    const Pose now = base(i * dt);
    v.head<3>() = now.R.transpose() * velocity_at(base, i * dt);
    v.segment<3>(3) = turning_at(base, i * dt);
    motion.v.push_back(v);
  }
  return motion;
}

}  // namespace burnish::test

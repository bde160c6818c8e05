// Comparison of an inertial measurement unit (IMU) with standing feet: the difference between their
// motions over the last time window.
#pragma once

#include "burnish/estimate/imu.hpp"
#include "estimate/feet_fit.hpp"

namespace burnish {

/// Differences between the motion that the IMU's sensors measure and the motion that the feet
/// imply. A high-pass filter H(s) = s window/(1 + s window) removes old differences:
///   turned = H (angle from the gyroscope - angle from the feet),
///   moved  = H^2 (position from the accelerometer - position from the feet).
/// The position from the accelerometer is integrated with the rotation from the feet, so that a
/// fault of one sensor shows in one difference only. A constant offset of the gyroscope leads to
/// turned = offset x window, and a constant offset of the accelerometer leads to moved = offset x
/// window^2. Encoder errors enter both differences directly, without differentiation.
class UnitWatch {
 public:
  /// `window`: time constant of H [s].
  explicit UnitWatch(double window) : window_(window) {}

  /// Starts the comparison with zero differences. `by_feet`: pose of the IMU computed from the
  /// feet. `v_world`: velocity of the IMU in the world [m/s].
  void begin(const UnitPose& by_feet, const Eigen::Vector3d& v_world) noexcept;
  void stop() noexcept { begun_ = false; }
  /// Replaces the pose from the feet, after feet were put down again. The change does not count as
  /// a motion.
  void shift(const UnitPose& by_feet) noexcept { before_ = by_feet; }
  /// Adds a reading without biases, which covers the last `dt` [s]. `by_feet`, `v_by_feet`: pose
  /// and velocity [m/s] of the IMU from the feet at the end of the reading, in the world.
  /// `gravity`: gravity vector in the world [m/s^2].
  void advance(const ImuReading& reading, const UnitPose& by_feet, const Eigen::Vector3d& v_by_feet,
               const Eigen::Vector3d& gravity, double dt) noexcept;

  bool has_begun() const { return begun_; }
  /// Returns the difference of rotations `turned`, in world axes [rad].
  const Eigen::Vector3d& turned() const { return turned_; }
  /// Returns the difference of displacements `moved`, in world axes [m].
  Eigen::Vector3d moved() const { return place_ - place_by_feet_; }
  /// Returns the difference of velocities, H (velocity from the accelerometer - velocity from the
  /// feet), in world axes [m/s]. It shows a fault earlier than moved(), but has more noise.
  Eigen::Vector3d sped() const { return speed_ - speed_by_feet_; }
  /// Answer of tips_over(). Yes: both sensors agree that the IMU turns about `point`, unlike the
  /// feet, so that the robot tips over. No: the rotation is below `min_turn` [rad], or the sensors
  /// do not agree. Unclear: the expected displacement is below `min_place` [m].
  enum class Tips { No, Unclear, Yes };
  Tips tips_over(const Eigen::Vector3d& point, double min_turn, double min_place) const noexcept;
  /// Returns for how long the IMU has repeated identical readings [s].
  double repeats_for() const { return repeats_for_; }
  /// Returns the mean since begin() of the difference in angular velocity, gyroscope minus feet, in
  /// the axes of the IMU [rad/s].
  Eigen::Vector3d mean_rate() const noexcept;

 private:
  double window_;
  bool begun_ = false;
  double repeats_for_ = 0.0;  ///< Time for which readings have been identical [s].
  UnitPose before_;
  ImuReading last_;
  Eigen::Vector3d turned_ = Eigen::Vector3d::Zero(), turned_twice_ = turned_;
  /// Velocity (filtered by H) and displacement (H^2) from the accelerometer [m/s, m].
  Eigen::Vector3d speed_ = turned_, place_ = turned_;
  /// Displacement that the feet imply, filtered by H (path_by_feet_) and H^2 (place_by_feet_) [m].
  Eigen::Vector3d path_by_feet_ = turned_, place_by_feet_ = turned_;
  Eigen::Vector3d v_before_ = turned_, speed_by_feet_ = turned_;
  /// Integral of the differences in angular velocity, in the axes of the IMU [rad].
  Eigen::Vector3d sum_ = turned_;
  double time_ = 0.0;  ///< Time since begin() [s].
};

}  // namespace burnish

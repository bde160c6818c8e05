// What an inertial unit says against what feet say that stand: how far the two come apart within a
// time.
#pragma once

#include "burnish/estimate/imu.hpp"
#include "estimate/feet_fit.hpp"

namespace burnish {

/// Both are told with what is long ago forgotten, H(s) = s window/(1 + s window):
///   turned = H (angle of the gyroscope - angle of the feet),
///   moved  = H^2 (place of the accelerometer - place of the feet),
/// the accelerometer's with the rotation that the feet tell, so that each sensor is told apart. An
/// offset of the gyroscope leaves offset x window, of the accelerometer offset x window^2. Encoders
/// enter as angles and places, never as rates.
class UnitWatch {
 public:
  explicit UnitWatch(double window) : window_(window) {}

  /// Nothing is known of before; the unit is there by the feet, and moves at v_world, m/s.
  void begin(const UnitPose& by_feet, const Eigen::Vector3d& v_world) noexcept;
  void stop() noexcept { begun_ = false; }
  /// The feet tell it anew, as it is now, without a motion.
  void shift(const UnitPose& by_feet) noexcept { before_ = by_feet; }
  /// A reading over the last `dt` s without its biases, at whose end the unit is there by the feet
  /// and moves at v_by_feet, m/s, world. gravity: m/s^2, world.
  void advance(const ImuReading& reading, const UnitPose& by_feet, const Eigen::Vector3d& v_by_feet,
               const Eigen::Vector3d& gravity, double dt) noexcept;

  bool has_begun() const { return begun_; }
  const Eigen::Vector3d& turned() const { return turned_; }          ///< rad, world axes
  Eigen::Vector3d moved() const { return place_ - place_by_feet_; }  ///< m, world axes
  /// H (speed of the accelerometer - speed of the feet), m/s, world axes: sooner there than the
  /// place, and noisier.
  Eigen::Vector3d sped() const { return speed_ - speed_by_feet_; }
  /// Whether both sensors say that the unit turns about a point, which the feet do not: its robot
  /// tips over. Not told of turns below `least_turn` (rad); unclear where what it would have moved
  /// by is below `least_place` (m).
  enum class Tips { No, Unclear, Yes };
  Tips tips_over(const Eigen::Vector3d& point, double least_turn,
                 double least_place) const noexcept;
  /// s that the unit has said the same to the last digit.
  double repeats_for() const { return repeats_for_; }
  /// rad/s that the gyroscope said beyond the feet, in the unit's axes, mean since begin().
  Eigen::Vector3d mean_rate() const noexcept;

 private:
  double window_;
  bool begun_ = false;
  double repeats_for_ = 0.0;  ///< s
  UnitPose before_;
  ImuReading last_;
  Eigen::Vector3d turned_ = Eigen::Vector3d::Zero(), turned_twice_ = turned_;
  Eigen::Vector3d speed_ = turned_, place_ = turned_;                ///< of the accelerometer
  Eigen::Vector3d way_by_feet_ = turned_, place_by_feet_ = turned_;  ///< H and H^2
  Eigen::Vector3d v_before_ = turned_, speed_by_feet_ = turned_;
  Eigen::Vector3d sum_ = turned_;  ///< rad, unit's axes
  double time_ = 0.0;              ///< s since begin()
};

}  // namespace burnish

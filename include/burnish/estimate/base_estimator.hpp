// Where a robot on its feet is and how it moves: its floating base from a gyroscope, an
// accelerometer, encoders and which feet stand. See docs/state_estimation.md.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// What of a foot stays where it is while the foot stands.
/// @described estimate
enum class FootKind {
  Ball,  ///< the frame's origin
  Sole,  ///< the frame: it neither moves nor turns
};

/// A foot that may stand.
/// @described estimate
struct FootSpec {
  std::string frame;               ///< of a ball its middle, where it rolls little @required
  FootKind kind = FootKind::Ball;  ///< ball, whose origin stays, or sole, which does not turn
};

/// Thresholds by which a faulty inertial measurement unit is found while feet stand.
/// @described estimate
/// GuardedBase uses them; BaseEstimator does not.
struct UnitWatchOptions {
  bool enabled = true;  ///< compare the unit with the feet; else find only a unit that is silent
  double window = 0.1;  ///< [s] over which the unit and the feet are compared, > 0
  double turn = 2e-3;   ///< [rad] that they may differ by in it, beside noise and biases, > 0
  double place = 2e-3;  ///< [m], likewise, > 0
  /// Turn rate in excess of the feet's that is not used until it is clear which of both is wrong
  /// [rad/s], > 0
  double rate = 0.1;
  double feet_turn = 2e-3;     ///< [rad] that a sole may turn against the others and stand, > 0
  double feet_place = 1e-3;    ///< [m] that a foot may move against the others and stand, > 0
  double silent_after = 3e-3;  ///< [s] without a reading, after which there is none, >= 0
  /// [s] that a unit has to agree with the feet before it counts again, > 0
  double back_after = 0.5;
  double fading = 0.03;  ///< [s] in which the difference is made up when the feet take over, > 0
};

/// How the floating base is estimated. Noise is white where it is a density, a deviation per square
/// root of Hz: a reading every dt s has the density times 1/sqrt(dt).
/// @described estimate
struct BaseEstimatorOptions {
  /// frame of the measurement unit, whose axes its readings have; empty: the floating base's body
  std::string imu_frame = {};
  std::vector<FootSpec> feet = {};  ///< that may stand, up to 32

  // @group Noise.
  double gyro_noise = 1e-3;               ///< [rad/s/sqrt(Hz)], >= 0
  double accelerometer_noise = 1e-2;      ///< [m/s^2/sqrt(Hz)], >= 0
  double gyro_bias_walk = 1e-5;           ///< [rad/s^2/sqrt(Hz)] that the bias walks with, >= 0
  double accelerometer_bias_walk = 1e-4;  ///< [m/s^3/sqrt(Hz)] that the bias walks with, >= 0
  double encoder_noise = 1e-4;            ///< [rad (m)], deviation of a reading, >= 0
  /// [m], deviation per reading of a foot's place, beside encoders, > 0
  double place_noise = 1e-4;
  double turn_noise = 1e-4;  ///< [rad], deviation per reading of a sole's rotation, likewise, > 0
  double slip_noise = 1e-3;  ///< [m/s/sqrt(Hz)] that a foot creeps with, >= 0
  double sole_turn_noise = 1e-3;  ///< [rad/s/sqrt(Hz)] that a sole creeps with, >= 0

  // @group Feet that slip.
  /// share of a foot's readings that pass while it stands still, between 0 and 1
  double gate = 0.99999;
  /// [s] that a foot which slipped has to rest before it counts again, >= 0
  double rejoin_after = 0.05;
  double rejoin_speed = 0.03;  ///< [m/s] below which it rests, > 0
  /// Time for which feet stand and all of them seem to slip [s], after which the base's velocity is
  /// taken to be wrong instead, >= 0
  double lost_after = 0.15;

  // @group Of what reset() is told.
  double tilt_deviation = 0.02;  ///< [rad], of what reset() is told, about horizontal axes, >= 0
  double yaw_deviation = 1e-3;   ///< [rad], likewise about the vertical, >= 0
  double velocity_deviation = 0.05;           ///< [m/s], likewise, >= 0
  double position_deviation = 1e-3;           ///< [m], likewise, >= 0
  double gyro_bias_deviation = 0.01;          ///< [rad/s], likewise, >= 0
  double accelerometer_bias_deviation = 0.1;  ///< [m/s^2], likewise, >= 0

  // @group A unit that goes wrong.
  UnitWatchOptions watch = {};  ///< of the unit, by the feet
};

/// Of the readings of feet at the last update, against what was expected.
/// @described estimate @result
struct EstimatorInnovation {
  /// r^T S^-1 r, as a chi-square of `rows` degrees where the filter is right
  double squared = 0.0;
  int rows = 0;  ///< that were used
};

/// A right-invariant extended Kalman filter (Hartley, Ghaffari, Eustice, Grizzle, "Contact-aided
/// invariant extended Kalman filtering for robot state estimation", 2020), with soles beside
/// points. Position and yaw are those of reset(), and drift: nothing that it measures knows them.
///
/// A foot counts from the update on in which it stands, until it is lifted. A foot that stands but
/// reads beyond its gate slips: it is left out until it has rested, and put down anew where it then
/// is.
///
/// Ticks allocate nothing and throw nothing. What a status above Ok is answered to changes nothing.
class BaseEstimator {
 public:
  using Feet = std::uint32_t;  ///< bit k: foot k of the options

  /// Throws Error for a robot without a floating base, unknown frames and options out of range.
  BaseEstimator(const Model& model, const BaseEstimatorOptions& options);
  ~BaseEstimator();
  BaseEstimator(BaseEstimator&&) noexcept;
  BaseEstimator& operator=(BaseEstimator&&) noexcept;

  /// Starts at q (nq) and v (nv) of the whole robot, with the options' deviations, biases zero and
  /// no foot on the ground. With `covariance` (15 x 15), of the unit, world axes: rotation vector
  /// (rad), velocity (m/s), position (m), gyroscope's (rad/s) and accelerometer's (m/s^2) bias.
  /// WrongSize, NotFinite, NotNormalized; NotPhysical for a covariance that is none.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v,
               const Eigen::Ref<const Eigen::MatrixXd>& covariance) noexcept;

  /// Starts again at q and v of the whole robot, after a time in which something else told the
  /// base. The deviations are those before and the options' together; biases (rad/s, m/s^2) are
  /// what it is told. No foot is on the ground. WrongSize, NotFinite, NotNormalized, which change
  /// nothing, or Ok.
  Status resume(const ConstVectorRef& q, const ConstVectorRef& v, const Eigen::Vector3d& gyro_bias,
                const Eigen::Vector3d& accelerometer_bias) noexcept;

  /// What was read `dt` s after the last update: the unit's means over that time, and the joints'
  /// entries of q (nq) and v (nv) now; entries of the base are passed over. `standing`: feet on the
  /// ground. WrongSize, NotFinite (also for a dt that is not positive), NotNormalized; Ok
  /// otherwise.
  Status update(const ImuReading& imu, const ConstVectorRef& q, const ConstVectorRef& v,
                Feet standing, double dt) noexcept;

  const Eigen::VectorXd& q() const;  ///< nq, with the joints as they were read
  const Eigen::VectorXd& v() const;  ///< nv, likewise
  /// 15 x 15, as reset() takes it.
  const Eigen::MatrixXd& covariance() const;
  const Eigen::Vector3d& gyro_bias() const;           ///< rad/s
  const Eigen::Vector3d& accelerometer_bias() const;  ///< m/s^2
  /// Of a foot that counts, where it stands: world, m.
  Eigen::Vector3d foot_position(int foot) const;
  /// Of any foot, as the base and the joints were last told: foot -> world.
  Eigen::Matrix3d foot_rotation(int foot) const;
  Feet feet_that_count() const;
  Feet feet_that_slip() const;  ///< that stand and are left out
  const EstimatorInnovation& innovation() const;

  int feet() const;
  const BaseEstimatorOptions& options() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish

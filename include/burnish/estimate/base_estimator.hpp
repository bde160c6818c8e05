// Estimate of pose and velocity of the floating base of a robot on its feet. Inputs are a
// gyroscope, an accelerometer, joint encoders and the set of standing feet. See
// docs/state_estimation.md.
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

class FootKinematics;

/// Kind of a foot: motions of the foot that are zero while the foot stands.
/// @described estimate
enum class FootKind {
  Ball,  ///< Point foot: the origin of its frame does not move
  Sole,  ///< Planar foot: its frame neither moves nor rotates
};

/// Foot of a robot. The estimator uses the foot while the foot stands on the ground.
/// @described estimate
struct FootSpec {
  /// Name of the foot's frame @more For a ball, the frame is at the centre of the ball, and the
  /// ball should roll only a little. @required
  std::string frame;
  /// Kind of foot: ball (frame origin does not move) or sole (frame neither moves nor rotates)
  FootKind kind = FootKind::Ball;
};

/// Thresholds for detecting a faulty inertial measurement unit (IMU) while feet stand.
/// @described estimate
/// GuardedBase uses these options; BaseEstimator does not.
struct UnitWatchOptions {
  /// Whether to compare the IMU with the feet @more If not, the only detected fault is an IMU
  /// without readings.
  bool enabled = true;
  /// Time window in which IMU and feet are compared [s], > 0 @more Older differences fade
  /// exponentially.
  double window = 0.1;

  /// Largest accepted difference in rotation between IMU and feet in the window [rad], > 0 @more
  /// The threshold is increased by the expected effects of noise and biases.
  double turn = 2e-3;
  /// Largest accepted difference in displacement between IMU and feet in the window [m], > 0 @more
  /// The threshold is increased by the expected effects of noise and biases.
  double place = 2e-3;
  /// Largest accepted difference in angular velocity between IMU and feet [rad/s], > 0 @more
  /// Readings beyond this threshold are withheld from the filter until it is clear whether the IMU
  /// or the feet are wrong.
  double rate = 0.1;
  /// Largest accepted rotation of a standing sole relative to the other feet [rad], > 0
  double feet_turn = 2e-3;
  /// Largest accepted displacement of a standing foot relative to the other feet [m], > 0
  double feet_place = 1e-3;
  /// Time without readings after which the IMU counts as silent [s], >= 0
  double silent_after = 3e-3;
  /// Time of agreement with the feet after which a faulty IMU is used again [s], > 0
  double back_after = 0.5;
  /// Decay time of the offset that prevents a jump of the estimate when the IMU fails [s], > 0
  /// @more The offset is the last estimate minus the estimate from the feet.
  double decay_time = 0.03;
};

/// Options for estimating the floating base. Noise densities describe white noise: with one reading
/// every dt s, the standard deviation of a reading is density / sqrt(dt).
/// @described estimate
struct BaseEstimatorOptions {
  /// Frame of the inertial measurement unit (empty: the floating base's body) @more Readings are in
  /// the axes of this frame.
  std::string imu_frame = {};
  std::vector<FootSpec> feet = {};  ///< Feet of the robot, 1 to 32 of them

  // @group Noise.
  double gyro_noise = 1e-3;           ///< Noise density of the gyroscope [rad/s/sqrt(Hz)], >= 0
  double accelerometer_noise = 1e-2;  ///< Noise density of the accelerometer [m/s^2/sqrt(Hz)], >= 0

  /// Random-walk density of the gyroscope's bias [rad/s^2/sqrt(Hz)], >= 0
  double gyro_bias_walk = 1e-5;
  /// Random-walk density of the accelerometer's bias [m/s^3/sqrt(Hz)], >= 0
  double accelerometer_bias_walk = 1e-4;
  double encoder_noise = 1e-4;  ///< Standard deviation of an encoder reading [rad (m)], >= 0

  /// Standard deviation of a foot's measured position, in addition to encoder noise [m], > 0
  double place_noise = 1e-4;
  /// Standard deviation of a sole's measured rotation, in addition to encoder noise [rad], > 0
  double turn_noise = 1e-4;
  /// Random-walk density of a standing foot's position, for slow slip [m/s/sqrt(Hz)], >= 0
  double slip_noise = 1e-3;
  /// Random-walk density of a standing sole's rotation, for slow slip [rad/s/sqrt(Hz)], >= 0
  double sole_turn_noise = 1e-3;

  // @group Feet that slip.
  /// Fraction of a resting foot's readings that pass the outlier test, between 0 and 1
  double gate = 0.99999;
  /// Rest time after which a foot that slipped is used again [s], >= 0
  double rejoin_after = 0.05;
  /// Speed below which a foot that slipped counts as at rest [m/s], > 0
  double rejoin_speed = 0.03;

  /// Longest time in which all standing feet may seem to slip [s], >= 0 @more After this time, the
  /// filter assumes that its own velocity is wrong.
  double lost_after = 0.15;

  // @group Standard deviations of the initial state.
  /// Standard deviation of the initial rotation about horizontal axes (tilt) [rad], >= 0
  double tilt_deviation = 0.02;
  /// Standard deviation of the initial rotation about the vertical (yaw) [rad], >= 0
  double yaw_deviation = 1e-3;
  double velocity_deviation = 0.05;  ///< Standard deviation of the initial velocity [m/s], >= 0
  double position_deviation = 1e-3;  ///< Standard deviation of the initial position [m], >= 0

  /// Standard deviation of the gyroscope's initial bias [rad/s], >= 0
  double gyro_bias_deviation = 0.01;
  /// Standard deviation of the accelerometer's initial bias [m/s^2], >= 0
  double accelerometer_bias_deviation = 0.1;

  // @group Faults of the inertial measurement unit.
  UnitWatchOptions watch = {};  ///< Monitor that compares the IMU with the feet
};

/// Innovation r of the last update: measured minus predicted positions and rotations of the feet.
/// @described estimate @result
struct EstimatorInnovation {
  /// Normalized square r^T S^-1 r, with the covariance S of r @more If the filter is consistent,
  /// this square has a chi-square distribution with `rows` degrees of freedom.
  double squared = 0.0;
  int rows = 0;  ///< Number of entries of r that the update used
};

/// Right-invariant extended Kalman filter for the floating base (Hartley, Ghaffari, Eustice,
/// Grizzle, "Contact-aided invariant extended Kalman filtering for robot state estimation", 2020).
/// This version handles point feet and also planar feet (soles). Position and yaw drift from their
/// values at reset(), since no sensor measures them.
///
/// The filter uses a foot while the foot stands. If a reading of a standing foot fails the outlier
/// test, the filter assumes that the foot slips. It then ignores the foot until the foot has rested
/// for a while, and uses it again at its new position.
///
/// Updates allocate nothing and throw nothing. A call that returns a Status other than Ok changes
/// nothing.
class BaseEstimator {
 public:
  using Feet = std::uint32_t;  ///< Set of feet: bit k is foot k of the options

  /// Creates the filter. Throws Error for a robot without a floating base, unknown frames, and
  /// options out of range.
  BaseEstimator(const Model& model, const BaseEstimatorOptions& options);
  ~BaseEstimator();
  BaseEstimator(BaseEstimator&&) noexcept;
  BaseEstimator& operator=(BaseEstimator&&) noexcept;

  /// Starts the filter at `q` (nq) and `v` (nv) of the whole robot, with zero biases and no
  /// standing foot. Without `covariance`, the initial covariance comes from the standard deviations
  /// in the options.
  ///
  /// `covariance` (15 x 15) is the initial covariance of the IMU's state in world axes. Its rows
  /// are rotation vector (rad), velocity (m/s), position (m), gyroscope bias (rad/s) and
  /// accelerometer bias (m/s^2). Returns Ok, WrongSize, NotFinite or NotNormalized. Returns
  /// NotPhysical if `covariance` is not a covariance matrix.
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept;
  Status reset(const ConstVectorRef& q, const ConstVectorRef& v,
               const Eigen::Ref<const Eigen::MatrixXd>& covariance) noexcept;

  /// Restarts the filter at `q` (nq) and `v` (nv) of the whole robot, after a time in which the
  /// filter was not used. The initial covariance of the options is added to the old covariance.
  /// Biases are set to `gyro_bias` [rad/s] and `accelerometer_bias` [m/s^2]. No foot counts as
  /// standing until the next update(). Returns Ok. If the call returns WrongSize, NotFinite or
  /// NotNormalized, nothing has changed.
  Status resume(const ConstVectorRef& q, const ConstVectorRef& v, const Eigen::Vector3d& gyro_bias,
                const Eigen::Vector3d& accelerometer_bias) noexcept;

  /// Updates the estimate with the readings of the last `dt` [s]. `imu` holds mean values over this
  /// time. `q` (nq) and `v` (nv) hold the current joint readings; their entries for the base are
  /// ignored. `standing` is the set of feet on the ground. Returns Ok. If the call returns
  /// WrongSize, NotFinite (also if dt is not positive) or NotNormalized, nothing has changed.
  Status update(const ImuReading& imu, const ConstVectorRef& q, const ConstVectorRef& v,
                Feet standing, double dt) noexcept;

  const Eigen::VectorXd& q() const;  ///< Estimated base and measured joint positions, nq
  const Eigen::VectorXd& v() const;  ///< Estimated base and measured joint velocities, nv

  /// Covariance of the estimate (15 x 15) in world axes. Its rows are rotation vector (rad),
  /// velocity (m/s), position (m), gyroscope bias (rad/s) and accelerometer bias (m/s^2).
  const Eigen::MatrixXd& covariance() const;
  const Eigen::Vector3d& gyro_bias() const;  ///< Estimated bias of the gyroscope [rad/s]

  /// Estimated bias of the accelerometer [m/s^2].
  const Eigen::Vector3d& accelerometer_bias() const;
  /// Returns the filter's estimate of a foot's position, in world coordinates [m]. `foot` must be
  /// in the set feet_that_count().
  Eigen::Vector3d foot_position(int foot) const;
  /// Returns the rotation matrix from a foot's axes to world axes, at the last update. The foot
  /// need not stand.
  Eigen::Matrix3d foot_rotation(int foot) const;
  Feet feet_that_count() const;
  Feet feet_that_slip() const;  ///< Standing feet that the filter ignores because they slip
  const EstimatorInnovation& innovation() const;

  int feet() const;
  const BaseEstimatorOptions& options() const;

 private:
  friend class GuardedBase;
  FootKinematics& kinematics() noexcept;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish

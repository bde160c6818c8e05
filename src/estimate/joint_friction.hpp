// Estimate of joint friction from the correlation between model error and joint velocities, and
// feedforward compensation of the friction.
#pragma once

#include <cmath>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/estimate/model_error.hpp"
#include "estimate/loop_times.hpp"
#include "estimate/sent_torques.hpp"

namespace burnish {

/// Estimator with a Kalman filter per joint. The measurement of the filter is the observed model
/// error
///   d = c - F s(v) - B v,   s(v) = tanh(v / w).
/// The offset c varies fast. The friction coefficients F >= 0 (Coulomb) and B >= 0 (viscous) vary
/// slowly.
///
/// v is the planned velocity, because encoders do not resolve the moment at which a joint reverses.
/// Plans are read lead() ahead and then smoothed by a filter with this delay, so that v is not
/// late. The width w is `friction_speed` at least. It grows with the deviation of the measured
/// velocity from v, so that s is the expected sign of an uncertain velocity. With a constant w, the
/// compensation would accelerate a light joint whose measured velocity is only noise.
class JointFriction {
 public:
  /// `held`: contacts that always hold the robot, such as feet and loops. The friction of joints in
  /// their closed chains is not estimated, because the friction of one joint appears in the torque
  /// errors of all joints of a closed chain.
  JointFriction(const Model& model, const ModelErrorOptions& options, const LoopTimes& times,
                const std::vector<ContactSpec>& held);

  void reset() noexcept;
  /// Returns the time after a plan's first knot for which foresee() takes the planned velocity [s].
  double lead() const { return lead_; }
  /// Sets the velocity (nv) of a new plan at lead() after the plan's first knot.
  void foresee(const double* v) noexcept;
  /// Advances torque() by `dt` [s], to the next tick.
  void advance(double dt) noexcept;
  /// Sets torque() to zero until the next advance().
  void rest() noexcept { torque_.setZero(); }
  /// Updates the estimates from the torque error of an observer (nv) and the measured velocity
  /// (nv). The torques that the observer assumes must not include torque(). `bandwidth`: bandwidth
  /// of the observer [rad/s].
  void learn(const Eigen::VectorXd& torque_error, const Eigen::VectorXd& v, double bandwidth,
             double dt) noexcept;

  const Eigen::VectorXd& torque() const { return torque_; }  ///< Compensation, nv [Nm or N].
  /// Returns the estimated Coulomb friction F of entry k [Nm or N].
  double coulomb(int k) const { return joints_[to_size(k)].x[1]; }
  /// Returns the estimated viscous friction B of entry k [Nms/rad or Ns/m].
  double viscous(int k) const { return joints_[to_size(k)].x[2]; }
  /// Returns the standard deviation of the estimated F [Nm or N].
  double deviation(int k) const { return std::sqrt(joints_[to_size(k)].P(1, 1)); }

 private:
  struct Late {  ///< Second-order low-pass filter.
    double first = 0.0, second = 0.0;
    double follow(double value, double weight) {
      first += weight * (value - first);
      return second += weight * (first - second);
    }
  };
  struct Joint {
    bool driven = false;
    double prior = 1.0;  ///< Initial standard deviation of F [Nm or N].
    /// Planned velocity: raw (ahead), low-pass filtered once (between) and twice (v) [rad/s].
    double ahead = 0.0, between = 0.0, v = 0.0;
    Late sign, speed, given;
    Late actual, foreseen;  ///< Measured and planned velocity, low-pass filtered alike [rad/s].
    double strays = 0.0;  ///< Mean square of the difference `actual` minus `foreseen` [rad^2/s^2].
    Eigen::Vector3d x;    ///< State: offset c, friction F and B.
    Eigen::Matrix3d P;
    double noise = 0.0;  ///< Variance of the observed error [Nm^2].
  };
  double sign_of(const Joint& joint, double v) const noexcept;
  void learn(Joint& joint, double error, double speed, double weight, double dt) noexcept;

  bool enabled_;
  ModelErrorOptions options_;
  double lead_;       ///< Time from a plan's first knot to the velocity for foresee() [s].
  double smoothing_;  ///< Time constant of the filter of planned velocities [s].
  std::vector<Joint> joints_;
  Eigen::VectorXd torque_;
  int late_;                      ///< Age of the observed error, LoopTimes::delay_ticks() [ticks].
  SentTorques torques_, speeds_;  ///< Compensation and planned velocity of the last late_ ticks.
  Eigen::VectorXd speed_;         ///< Planned velocity at this tick, nv [rad/s].
};

}  // namespace burnish

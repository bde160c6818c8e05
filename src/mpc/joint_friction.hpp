// Friction in the joints, estimated from the correlation of the model error with joint velocities,
// and its feedforward compensation.
#pragma once

#include <cmath>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "mpc/sent_torques.hpp"

namespace burnish {

/// Per joint a Kalman filter of the observed model error
///   d = c - F s(v) - B v,   s(v) = tanh(v / w),
/// with an offset c that varies fast and Coulomb and viscous friction F, B >= 0 that vary slowly.
/// v is the planned velocity, because encoders do not resolve when a joint reverses: plans are read
/// lead() ahead and smoothed by a filter whose delay cancels that lead. The width w is
/// friction_speed. It grows with the deviation of the measured velocity from v, so that s is the
/// expected sign of an uncertain velocity. Otherwise the compensation would accelerate a light
/// joint that noise moves.
class JointFriction {
 public:
  explicit JointFriction(const MpcSpec& spec);

  void reset() noexcept;
  /// Time after a plan's first knot at which foresee() needs the planned velocity [s].
  double lead() const { return lead_; }
  /// Takes the velocity (nv) of a new plan, lead() after its first knot.
  void foresee(const double* v) noexcept;
  /// Updates torque() for a tick that is dt later [s].
  void advance(double dt) noexcept;
  /// Sets torque() to zero until the next advance().
  void rest() noexcept { torque_.setZero(); }
  /// Updates the estimates with an observer's torque error (nv) and the measured velocity (nv).
  /// The observer has this bandwidth [rad/s] and was given the commands without torque().
  void learn(const Eigen::VectorXd& torque_error, const Eigen::VectorXd& v, double bandwidth,
             double dt) noexcept;

  const Eigen::VectorXd& torque() const { return torque_; }  ///< nv, Nm (N), to be added
  double coulomb(int k) const { return joints_[static_cast<std::size_t>(k)].x[1]; }  ///< F, Nm (N)
  double viscous(int k) const { return joints_[static_cast<std::size_t>(k)].x[2]; }  ///< B, Nms/rad
  /// Standard deviation of the estimated F [Nm (N)].
  double deviation(int k) const { return std::sqrt(joints_[static_cast<std::size_t>(k)].P(1, 1)); }

 private:
  struct Late {  ///< a signal as the observer shows it
    double first = 0.0, second = 0.0;
    double follow(double value, double share) {
      first += share * (value - first);
      return second += share * (first - second);
    }
  };
  struct Joint {
    bool driven = false;
    double prior = 1.0;                          ///< Nm (N), deviation of F at first
    double ahead = 0.0, between = 0.0, v = 0.0;  ///< rad/s: planned, smoothed once and twice
    Late sign, speed, given;
    Late actual, foreseen;  ///< rad/s: measured and planned velocity behind the same filter
    double strays = 0.0;    ///< rad^2/s^2, mean square of their difference
    Eigen::Vector3d x;      ///< c, F, B
    Eigen::Matrix3d P;
    double noise = 0.0;  ///< Nm^2
  };
  double sign_of(const Joint& joint, double v) const noexcept;
  void learn(Joint& joint, double error, double speed, double share, double dt) noexcept;

  bool enabled_;
  ModelErrorOptions options_;
  double lead_, smoothing_;  ///< s
  std::vector<Joint> joints_;
  Eigen::VectorXd torque_;
  int late_;                      ///< ticks that observations are old, from known delays
  SentTorques torques_, speeds_;  ///< nv, Nm (N) and rad/s, of the last late_ ticks
  Eigen::VectorXd speed_;         ///< nv, rad/s
};

}  // namespace burnish

// Friction in the joints, told from how the model error goes with their velocities, and the torque
// that makes up for it.
#pragma once

#include <cmath>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "mpc/sent_torques.hpp"

namespace burnish {

/// Per joint a Kalman filter of the observed model error
///   d = c - F s(v) - B v,   s(v) = tanh(v / w),
/// with a constant c that wanders, and Coulomb's and viscous friction F, B >= 0 that hardly do. v
/// is not measured: encoders do not tell when a joint turns around. It is what plans foresee, a
/// while ahead, smoothed by a filter that is late by the same while. The width w is
/// friction_speed, and more where the joint strays from v: s is then the mean sign of a velocity
/// that is uncertain by as much. Else a light joint, which noise drives, would have a friction
/// that pushes it on.
class JointFriction {
 public:
  explicit JointFriction(const MpcSpec& spec);

  void reset() noexcept;
  /// s after a plan's first knot whose velocity foresee() wants.
  double lead() const { return lead_; }
  /// nv, of a new plan, that time after it begins.
  void foresee(const double* v) noexcept;
  /// dt s later: what is made up for then.
  void advance(double dt) noexcept;
  /// Nothing is made up for until then.
  void rest() noexcept { torque_.setZero(); }
  /// The error that an observer of a bandwidth (rad/s) tells that was given the commands without
  /// torque(), and the measured velocity (nv).
  void learn(const Eigen::VectorXd& torque_error, const Eigen::VectorXd& v, double bandwidth,
             double dt) noexcept;

  const Eigen::VectorXd& torque() const { return torque_; }  ///< nv, Nm (N), to be added
  double coulomb(int k) const { return joints_[static_cast<std::size_t>(k)].x[1]; }  ///< F, Nm (N)
  double viscous(int k) const { return joints_[static_cast<std::size_t>(k)].x[2]; }  ///< B, Nms/rad
  /// Of F, Nm (N).
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
  int late_;                      ///< ticks of known delays: what is observed is of then
  SentTorques torques_, speeds_;  ///< nv, Nm (N) and rad/s, of the last late_ ticks
  Eigen::VectorXd speed_;         ///< nv, rad/s
};

}  // namespace burnish

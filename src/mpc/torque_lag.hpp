// Estimate of the delay from commanded torques to measured torques.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"
#include "estimate/sent_torques.hpp"

namespace burnish {

/// Estimate of the lag of measured torques behind commanded torques, up to 20 ms. It is the delay
/// of the commanded torques for which their mean square difference from the measured torques is
/// smallest. While the torques hardly vary, the estimate is 0.
class TorqueLag {
 public:
  /// `tick_period`: time between ticks [s]. `actuated`: entries of v that have a motor.
  TorqueLag(const Model& model, double tick_period, std::vector<int> actuated);
  void reset() noexcept;
  /// Updates the estimate. `sent`: torque commanded at the previous tick (nv). `measured`: measured
  /// torque (nv), `dt` [s] after the previous measurement.
  void look(const ConstVectorRef& sent, const Eigen::VectorXd& measured, double dt) noexcept;

  /// Returns the lag [s], in steps of about 1 ms; 0 if no lag is visible.
  double seconds() const noexcept { return best_ * step_ * tick_period_; }
  /// Returns the mean torque difference over 30 ms [Nm or N]: commanded torque, delayed by the lag,
  /// minus measured torque.
  double gap(int entry) const noexcept { return gaps_(entry, best_); }

 private:
  static constexpr int lags = 21;  ///< Number of compared lags: 0, 1, ... steps.

  std::vector<int> actuated_;
  Eigen::VectorXd weight_;  ///< Weight of each joint, 1 / (effort limit)^2, nv.
  double tick_period_;
  int step_;  ///< Difference between successive compared lags [ticks].
  SentTorques sent_;
  Eigen::MatrixXd gaps_;  ///< Mean torque difference for each lag, nv x lags [Nm or N].
  /// Weighted sum of squared torque differences for each lag: mean over time, and at this tick.
  Eigen::VectorXd errors_ = Eigen::VectorXd::Zero(lags), now_ = errors_;
  bool started_ = false;
  int best_ = 0;
};

}  // namespace burnish

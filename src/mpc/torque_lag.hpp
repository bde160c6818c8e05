// How late the measured torques follow those that were sent.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "mpc/sent_torques.hpp"

namespace burnish {

/// Finds the lag at which measured torques match those sent up to 20 ms before: the smallest mean
/// square of their differences. It is updated while torques vary enough.
class TorqueLag {
 public:
  /// actuated: entries of v that have a motor.
  TorqueLag(const MpcSpec& spec, std::vector<int> actuated);
  void reset() noexcept;
  /// sent: nv, at the tick before; measured: nv, dt s after the measurement before.
  void look(const ConstVectorRef& sent, const Eigen::VectorXd& measured, double dt) noexcept;

  /// s between sending and measuring a torque, in steps of about 1 ms; 0: none that shows.
  double seconds() const noexcept { return best_ * step_ * tick_period_; }
  /// Nm (N), mean over 30 ms: the torque that was sent, that lag ago, less the measured one.
  double gap(int entry) const noexcept { return gaps_(entry, best_); }

 private:
  static constexpr int lags = 21;  ///< from none on, a step apart

  std::vector<int> actuated_;
  Eigen::VectorXd weight_;  ///< 1 / effort limit^2
  double tick_period_;
  int step_;  ///< ticks
  SentTorques sent_;
  Eigen::MatrixXd gaps_;                                                  ///< nv x lags
  Eigen::VectorXd errors_ = Eigen::VectorXd::Zero(lags), now_ = errors_;  ///< mean squares
  bool started_ = false;
  int best_ = 0;
};

}  // namespace burnish

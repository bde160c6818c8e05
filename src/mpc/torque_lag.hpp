// How late the measured torques follow those that were sent.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Torques that were sent, a column for each tick, up to a time ago.
class SentTorques {
 public:
  /// ticks: how far back, besides the tick before; at least 0.
  SentTorques(Eigen::Index nv, int ticks) : sent_(Eigen::MatrixXd::Zero(nv, ticks + 1)) {}
  void fill(const Eigen::VectorXd& tau) noexcept { sent_.colwise() = tau; }
  void add(const Eigen::VectorXd& tau) noexcept {
    newest_ = (newest_ + 1) % sent_.cols();
    sent_.col(newest_) = tau;
  }
  /// Of the tick before, 0, or of one before that.
  auto ago(int ticks) const noexcept {
    return sent_.col((newest_ + sent_.cols() - ticks) % sent_.cols());
  }

 private:
  Eigen::MatrixXd sent_;  ///< nv x ticks, a ring
  Eigen::Index newest_ = 0;
};

/// Compares measured torques with those that were sent up to 20 ms before. While they move far
/// enough, the lag is the one that explains them best.
class TorqueLag {
 public:
  /// actuated: entries of v that have a motor.
  TorqueLag(const MpcSpec& spec, std::vector<int> actuated);
  void reset() noexcept;
  /// sent: nv, at the tick before; measured: nv, dt s after the measurement before.
  void look(const Eigen::VectorXd& sent, const Eigen::VectorXd& measured, double dt) noexcept;

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

// Torques that were sent, tick by tick.
#pragma once

#include "burnish/base/views.hpp"

namespace burnish {

/// A ring of vectors, one for each tick up to a time ago.
class SentTorques {
 public:
  /// ticks: how far back, besides the tick before; at least 0.
  SentTorques(Eigen::Index nv, int ticks) : sent_(Eigen::MatrixXd::Zero(nv, ticks + 1)) {}
  void fill(const ConstVectorRef& tau) noexcept { sent_.colwise() = tau; }
  void add(const ConstVectorRef& tau) noexcept {
    newest_ = (newest_ + 1) % sent_.cols();
    sent_.col(newest_) = tau;
  }
  /// Of the tick before, 0, or of one before that.
  auto ago(int ticks) const noexcept {
    return sent_.col((newest_ + sent_.cols() - ticks) % sent_.cols());
  }

 private:
  Eigen::MatrixXd sent_;  ///< nv x ticks
  Eigen::Index newest_ = 0;
};

}  // namespace burnish

// Ring buffer of the torques that were sent at past ticks.
#pragma once

#include "burnish/base/views.hpp"

namespace burnish {

/// Ring buffer of vectors. It keeps one vector per tick, up to a given age.
class SentTorques {
 public:
  /// `ticks`: largest age of a kept vector [ticks], at least 0.
  SentTorques(Eigen::Index nv, int ticks) : sent_(Eigen::MatrixXd::Zero(nv, ticks + 1)) {}
  void fill(const ConstVectorRef& tau) noexcept { sent_.colwise() = tau; }
  void add(const ConstVectorRef& tau) noexcept {
    newest_ = (newest_ + 1) % sent_.cols();
    sent_.col(newest_) = tau;
  }
  /// Returns the vector added `ticks` ticks before the newest one; 0: the newest one.
  auto ago(int ticks) const noexcept {
    return sent_.col((newest_ + sent_.cols() - ticks) % sent_.cols());
  }

 private:
  Eigen::MatrixXd sent_;  ///< One column per tick, nv rows.
  Eigen::Index newest_ = 0;
};

}  // namespace burnish

// The mean of a signal about each of its samples.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "burnish/base/abi.hpp"

namespace burnish {

/// Over the samples within half of `width` on either side, fewer at the ends.
inline Eigen::VectorXd moving_mean(const Eigen::VectorXd& x, int width) {
  const int n = static_cast<int>(x.size()), before = width / 2, behind = width - before;
  Eigen::VectorXd result(n);
  // Each sum by itself: differences of running sums would lose the digits of long signals.
  for (int i = 0; i < n; ++i) {
    const int from = std::max(0, i - before), to = std::min(n, std::max(i + behind, i + 1));
    result[i] = x.segment(from, to - from).mean();
  }
  return result;
}

}  // namespace burnish

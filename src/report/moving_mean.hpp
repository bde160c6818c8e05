// Moving mean of a signal.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "burnish/base/views.hpp"

namespace burnish {

/// Returns the mean of `width` samples around each sample of x, or of fewer samples at the ends of
/// x. The computing time is proportional to the length of x, for any width.
inline Eigen::VectorXd moving_mean(const Eigen::VectorXd& x, int width) {
  const Eigen::Index n = x.size(), w = std::max(1, width), before = w / 2;
  // Sums from each sample to both ends of its block of w samples. A window covers parts of at most
  // two blocks, so the sum of the window is a sum of at most two of these numbers. Differences of
  // running sums would lose digits in long signals.
  Eigen::VectorXd from_start(n), to_end(n), result(n);
  for (Eigen::Index begin = 0; begin < n; begin += w) {
    const Eigen::Index end = std::min(n, begin + w);
    double sum = 0.0;
    for (Eigen::Index i = begin; i < end; ++i) from_start[i] = sum += x[i];
    sum = 0.0;
    for (Eigen::Index i = end - 1; i >= begin; --i) to_end[i] = sum += x[i];
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - before);
    const Eigen::Index last = std::min(n, i - before + w) - 1;
    const bool starts_block = from % w == 0;  // the block may end after the window
    const bool in_one = from / w == last / w;
    const double sum = !in_one        ? to_end[from] + from_start[last]
                       : starts_block ? from_start[last]
                                      : to_end[from];
    result[i] = sum / static_cast<double>(last - from + 1);
  }
  return result;
}

/// Returns the number of samples, at least 1, in a mean over `time` [s]. The time between samples
/// is `step` [s].
inline int samples_in(double time, double step) {
  return static_cast<int>(std::clamp(std::round(time / step), 1.0, 1e9));
}

}  // namespace burnish

// The mean of a signal about each of its samples.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "burnish/base/views.hpp"

namespace burnish {

/// Over the samples within half of `width` on either side, fewer at the ends. Takes time as the
/// signal's length, whatever the width.
inline Eigen::VectorXd moving_mean(const Eigen::VectorXd& x, int width) {
  const Eigen::Index n = x.size(), w = std::max(1, width), before = w / 2;
  // Sums from each sample to both ends of its block of w samples. A window reaches into two blocks
  // at most, so that it is a sum of two of them: differences of running sums would lose the digits
  // of long signals.
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
    const bool starts_block = from % w == 0;  // its end may lie beyond the window's
    const bool in_one = from / w == last / w;
    const double sum = !in_one        ? to_end[from] + from_start[last]
                       : starts_block ? from_start[last]
                                      : to_end[from];
    result[i] = sum / static_cast<double>(last - from + 1);
  }
  return result;
}

/// Samples that a mean over `time` (s) is of, where they are `step` (s) apart; one at least.
inline int samples_in(double time, double step) {
  return static_cast<int>(std::clamp(std::round(time / step), 1.0, 1e9));
}

}  // namespace burnish

// Touch and loss of contact, told from the noise of a force sensor.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// The median of sizes that come one by one, until there are as many as it has room for. A few that
/// do not belong to the others do not move it. Allocates when it is made.
class RunningMedian {
 public:
  explicit RunningMedian(std::size_t room) { sorted_.reserve(room); }
  void clear() noexcept { sorted_.clear(); }
  void add(double size) noexcept;
  std::size_t count() const noexcept { return sorted_.size(); }
  double value() const noexcept { return sorted_.empty() ? 0.0 : sorted_[sorted_.size() / 2]; }

 private:
  std::vector<double> sorted_;
};

/// Reads the force along a surface's normal, sample by sample. In the air it finds out how far the
/// force strays by itself, and what counts as contact has to stand out from that:
/// - with a quiet sensor (the threshold is above six deviations of a sample) one sample is enough,
/// - with a noisy one it is the mean over a window that counts, against the threshold or six
///   deviations of such means, whichever is larger,
/// - as long as the noise is not known, all samples of a window have to be above the threshold.
class ContactDetector {
 public:
  /// threshold: N that count as contact; window: samples, at least 1.
  ContactDetector(double threshold, int window);

  void reset() noexcept;
  /// force: N; in_air: nothing should touch, so that what is felt is noise. Allocates nothing.
  void add(double force, bool in_air) noexcept;

  bool touches() const noexcept;
  /// Whether there is no contact where `wanted` N are asked for: half of them is never noise.
  bool is_lost(double wanted) const noexcept;
  /// What a mean over `samples` samples may not exceed without being a force: `limit`, or more
  /// where noise reaches that far. N.
  double above_noise(double limit, int samples) const noexcept;
  bool knows_noise() const noexcept;
  /// N: what is compared with needed(), the newest sample or a mean.
  double felt() const noexcept { return !knows_noise() || is_quiet() ? last_ : mean_; }
  double needed() const noexcept;  ///< least force that counts as contact [N]

 private:
  double deviation() const noexcept;       ///< N, of a sample
  double mean_deviation() const noexcept;  ///< N, of a mean over the window
  bool is_quiet() const noexcept;
  void learn(double force) noexcept;

  double threshold_;
  Eigen::VectorXd window_;  ///< a ring of samples
  long count_ = 0;
  double mean_ = 0.0, last_ = 0.0;  ///< N, over the window, and its newest sample
  // Of the samples in the air, block by block.
  Eigen::Index in_block_ = 0;
  double block_sum_ = 0.0, first_ = 0.0;
  std::array<double, 4> block_means_{};  ///< a ring, N
  std::size_t blocks_ = 0;
  RunningMedian sample_strays_, mean_strays_;  ///< N, from some blocks before
};

}  // namespace burnish

// Detects touch and loss of contact in the noisy signal of a force sensor.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// Running median of the first `capacity` values that are added; later values are ignored. Only the
/// constructor allocates.
class RunningMedian {
 public:
  explicit RunningMedian(std::size_t capacity) { sorted_.reserve(capacity); }
  void clear() noexcept { sorted_.clear(); }
  void add(double size) noexcept;
  std::size_t count() const noexcept { return sorted_.size(); }
  double value() const noexcept { return sorted_.empty() ? 0.0 : sorted_[sorted_.size() / 2]; }

 private:
  std::vector<double> sorted_;
};

/// Detector of contact from samples of the force along a surface's normal. While the tool is in the
/// air, the detector estimates the noise of the sensor. The condition for contact depends on this
/// noise:
/// - Quiet sensor (six standard deviations of a sample are below the threshold): one sample must
///   exceed the threshold.
/// - Noisy sensor: the mean over a window must exceed the threshold and six standard deviations of
///   such means.
/// - Noise not yet estimated: all samples of a window must exceed the threshold.
class ContactDetector {
 public:
  /// `threshold`: force that counts as contact [N]. `window`: number of samples, at least 1.
  ContactDetector(double threshold, int window);

  void reset() noexcept;
  /// Adds a sample `force` [N]. `in_air`: true if the tool should not touch, so that the sample is
  /// only noise. Does not allocate.
  void add(double force, bool in_air) noexcept;

  bool touches() const noexcept;
  /// Returns whether contact is lost while the controller commands the force `wanted` [N]. A force
  /// of half of `wanted` or more always counts as contact.
  bool is_lost(double wanted) const noexcept;
  /// Returns the largest mean of `samples` samples that noise alone can cause, but at least `limit`
  /// [N]. Returns `limit` if the noise is not yet estimated.
  double above_noise(double limit, int samples) const noexcept;
  bool knows_noise() const noexcept;  ///< Whether the noise has been estimated.
  /// Force to compare with needed(): the mean if the sensor is noisy, else the newest sample [N].
  double felt() const noexcept { return !knows_noise() || is_quiet() ? last_ : mean_; }
  double needed() const noexcept;  ///< Smallest force that counts as contact [N].

 private:
  double deviation() const noexcept;       ///< Standard deviation of a sample [N].
  double mean_deviation() const noexcept;  ///< Standard deviation of a mean over the window [N].
  bool is_quiet() const noexcept;
  void add_noise(double force) noexcept;

  double threshold_;
  Eigen::VectorXd window_;  ///< Ring buffer of samples [N].
  long count_ = 0;
  double mean_ = 0.0, last_ = 0.0;  ///< Mean over the window and newest sample [N].
  // Statistics of the samples in the air. A block has as many samples as the window.
  Eigen::Index in_block_ = 0;
  double block_sum_ = 0.0, first_ = 0.0;
  std::array<double, 4> block_means_{};  ///< Ring buffer of the means of blocks [N].
  std::size_t blocks_ = 0;
  /// Running medians of absolute deviations from the mean of the block four blocks earlier [N]:
  /// deviations of a block's first sample (sample_strays_) and of a block's mean (mean_strays_).
  RunningMedian sample_strays_, mean_strays_;
};

}  // namespace burnish

#include "estimate/contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burnish {
namespace {

// All values were chosen by hand, except the median.
constexpr double deviations = 6.0;  // multiple of the standard deviation that noise does not reach
constexpr double median_of_normal = 0.6745;  // median of |x| for a standard normal x
constexpr std::size_t min_blocks = 8;        // smallest number of blocks for an estimate of noise
constexpr std::size_t max_blocks = 200;      // largest number of blocks in the estimate of noise

}  // namespace

void RunningMedian::add(double size) noexcept {
  if (sorted_.size() == sorted_.capacity() || !std::isfinite(size)) return;
  sorted_.insert(std::upper_bound(sorted_.begin(), sorted_.end(), size), size);
}

ContactDetector::ContactDetector(double threshold, int window)
    : threshold_(threshold),
      window_(Eigen::VectorXd::Zero(std::max(1, window))),
      sample_strays_(max_blocks),
      mean_strays_(max_blocks) {}

void ContactDetector::reset() noexcept {
  count_ = 0;
  mean_ = last_ = block_sum_ = first_ = 0.0;
  in_block_ = 0;
  blocks_ = 0;
  sample_strays_.clear();
  mean_strays_.clear();
}

void ContactDetector::add(double force, bool in_air) noexcept {
  window_[count_++ % window_.size()] = force;
  const Eigen::Index filled = std::min<Eigen::Index>(count_, window_.size());
  mean_ = window_.head(filled).mean();
  last_ = force;
  if (in_air) add_noise(force);
}

/// Adds a sample that was taken while the tool is in the air. Compares each complete block of
/// samples with the block four blocks earlier. An offset of the sensor then cancels, and the
/// sensor's filter does not correlate the two blocks. Medians of the differences ignore a short
/// touch.
void ContactDetector::add_noise(double force) noexcept {
  if (in_block_ == 0) first_ = force;
  block_sum_ += force;
  if (++in_block_ < window_.size()) return;
  const double mean = block_sum_ / static_cast<double>(window_.size());
  double& before = block_means_[blocks_ % block_means_.size()];
  if (blocks_++ >= block_means_.size()) {
    sample_strays_.add(std::abs(first_ - before));
    mean_strays_.add(std::abs(mean - before));
  }
  before = mean;
  block_sum_ = 0.0;
  in_block_ = 0;
}

bool ContactDetector::knows_noise() const noexcept { return mean_strays_.count() >= min_blocks; }

double ContactDetector::deviation() const noexcept {
  return sample_strays_.value() / median_of_normal;
}
double ContactDetector::mean_deviation() const noexcept {
  return mean_strays_.value() / (median_of_normal * std::numbers::sqrt2);
}

bool ContactDetector::is_quiet() const noexcept { return deviations * deviation() <= threshold_; }

double ContactDetector::needed() const noexcept {
  return !knows_noise() || is_quiet() ? threshold_
                                      : std::max(threshold_, deviations * mean_deviation());
}

bool ContactDetector::touches() const noexcept {
  if (!knows_noise()) return count_ >= window_.size() && window_.minCoeff() > threshold_;
  return (is_quiet() || count_ >= window_.size()) && felt() > needed();
}

bool ContactDetector::is_lost(double wanted) const noexcept {
  if (!knows_noise() || is_quiet()) return last_ < threshold_;
  const double min_force = std::min(deviations * mean_deviation(), 0.5 * wanted);
  return mean_ < std::max(threshold_, min_force);
}

double ContactDetector::above_noise(double limit, int samples) const noexcept {
  if (!knows_noise()) return limit;
  // Standard deviation of the mean of `samples` samples of white noise [N].
  const double shorter = deviation() / std::sqrt(static_cast<double>(std::max(1, samples)));
  const double strays =
      samples < window_.size() ? std::max(mean_deviation(), shorter) : mean_deviation();
  return std::max(limit, deviations * strays);
}

}  // namespace burnish

#include "identify/signal_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/to_size.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double deviations = 8.0;       // Robust standard deviations that a sudden step exceeds
constexpr double of_usual_steps = 2.0;   // Factor on the 95th percentile; see sudden_steps()
constexpr double mad_to_sigma = 1.4826;  // sigma / (median absolute deviation), if normal
constexpr Eigen::Index max_outlier = 5;  // Longest outlier [samples]

double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[to_size(at)];
}

/// Returns the median of up to eight neighbouring steps, four before and four after step i.
double usual_step(const Eigen::VectorXd& step, Eigen::Index i) {
  std::array<double, 8> near{};
  std::size_t count = 0;
  for (Eigen::Index k = std::max<Eigen::Index>(0, i - 4); k <= std::min(step.size() - 1, i + 4);
       ++k)
    if (k != i) near[count++] = step[k];
  std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count));
  return count == 0 ? 0.0 : 0.5 * (near[(count - 1) / 2] + near[count / 2]);
}

}  // namespace

double quantum_of(const Eigen::VectorXd& signal) {
  double quantum = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 1; i < signal.size(); ++i)
    if (const double step = std::abs(signal[i] - signal[i - 1]); step > 0.0)
      quantum = std::min(quantum, step);
  return std::isfinite(quantum) ? quantum : 0.0;
}

Steps sudden_steps(const Eigen::VectorXd& signal) {
  Steps result;
  const Eigen::Index n = signal.size();
  if (n < 10) return result;
  const Eigen::VectorXd step = signal.tail(n - 1) - signal.head(n - 1);
  Eigen::VectorXd beyond(n - 1);
  for (Eigen::Index i = 0; i < n - 1; ++i) beyond[i] = step[i] - usual_step(step, i);
  std::vector<double> of_beyond, of_step;
  const double quantum = quantum_of(signal);
  for (Eigen::Index i = 0; i < n - 1; ++i) {
    of_beyond.push_back(std::abs(beyond[i]));
    of_step.push_back(std::abs(step[i]));
  }
  if (quantum == 0.0) return result;
  const double sigma = mad_to_sigma * quantile(of_beyond, 0.5);
  result.tolerance =
      deviations * std::max(sigma, quantum) + of_usual_steps * quantile(of_step, 0.95);
  for (Eigen::Index i = 0; i < n - 1; ++i)
    if (std::abs(beyond[i]) > result.tolerance) result.sudden.push_back({i + 1, beyond[i]});
  return result;
}

std::vector<Outlier> take_outliers(Steps& steps) {
  std::vector<Outlier> result;
  std::vector<SuddenStep> left;
  const std::vector<SuddenStep>& all = steps.sudden;
  for (std::size_t i = 0; i < all.size(); ++i) {
    double sum = 0.0, largest = 0.0;
    std::size_t last = i;
    for (std::size_t j = i; j < all.size() && all[j].at - all[i].at <= max_outlier; ++j) {
      sum += all[j].size;
      if (j > i && std::abs(sum) <= std::max(steps.tolerance, 0.1 * largest)) {
        last = j;
        break;
      }
      largest = std::max(largest, std::abs(sum));
    }
    if (last == i) {
      left.push_back(all[i]);
      continue;
    }
    result.push_back({all[i].at, all[last].at - all[i].at, largest});
    i = last;
  }
  steps.sudden = left;
  return result;
}

void bridge(Eigen::VectorXd& signal, const Outlier& outlier) {
  const Eigen::Index first = outlier.at, after = outlier.at + outlier.count;
  const std::array<Eigen::Index, 4> wanted{first - 2, first - 1, after, after + 1};
  std::vector<Eigen::Index> nodes;
  for (const Eigen::Index node : wanted)
    if (node >= 0 && node < signal.size()) nodes.push_back(node);
  for (Eigen::Index i = first; i < after; ++i) {
    double value = 0.0;
    for (const Eigen::Index a : nodes) {
      double weight = 1.0;
      for (const Eigen::Index b : nodes)
        if (a != b) weight *= static_cast<double>(i - b) / static_cast<double>(a - b);
      value += weight * signal[a];
    }
    signal[i] = value;
  }
}

double white_noise(const Eigen::VectorXd& signal) {
  // Error of the cubic through the four neighbours of each sample. Its variance is 1 + 34/36 times
  // the variance of the white noise.
  const Eigen::Index n = signal.size();
  if (n < 5) return 0.0;
  const Eigen::VectorXd error =
      signal.segment(2, n - 4) - (4.0 * (signal.segment(1, n - 4) + signal.segment(3, n - 4)) -
                                  signal.head(n - 4) - signal.tail(n - 4)) /
                                     6.0;
  return std::sqrt(error.squaredNorm() / static_cast<double>(n - 4) / (1.0 + 34.0 / 36.0));
}

Run longest_run(const Eigen::VectorXd& signal) {
  Run best, now{0, 1};
  for (Eigen::Index i = 1; i <= signal.size(); ++i) {
    if (i < signal.size() && signal[i] == signal[i - 1]) {
      ++now.count;
      continue;
    }
    if (now.count > best.count) best = now;
    now = {i, 1};
  }
  return best;
}

}  // namespace burnish::identify_detail

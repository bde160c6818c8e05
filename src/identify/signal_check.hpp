// Steps of a sampled signal that its neighbours do not explain.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace burnish::identify_detail {

/// A step from sample `at - 1` to sample `at` beyond what steps around it let expect.
struct SuddenStep {
  Eigen::Index at = 0;
  double size = 0.0;  ///< beyond the median of its neighbours
};

/// Outliers that stand alone: the signal leaves and is back after `count` samples.
struct Outlier {
  Eigen::Index at = 0, count = 0;
  double size = 0.0;  ///< largest distance from the signal around it
};

struct Steps {
  std::vector<SuddenStep> sudden;  ///< ascending
  double tolerance = 0.0;          ///< size above which a step is sudden
};

/// The smallest step between neighbours, as a converter makes them; 0 of a constant.
double quantum_of(const Eigen::VectorXd& signal);

/// A step is sudden when it stands out by eight robust deviations (and eight quanta of the
/// converter) plus twice the 95th percentile of all steps. A normal distribution exceeds eight
/// deviations once in 1e15 samples.
Steps sudden_steps(const Eigen::VectorXd& signal);

/// Removes the outliers from `steps`: pairs or groups of steps within five samples whose sum is
/// small beside them.
std::vector<Outlier> take_outliers(Steps& steps);

/// Replaces an outlier by the cubic through two samples before and two after it.
void bridge(Eigen::VectorXd& signal, const Outlier& outlier);

/// Deviation of white noise on a signal that is smooth over five samples.
double white_noise(const Eigen::VectorXd& signal);

/// The longest run of equal samples: its first sample and its length.
struct Run {
  Eigen::Index at = 0, count = 0;
};
Run longest_run(const Eigen::VectorXd& signal);

}  // namespace burnish::identify_detail

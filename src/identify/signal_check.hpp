// Detection of sudden steps and outliers in sampled signals.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace burnish::identify_detail {

/// Step from sample `at - 1` to sample `at` that differs strongly from the steps around it.
struct SuddenStep {
  Eigen::Index at = 0;
  double size = 0.0;  ///< Step minus the median of the neighbouring steps
};

/// Outlier: the signal jumps at sample `at`, and jumps back after `count` samples.
struct Outlier {
  Eigen::Index at = 0, count = 0;
  double size = 0.0;  ///< Largest distance from the signal around the outlier
};

struct Steps {
  std::vector<SuddenStep> sudden;  ///< Sudden steps, in the order of time
  double tolerance = 0.0;          ///< Size above which a step is sudden
};

/// Returns the smallest step between neighbouring samples, the resolution of a converter; 0 for a
/// constant.
double quantum_of(const Eigen::VectorXd& signal);

/// Finds sudden steps, whose difference from the median of their neighbours exceeds a tolerance.
/// The tolerance is eight robust standard deviations (at least eight quanta of the converter) plus
/// twice the 95th percentile of all steps. A normal distribution exceeds eight standard deviations
/// once in 1e15 samples.
Steps sudden_steps(const Eigen::VectorXd& signal);

/// Removes the outliers from `steps` and returns them: groups of steps within five samples whose
/// sum is small compared with the steps.
std::vector<Outlier> take_outliers(Steps& steps);

/// Replaces an outlier by the cubic through two samples before and two samples after it.
void bridge(Eigen::VectorXd& signal, const Outlier& outlier);

/// Returns the standard deviation of white noise on a signal that is smooth over five samples.
double white_noise(const Eigen::VectorXd& signal);

/// Longest run of equal samples: first sample and length.
struct Run {
  Eigen::Index at = 0, count = 0;
};
Run longest_run(const Eigen::VectorXd& signal);

}  // namespace burnish::identify_detail

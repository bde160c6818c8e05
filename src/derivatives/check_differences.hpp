// Derivatives from values alone.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// Values (m entries) after entry k of an argument has moved by h. NaN where there are none.
using MovedValues = std::function<Eigen::VectorXd(int k, double h)>;

/// The same of all entries at once, each by h alone: m x n, a column per entry.
using AllMovedValues = std::function<Eigen::MatrixXd(double h)>;

/// m x n central differences with one step: exact for quadratic functions.
Eigen::MatrixXd central_differences(const MovedValues& values, int n, double step);
Eigen::MatrixXd central_differences(const AllMovedValues& values, double step);

/// Rows of one unit.
struct DifferenceGroup {
  int rows;
  double noise = 0.0;  ///< what rounding leaves uncertain in any case: no step is tried for less
};

/// m x n: per entry the best of several extrapolations of central differences, by the estimate of
/// its own error (C. Ridders, Accurate computation of F'(x), 1982). Smaller steps are tried only
/// while the estimate exceeds `wanted`, relative to the largest entry of a group of rows, and the
/// group's noise. Rows behind the last group are one more. With `finer` below 1 all steps are that
/// part of what they are.
Eigen::MatrixXd extrapolated_differences(const AllMovedValues& values,
                                         const std::vector<DifferenceGroup>& groups,
                                         double wanted = 1e-9, double finer = 1.0);
/// With two groups, of which the first has `split` rows.
Eigen::MatrixXd extrapolated_differences(const MovedValues& values, int n, int split,
                                         double wanted = 1e-9);

/// The smallest step that those take, in units of what is moved.
inline constexpr double smallest_difference = 0.0002 / 4.0;

}  // namespace burnish

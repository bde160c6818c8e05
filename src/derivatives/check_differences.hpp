// Derivatives by finite differences.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "burnish/base/views.hpp"

namespace burnish {

/// Function that returns m values after entry k of the argument has moved by h; NaN if undefined.
using MovedValues = std::function<Eigen::VectorXd(int k, double h)>;

/// Function that returns an m x n matrix; column k holds the values after entry k moved by h.
using AllMovedValues = std::function<Eigen::MatrixXd(double h)>;

/// Computes m x n central differences with one step. They are exact for quadratic functions.
Eigen::MatrixXd central_differences(const MovedValues& values, int n, double step);
Eigen::MatrixXd central_differences(const AllMovedValues& values, double step);

/// Group of consecutive rows with the same unit.
struct DifferenceGroup {
  int rows;            ///< Number of rows
  double noise = 0.0;  ///< Rounding error of differences; smaller steps cannot reduce it
};

/// Computes m x n derivatives by extrapolation of central differences. Each entry comes from the
/// steps with the smallest estimated error (C. Ridders, Accurate computation of F'(x), 1982).
///
/// Tries smaller steps until the estimated error of each group is at most its noise or `wanted`
/// times its largest entry. Rows after the last group form a group of their own. `finer` scales all
/// steps.
Eigen::MatrixXd extrapolated_differences(const AllMovedValues& values,
                                         const std::vector<DifferenceGroup>& groups,
                                         double wanted = 1e-9, double finer = 1.0);
/// Overload with two groups; the first has `split` rows.
Eigen::MatrixXd extrapolated_differences(const MovedValues& values, int n, int split,
                                         double wanted = 1e-9);

/// Smallest step of extrapolated_differences(), in units of the argument; chosen by hand.
inline constexpr double smallest_difference = 0.0002 / 4.0;

}  // namespace burnish

// Derivatives from values alone.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "burnish/base/abi.hpp"

namespace burnish {

/// Values (m entries) after entry k of an argument has moved by h. NaN where there are none.
using MovedValues = std::function<Eigen::VectorXd(int k, double h)>;

/// m x n central differences with one step: exact for quadratic functions.
Eigen::MatrixXd central_differences(const MovedValues& values, int n, double step);

/// m x n: per entry the best of several extrapolations of central differences, by the estimate of
/// its own error (C. Ridders, Accurate computation of F'(x), 1982). Smaller steps are tried only
/// while the estimate exceeds `wanted`, relative to the largest entry among the first `split` rows
/// and among the others.
Eigen::MatrixXd extrapolated_differences(const MovedValues& values, int n, int split,
                                         double wanted = 1e-9);

}  // namespace burnish

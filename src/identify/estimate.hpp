// Solver for the regression of identify().
#pragma once

#include "identify/regression.hpp"

namespace burnish::identify_detail {

struct Fit {
  Eigen::VectorXd x;
  Eigen::VectorXd weight;  ///< Weight of each row
  Eigen::MatrixXd covariance;
  Eigen::VectorXd rms_before, rms_after;  ///< Rms of residuals, nv entries each [Nm, N]
  bool converged = false;
};

/// Returns the most probable x (Levenberg-Marquardt method) and its covariance, for noise with the
/// autocorrelation of the residuals.
Fit fit(const Regression& regression);
/// Adds two systematic errors of x to its covariance. The error from smoothing the motion is
/// `fraction` times the difference between the solutions for `longer` and `regression`. The second
/// error comes from holding torques over a sampling period.
void add_bias(const Regression& regression, const Regression& longer, double fraction, Fit& fit);

/// Adds to the covariance the error from residuals that noise does not explain. Each parameter in
/// turn is assumed to cause all residuals.
void add_misfit(const Regression& regression, Fit& fit);

}  // namespace burnish::identify_detail

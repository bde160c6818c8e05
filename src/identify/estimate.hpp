// The solution of the regression.
#pragma once

#include "identify/regression.hpp"

namespace burnish::identify_detail {

struct Fit {
  Eigen::VectorXd x;
  Eigen::VectorXd weight;  ///< of each row
  Eigen::MatrixXd covariance;
  Eigen::VectorXd rms_before, rms_after;  ///< nv
  bool converged = false;
};

/// The most probable x, by Levenberg's and Marquardt's method, and its covariance with noise that
/// is coloured as the residuals are.
Fit fit(const Regression& regression);
/// Adds what x is off, as deviations, since motions are smoothed, which is `share` of what `longer`
/// would move it by, and since torques are held from sample to sample.
void add_bias(const Regression& regression, const Regression& longer, double share, Fit& fit);

/// Adds what the fit may have taken from a residual that noise does not explain, as if it were as
/// large as what is left and lay along each parameter.
void add_misfit(const Regression& regression, Fit& fit);

}  // namespace burnish::identify_detail

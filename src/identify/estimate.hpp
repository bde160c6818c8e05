// The regression that identify() solves, and its solution.
#pragma once

#include "identify/log_cholesky.hpp"
#include "identify/smoothed_motion.hpp"

namespace burnish::identify_detail {

/// A mass distribution that is wanted, and what is believed before the motion is seen: its
/// log-Cholesky coordinates are normally distributed about eta.
struct Unknown {
  std::string frame;
  int body;
  Matrix10 to_body;  ///< parameters in the frame's axes -> in the body's
  Vector10 eta, sigma;
  bool replaces = false;  ///< the body's own, which is not added to it
};

/// Smoothed torques = known + sum of Y_i theta_i(eta_i) + linear x, a row per sample and entry of
/// v, samples being the outer index. Unknowns x: eta of each inertia, then the linear ones.
struct Regression {
  Regression(const Model& model, const SmoothedMotion& motion, const std::vector<Unknown>& unknowns,
             const IdentificationSpec& spec);

  int nv = 0, samples = 0, inertias = 0;
  int lags = 0;  ///< samples that residuals may be correlated over
  double samples_per_window = 1.0;
  Eigen::VectorXd rest;    ///< torques less what is known of them
  Eigen::VectorXd before;  ///< torques less what the model as given says
  Eigen::MatrixXd Y;       ///< 10 columns per inertia, of parameters in its frame
  Eigen::MatrixXd linear;
  int viscous = -1, coulomb = -1, offset = -1, delay = -1;  ///< first entries in x
  Eigen::VectorXd prior, prior_sigma;                       ///< of x

  int size() const { return static_cast<int>(prior.size()); }
  /// rest - model(x), and d(model)/dx.
  Eigen::VectorXd residual(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd derivative(const Eigen::VectorXd& x) const;
};

struct Fit {
  Eigen::VectorXd x;
  Eigen::MatrixXd covariance;
  Eigen::VectorXd rms_before, rms_after;  ///< nv
  bool converged = false;
};

/// The most probable x, by Levenberg's and Marquardt's method, and its covariance with noise that
/// is coloured as the residuals are.
Fit fit(const Regression& regression);

}  // namespace burnish::identify_detail

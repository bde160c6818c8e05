// Regression of identify(): fits torques by terms that are linear in the unknowns. Torques and
// terms are smoothed by the same window.
#pragma once

#include <span>

#include "identify/log_cholesky.hpp"
#include "identify/smoothed_motion.hpp"

namespace burnish::identify_detail {

/// Unknown mass distribution and its prior: the log-Cholesky coordinates are normally distributed
/// about `eta` with standard deviations `sigma`.
struct Unknown {
  std::string frame;
  int body;
  Matrix10 to_body;  ///< Transform of parameters from the frame's to the body's axes
  Vector10 eta, sigma;
  bool replaces = false;  ///< Replaces the body's own inertia instead of adding to it
};

/// Layout of x: eta of each inertia, then the linear unknowns. Members such as `viscous` are first
/// indices in x, or -1 if their unknowns are not estimated.
struct Layout {
  Layout(int number, int nv, const IdentificationSpec& spec);
  int inertias, size;
  int viscous, coulomb, armature, offset, delay;
  int linear() const { return size - 10 * inertias; }
};

/// Returns the number of instants between the windows of two rows.
int row_stride(const Windows& windows);

/// Regression with one row per sample and entry of v, sorted by sample first:
///   torques = nominal + sum of Y_i theta_i(eta_i) + linear * (rest of x) + delay^2 * second,
/// with parameters theta_i and log-Cholesky coordinates eta_i of inertia i. All terms are smoothed
/// by the same window, which keeps the equation exact. Only Y has errors from the smoothed motion.
struct Regression {
  Regression(const Model& model, const SmoothedMotion& motion, const Windows& windows,
             std::span<const Unknown> unknowns, const IdentificationSpec& spec);

  Layout layout;
  int nv = 0, samples = 0;
  double samples_per_window = 1.0;
  Eigen::VectorXd measured;  ///< Measured torques
  Eigen::VectorXd rest;      ///< Measured torques minus the nominal torques that x does not replace
  Eigen::VectorXd before;    ///< Measured torques minus the torques of the nominal model
  Eigen::MatrixXd Y;         ///< Regressor: 10 columns per inertia, for parameters in its frame
  Eigen::MatrixXd linear;
  Eigen::VectorXd second;              ///< Coefficients of the squared delay
  Eigen::VectorXd held;                ///< Error from holding a torque over a sampling period
  Eigen::VectorXd prior, prior_sigma;  ///< Prior mean and standard deviation of x

  int size() const { return layout.size; }
  /// Return rest - model(x), and d(model)/dx.
  Eigen::VectorXd residual(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd derivative(const Eigen::VectorXd& x) const;

 private:
  void set_prior(std::span<const Unknown> unknowns, const Model& model);
  void take(const Eigen::MatrixXd& terms, double period);
};

}  // namespace burnish::identify_detail

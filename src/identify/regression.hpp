// The regression that identify() solves: torques against what is linear in the unknowns, both
// smoothed alike.
#pragma once

#include <span>

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

/// Where x has what: eta of each inertia, then the linear ones; -1 of what is not wanted.
struct Layout {
  Layout(int number, int nv, const IdentificationSpec& spec);
  int inertias, size;
  int viscous, coulomb, armature, offset, delay;
  int linear() const { return size - 10 * inertias; }
};

/// Instants from one row's window to the next one's.
int row_stride(const Windows& windows);

/// Torques = known + sum of Y_i theta_i(eta_i) + linear x + delay^2 bend, a row per sample and
/// entry of v, samples being the outer index. All of it is linear in the torques and their
/// derivatives, in Y and in the other columns, so that smoothing it takes nothing from its truth:
/// only Y is as good as the motion that it is made of.
struct Regression {
  Regression(const Model& model, const SmoothedMotion& motion, const Windows& windows,
             std::span<const Unknown> unknowns, const IdentificationSpec& spec);

  Layout layout;
  int nv = 0, samples = 0;
  double samples_per_window = 1.0;
  Eigen::VectorXd measured;  ///< torques
  Eigen::VectorXd rest;      ///< torques less what is known of them
  Eigen::VectorXd before;    ///< torques less what the model as given says
  Eigen::MatrixXd Y;         ///< 10 columns per inertia, of parameters in its frame
  Eigen::MatrixXd linear;
  Eigen::VectorXd bend;                ///< of the delay's square
  Eigen::VectorXd held;                ///< what a torque that is held over a period differs by
  Eigen::VectorXd prior, prior_sigma;  ///< of x

  int size() const { return layout.size; }
  /// rest - model(x), and d(model)/dx.
  Eigen::VectorXd residual(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd derivative(const Eigen::VectorXd& x) const;

 private:
  void believe(std::span<const Unknown> unknowns, const Model& model);
  void take(const Eigen::MatrixXd& terms, double period);
};

}  // namespace burnish::identify_detail

// Residual of a fit compared with the residual that noise explains.
#pragma once

#include "identify/estimate.hpp"
#include "identify/smoothed_motion.hpp"

namespace burnish::identify_detail {

/// Returns the weights of the record's samples in one row of the regression. `order`: order of the
/// time derivative with which the signal enters the regression.
Eigen::VectorXd kernel(const Windows& windows, int order);

/// A motion record and its regressions.
struct Evidence {
  const Model& model;
  const MotionRecord& record;
  const Windows& windows;
  const Regression& regression;
  const Regression& longer;  ///< Regression over longer motion windows
  double fraction;           ///< (smoothing error) / (difference of `longer` and `regression`)
  double torque_noise;       ///< Given noise of each sample; 0: estimated from the record [Nm, N]
};

/// Returns the rms residual that a correct model would have, one entry per torque (nv) [Nm, N]. Its
/// causes are the smoothed noise of torques and positions, and errors from smoothing and sampling.
Eigen::VectorXd expected_rms(const Evidence& of, const Eigen::VectorXd& x);

struct Misfit {
  Eigen::VectorXd ratio;     ///< Rms of the residual divided by the expected rms, nv entries
  int joint = 0;             ///< Entry of v with the largest ratio
  double unexplained = 0.0;  ///< Rms of the residual over rms of the torques of the unknown masses
  bool is_suspicious = false;
  /// Returns whether the residual of a torque is larger than noise explains.
  bool is_suspicious_at(int entry_of_v) const;
};
Misfit misfit_of(const Regression& regression, const Fit& fit, const Eigen::VectorXd& expected);

}  // namespace burnish::identify_detail

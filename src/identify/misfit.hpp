// What a fit leaves unexplained, beside what noise explains.
#pragma once

#include "identify/estimate.hpp"
#include "identify/smoothed_motion.hpp"

namespace burnish::identify_detail {

/// Weights of the record's samples in one row of the regression, for a derivative of that order.
Eigen::VectorXd kernel(const Windows& windows, int order);

/// A record and the regressions that were made of it.
struct Evidence {
  const Model& model;
  const MotionRecord& record;
  const Windows& windows;
  const Regression& regression;
  const Regression& longer;  ///< over motion windows that are longer
  double share;              ///< of the difference to `longer` that smoothing takes
  double torque_noise;       ///< stated for each sample; 0: taken from the record [Nm, N]
};

/// Rms per torque (nv) that a fit leaves where the model is right: white noise of torques and
/// positions, smoothed as the regression smooths them, and what smoothing and sampling take [Nm,
/// N].
Eigen::VectorXd expected_rms(const Evidence& of, const Eigen::VectorXd& x);

struct Misfit {
  Eigen::VectorXd ratio;     ///< nv, of what is left to what noise explains
  int joint = 0;             ///< entry of v with the largest ratio
  double unexplained = 0.0;  ///< rms of what is left over rms of what the unknown masses do
  bool is_suspicious = false;
  /// Whether noise does not explain what is left of a torque.
  bool is_suspicious_at(int entry_of_v) const;
};
Misfit misfit_of(const Regression& regression, const Fit& fit, const Eigen::VectorXd& expected);

}  // namespace burnish::identify_detail

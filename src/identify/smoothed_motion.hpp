// Smoothed record: positions, velocities, accelerations and torques at instants whose distances are
// much smaller than a window.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// Window lengths. The shorter motion window differentiates the motion; the longer one serves only
/// to estimate the error of the shorter one. A third window smooths torques and the terms of the
/// regression.
struct Windows {
  /// Throws Error under the same conditions as identify().
  Windows(const Model& model, const MotionRecord& record, const IdentificationSpec& spec);

  /// Returns windows with fewer instants, for searches that do not need full precision. The half
  /// length `torque` becomes about 16 instants.
  Windows coarse() const;

  int motion = 0, longer = 0;          ///< Half lengths of the two motion windows [samples]
  int torque = 0;                      ///< Half length of the torque window [instants]
  Eigen::Index first = 0, count = 0;   ///< Sample of the first instant; number of instants
  Eigen::Index samples = 0;            ///< Number of samples of the record
  Eigen::Index stride = 1;             ///< Number of samples from one instant to the next
  double period = 0.0, spacing = 0.0;  ///< Time between samples, and between instants [s]
};

/// Returns the path of each joint from the first sample on, n x nv; turning angles continue beyond
/// a turn [rad, m].
Eigen::MatrixXd joint_path(const Model& model, const RowMatrix& q);

struct SmoothedMotion {
  /// Smooths by polynomials over windows of 2 half + 1 samples.
  SmoothedMotion(const Model& model, const MotionRecord& record, const Windows& windows, int half);

  RowMatrix q;                          ///< instants x nq
  RowMatrix v, a;                       ///< instants x nv
  RowMatrix tau, tau_rate, tau_second;  ///< instants x nv: torques and their first two derivatives
  int instants() const { return static_cast<int>(q.rows()); }
};

}  // namespace burnish::identify_detail

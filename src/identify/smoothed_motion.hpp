// A record smoothed: positions, velocities, accelerations and torques at instants that are far less
// than a window apart.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// How a record is cut. Two windows differentiate the motion, of which the longer one only tells
/// what the shorter one takes from it; a third smooths torques and what they are compared with.
struct Windows {
  /// Throws Error as identify() does.
  Windows(const Model& model, const MotionRecord& record, const IdentificationSpec& spec);

  /// Fewer instants, for many trials of which none needs the last digit: about `torque` = 16.
  Windows coarse() const;

  int motion = 0, longer = 0;          ///< half of them, samples of the record
  int torque = 0;                      ///< half of it, instants
  Eigen::Index first = 0, count = 0;   ///< sample of the first instant; number of instants
  Eigen::Index samples = 0;            ///< of the record
  Eigen::Index stride = 1;             ///< samples from instant to instant
  double period = 0.0, spacing = 0.0;  ///< s from sample to sample, and from instant to instant
};

/// Path of each joint from the first sample on, n x nv: an angle that goes round goes on [rad, m].
Eigen::MatrixXd joint_path(const Model& model, const RowMatrix& q);

struct SmoothedMotion {
  /// By polynomials over windows of 2 half + 1 samples.
  SmoothedMotion(const Model& model, const MotionRecord& record, const Windows& windows, int half);

  RowMatrix q;                        ///< instants x nq
  RowMatrix v, a;                     ///< instants x nv
  RowMatrix tau, tau_rate, tau_bend;  ///< instants x nv: torques and two derivatives
  int instants() const { return static_cast<int>(q.rows()); }
};

}  // namespace burnish::identify_detail

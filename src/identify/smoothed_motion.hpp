// A record smoothed: positions, velocities, accelerations and torques at instants that are a part
// of a window apart.
#pragma once

#include "burnish/identify/identification.hpp"

namespace burnish::identify_detail {

/// s between samples. Throws Error unless times rise evenly, to 1 % of a period.
double even_period(const Eigen::Ref<const Eigen::VectorXd>& time);

struct SmoothedMotion {
  /// Throws Error as identify() does.
  SmoothedMotion(const Model& model, const MotionRecord& record, const IdentificationSpec& spec);

  RowMatrix q;              ///< samples x nq
  RowMatrix v, a;           ///< samples x nv
  RowMatrix tau, tau_rate;  ///< samples x nv
  double spacing = 0.0;     ///< s between samples
  int samples() const { return static_cast<int>(q.rows()); }
};

}  // namespace burnish::identify_detail

// The first control of a plan as a linear function of where the plan starts and of the torque error
// that it is told.
#pragma once

#include "burnish/mpc/mpc.hpp"

namespace burnish {

struct PlanSlopes {
  StateLayout layout = {};
  double step = 0.0;       ///< Of the first knot [s].
  Eigen::MatrixXd u = {};  ///< nu x (ndx + nv): of the first control.
  /// ndx x (ndx + nv): of the way that the state goes during the first knot.
  Eigen::MatrixXd way = {};
};

/// By differences, about the specification's initial state, at the start of a phase of its
/// schedule. Throws Error where the problem has no solution there.
PlanSlopes plan_slopes(const MpcSpec& spec, int phase);

}  // namespace burnish

// Linearization of a plan's first control with respect to the plan's initial state and torque
// error.
#pragma once

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

struct PlanSlopes {
  StateLayout layout = {};
  double step = 0.0;       ///< Step of the first knot [s].
  Eigen::MatrixXd u = {};  ///< Derivative of the first control, nu x (ndx + nv).
  /// Derivative of the change of state during the first knot, ndx x (ndx + nv).
  Eigen::MatrixXd change = {};
};

/// Returns the derivatives by finite differences at the initial state of the specification, at the
/// start of a phase. `phase`: index in `spec.schedule`. Throws Error if the problem has no solution
/// there.
PlanSlopes plan_slopes(const MpcSpec& spec, int phase);

}  // namespace burnish

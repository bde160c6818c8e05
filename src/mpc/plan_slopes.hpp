// Linearization of a plan's first control with respect to the plan's initial state and torque
// error.
#pragma once

#include "burnish/mpc/task.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

struct PlanSlopes {
  StateLayout layout = {};
  double step = 0.0;       ///< Step of the first knot [s].
  Eigen::MatrixXd u = {};  ///< Derivative of the first control, nu x (ndx + nv).
  /// Derivative of the change of state during the first knot, ndx x (ndx + nv).
  Eigen::MatrixXd change = {};
};

/// Returns the derivatives by finite differences at the initial state of the problem, at the start
/// of a phase. Throws Error if the problem has no solution there.
/// - `phase`: index in `schedule`.
/// - `decay_time`: ModelErrorOptions::decay_time of the torque error [s].
PlanSlopes plan_slopes(const ProblemSpec& problem, const std::vector<SchedulePhase>& schedule,
                       int phase, const DdpOptions& solver, double decay_time);

}  // namespace burnish

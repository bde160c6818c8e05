// Periods and delays of the control loop in which estimators run.
#pragma once

#include <cmath>

namespace burnish {

/// Periods and assumed delays of a control loop [s].
struct LoopTimes {
  double tick_period;        ///< Time between ticks.
  double update_period;      ///< Time between new plans.
  double solver_delay;       ///< Time from the tick that starts a plan to the use of the plan.
  double command_delay;      ///< Time from a torque command to the torque in the joint.
  double measurement_delay;  ///< Time from a measurement to the tick that receives it.

  int ticks_in(double delay) const { return static_cast<int>(std::lround(delay / tick_period)); }
  /// Returns the number of ticks from a command to the tick that receives the first measurement of
  /// its effect.
  int delay_ticks() const { return ticks_in(command_delay) + ticks_in(measurement_delay); }
};

}  // namespace burnish

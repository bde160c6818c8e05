// Time and duration of a knot, and the factors that follow from them.
#pragma once

namespace burnish::ocp {

/// Timing of one knot, or of one knot per lane.
template <class S>
struct KnotTime {
  S step{0.0};        ///< Duration [s]; 0 at impacts and at the terminal state
  S weight{1.0};      ///< Factor of the costs: the step, or 1 if the step is 0
  S per_second{0.0};  ///< 1 / step, or 0 if the step is 0 [1/s]
  S decay{1.0};       ///< Decay factor of the torque filter over the step
  S half_decay{1.0};  ///< Decay factor of the torque filter over half the step
  /// min(1, stage step / knot step). In knots longer than the stage's step, this factor reduces the
  /// contact gains and raises the fade speeds of friction. Explicit integration then stays stable.
  S step_ratio{1.0};
  S decaying{0.0};  ///< Remaining fraction of the decaying torque (Problem::set_torque_bias)
  const double* times = nullptr;  ///< Time of each lane [s]
};

}  // namespace burnish::ocp

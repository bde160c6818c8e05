// When a knot is and how long: what its step makes of costs, rates and the torque filter.
#pragma once

namespace burnish::ocp {

/// Of one knot, or of one per lane.
template <class S>
struct KnotTime {
  S step{0.0};                    ///< s; 0 at impacts and at the end, where no time passes
  S weight{1.0};                  ///< of costs: the step, 1 where no time passes
  S per_second{0.0};              ///< one over the step, 0 where no time passes
  S decay{1.0}, half_decay{1.0};  ///< of the torque filter over the step and over half of it
  /// The stage's step by the knot's where that is longer, else 1. What is numerical, the gains of
  /// contacts and the speeds at which friction fades, is made for the stage's step and slower by
  /// this factor: explicit steps would else not bear it.
  S pace{1.0};
  S passing{0.0};  ///< of the torque that passes, what is left (Problem::set_torque_bias)
  const double* times = nullptr;  ///< s, of each lane
};

}  // namespace burnish::ocp

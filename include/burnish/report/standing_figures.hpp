// Measures of how well a robot stood during a run: load and slip of the feet, and motion of the
// body. They are computed from the run's trace.
#pragma once

#include <optional>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// Measures of how well a robot stood during a run, in SI units. They are computed from the plant's
/// true forces and positions. Forces in the first 50 ms are ignored, because the ground is still
/// taking up the robot's load.
struct StandingFigures {
  /// Largest ratio of a foot's tangential force to its friction limit (friction coefficient times
  /// normal force). Only times with a normal force >= 20 N on the foot are used.
  double friction_used = 0.0;
  /// Smallest distance from a foot's centre of pressure to the edge of the sole [m]. Only times
  /// with a normal force >= 20 N on the foot are used.
  std::optional<double> pressure_margin;
  /// Smallest normal force on a foot [N]
  double min_load = 0.0;
  /// Largest displacement of a foot along the ground since the start [m]. For a sole, the
  /// displacement of its corners is used.
  double slip = 0.0;
  /// Largest tilt of the base since the start [rad]: the angle between the vertical and the base
  /// axis that was vertical at the start.
  double base_tilt = 0.0;
  double com_moved = 0.0;  ///< Largest displacement of the centre of mass since the start [m]
};

/// Computes StandingFigures from a trace of ClosedLoop. `model` and `supports` must be the model
/// and the supports of the plant. A failed plant leaves an invalid state in the trace. Rows from
/// the first invalid state on are not used.
///
/// Throws Error
/// - if a column is missing,
/// - if the trace has no rows, or no valid state in its first row,
/// - if `supports` is empty or has a frame that the model lacks.
StandingFigures measure_standing(const Trace& trace, const Model& model,
                                 const std::vector<TouchSpec>& supports);

/// Returns whether the robot fell: the base tilted by more than 30 degrees, or the centre of mass
/// moved by more than 0.25 m. After such a displacement, the feet cannot support the centre of
/// mass.
bool fell(const StandingFigures& figures);

}  // namespace burnish

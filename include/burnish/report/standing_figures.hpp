// How a robot stood in a run, from its trace: what its feet bore, where they slid, how it swayed.
#pragma once

#include <optional>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// All of the run, from the plant's true forces and positions, SI units; of forces all but its
/// first 50 ms, in which the ground takes the robot.
struct StandingFigures {
  /// largest share of its friction cone that a foot used while it bore 20 N
  double friction_used = 0.0;
  /// m, least distance of a foot's centre of pressure from the edge of its sole while it bore 20 N
  std::optional<double> pressure_margin;
  double least_load = 0.0;  ///< N, least normal force on a foot
  /// m, farthest that a foot, with a sole a corner of it, came along the ground from where it was
  /// at first
  double slip = 0.0;
  /// rad, largest angle between the vertical and what was vertical in the base at first
  double base_tilt = 0.0;
  /// m, farthest that the centre of mass came from where it was at first
  double com_moved = 0.0;
};

/// From a trace of ClosedLoop, up to where a plant that failed left no state; `model` and
/// `supports`: as the plant has them. Throws Error for a missing column, a trace without rows or
/// whose first one is no state, no supports, and supports that do not fit the model.
StandingFigures measure_standing(const Trace& trace, const Model& model,
                                 const std::vector<SupportSpec>& supports);

/// Whether it fell: its base leaned by more than 30 degrees, or its centre of mass came more than
/// 0.25 m away, which no sole can hold.
bool fell(const StandingFigures& figures);

}  // namespace burnish

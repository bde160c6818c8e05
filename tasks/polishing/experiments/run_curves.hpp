// Curves of a run for the figures of experiments.
#pragma once

#include "burnish/report/svg_plot.hpp"
#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {

/// Curves of a run for plots, over the time since the start of the path [s].
struct RunCurves {
  Curve force;   ///< Contact force along the normal, mean over 10 ms, without the first 0.5 s [N].
  Curve path;    ///< Tool position along the tangents, from the origin of the path [mm].
  Curve target;  ///< Target position along the tangents, drawn dashed [mm].
  Curve distance;  ///< Distance between tool and target over time [mm].
};

/// Returns the curves of a run, with few points to keep files small. The curves are empty if the
/// run did not reach the path.
RunCurves curves_of(const RunResult& result, const std::string& name);

}  // namespace burnish::polishing

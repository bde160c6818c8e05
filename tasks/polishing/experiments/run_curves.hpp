// Curves of a run for the figures of experiments.
#pragma once

#include "burnish/report/svg_plot.hpp"
#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {

/// What figures show of a run, over the s since its path began.
struct RunCurves {
  Curve force;     ///< N along the normal, mean over 10 ms; after the first half second
  Curve path;      ///< mm along the surface's tangents, from the path's origin
  Curve target;    ///< where it shall be, dashed
  Curve distance;  ///< mm between the two, over time
};

/// Few enough points for small files. Empty curves where the path was not reached.
RunCurves curves_of(const RunResult& result, const std::string& name);

}  // namespace burnish::polishing

// The rows of the table of figures that are of polishing: see report/figures.hpp.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "pressing/figures.hpp"

namespace burnish::polishing {

using pressing::each_tick_figure;

/// Calls see(entry, member, what the task asks for, whether that is the least) for each figure of
/// a verdict; their full names have "verdict." in front. The task says what the force's error may
/// be as a share of the force.
template <class See>
void each_verdict_figure(const See& see) {
  using V = VerdictFigures;
  using namespace figure_units;
  see(FigureEntry{"contact_share", share, "share of the time on the path that was in contact"},
      &V::contact_share, &Verdict::contact_share, true);
  see(FigureEntry{"force_rmse", newton,
                  "root mean square error of the force's mean over 10 ms, on all of the path"},
      &V::force_rmse, &Verdict::force_rmse, false);
  see(FigureEntry{"path_share", share,
                  "share of the path's length along which the tip was over its target"},
      &V::path_share, &Verdict::path_share, true);
}

}  // namespace burnish::polishing

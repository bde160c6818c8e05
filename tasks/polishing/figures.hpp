// Table of the metrics in the verdict of a polishing run; report/figures.hpp describes such tables.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "pressing/figures.hpp"

namespace burnish::polishing {

using pressing::each_tick_figure;

/// Calls see(entry, member, limit, is_lower) for each metric of a verdict. `limit` is the limit of
/// the task, and `is_lower` is true for a lower limit. Full names begin with "verdict.". The limit
/// of the force error is a fraction of the force.
template <class See>
void each_verdict_figure(const See& see) {
  using V = VerdictFigures;
  using namespace figure_units;
  see(FigureEntry{"contact_share", share, "fraction of the time on the path in contact"},
      &V::contact_share, &Verdict::contact_share, true);
  see(FigureEntry{"force_rmse", newton,
                  "root mean square error of the force's mean over 10 ms, on the whole path"},
      &V::force_rmse, &Verdict::force_rmse, false);
  see(FigureEntry{"path_share", share,
                  "fraction of the path's length on which the tip was over its target"},
      &V::path_share, &Verdict::path_share, true);
}

}  // namespace burnish::polishing

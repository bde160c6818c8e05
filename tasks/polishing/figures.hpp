// The rows of the table of figures that are of polishing and of its controllers' ticks: see
// report/figures.hpp.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "report/figures.hpp"

namespace burnish::polishing {

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

/// Calls see(entry, member) for each figure of the controller's ticks; their full names have
/// "ticks." in front.
template <class See>
void each_tick_figure(const See& see) {
  using T = TickTimes;
  using namespace figure_units;
  see(FigureEntry{"count", none, "ticks that were timed: every nth of more than a million", "", 0},
      &T::count);
  see(FigureEntry{"period", second, "between two ticks"}, &T::period);
  see(FigureEntry{"median", computing, "median computing time of a tick"}, &T::median);
  see(FigureEntry{"p99", computing, "computing time that 99 % of the ticks stay below"}, &T::p99);
  see(FigureEntry{"maximum", computing, "longest computing time of a tick"}, &T::maximum);
  see(FigureEntry{"mean", computing, "mean computing time of a tick"}, &T::mean);
  see(FigureEntry{"late", none, "ticks that took longer than a period", "", 0}, &T::late);
}

}  // namespace burnish::polishing

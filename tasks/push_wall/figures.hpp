// The rows of the table of figures that are of this task: see report/figures.hpp.
#pragma once

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "report/figures.hpp"

namespace burnish::push_wall {

/// Calls see(entry, member) for each figure of the push; their full names have "push." in front.
template <class See>
void each_push_figure(const See& see) {
  using P = PushFigures;
  using namespace figure_units;
  see(FigureEntry{"force_rmse", newton,
                  "root mean square error of the worse hand's force (mean over 10 ms) while held",
                  "force error of a hand, rms"},
      &P::force_rmse);
  see(FigureEntry{"force_peak", newton, "largest error of either hand's force then",
                  "force error of a hand, peak", 2},
      &P::force_peak);
  see(FigureEntry{"force_mean", newton, "mean force of both hands then", "mean force of a hand", 2},
      &P::force_mean);
  see(FigureEntry{"largest_force", newton,
                  "mean of the weaker hand while the largest force is held", "largest force held",
                  1},
      &P::largest_force);
  see(FigureEntry{"largest_rmse", newton, "root mean square error of the worse hand's force then",
                  "force error at the largest, rms"},
      &P::largest_rmse);
  see(FigureEntry{"lean_force", newton, "of each hand, asked for where the search ended",
                  "force where the search ended", 1},
      &P::lean_force);
  see(FigureEntry{"lean", metre, "farthest that the centre of mass went to the wall",
                  "lean of the centre of mass", 1},
      &P::lean);
  see(FigureEntry{"hand_slip", metre,
                  "farthest that a hand slid along the wall since the ramp began; rolling is none",
                  "slip of a hand", 2},
      &P::hand_slip);
  see(FigureEntry{"foot_slip", metre, "farthest that a foot was off its start, along the ground",
                  "slip of a foot", 2},
      &P::foot_slip);
  see(FigureEntry{"sole_share", share,
                  "largest way of the pressure off a sole's middle, of half its side",
                  "pressure off the middle of a sole", 0},
      &P::sole_share);
}

}  // namespace burnish::push_wall

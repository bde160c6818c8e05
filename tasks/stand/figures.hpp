// The rows of the table of figures that are of this task: see report/figures.hpp.
#pragma once

#include "burnish/tasks/stand/stand.hpp"
#include "report/figures.hpp"

namespace burnish::stand {

/// Calls see(entry, member) for each figure of the sway; their full names have "sway." in front.
template <class See>
void each_sway_figure(const See& see) {
  using S = SwayFigures;
  using namespace figure_units;
  see(FigureEntry{"com_rmse", metre, "root mean square distance of the centre of mass from its way",
                  "centre of mass off, rms", 2},
      &S::com_rmse);
  see(FigureEntry{"com_peak", metre, "largest distance of the centre of mass from its way",
                  "centre of mass off, peak", 2},
      &S::com_peak);
  see(FigureEntry{"turn_rmse", angle, "root mean square angle of the base off its way",
                  "base turned off, rms", 2},
      &S::turn_rmse);
  see(FigureEntry{"turn_peak", angle, "largest angle of the base off its way",
                  "base turned off, peak", 2},
      &S::turn_peak);
  see(FigureEntry{"believed_place", metre,
                  "root mean square distance of the base from where the controller believes it to "
                  "be",
                  "place of the base believed off, rms", 2},
      &S::believed_place);
  see(FigureEntry{"believed_turn", angle,
                  "root mean square angle of the base off what the controller believes",
                  "turn of the base believed off, rms", 2},
      &S::believed_turn);
  see(FigureEntry{"foot_slip", metre,
                  "farthest that a foot was off its start, along the ground; that a ball rolls is "
                  "none",
                  "slip of a foot, without rolling", 2},
      &S::foot_slip);
  see(FigureEntry{"com_end", metre,
                  "of the centre of mass off its place at the start, when the run ends",
                  "centre of mass off in the end", 2},
      &S::com_end);
}

}  // namespace burnish::stand

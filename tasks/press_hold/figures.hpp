// The rows of the table of figures that are of this task: see report/figures.hpp.
#pragma once

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "report/figures.hpp"

namespace burnish::press_hold {

/// Calls see(entry, member) for each figure of the hold; their full names have "hold." in front.
template <class See>
void each_hold_figure(const See& see) {
  using H = HoldFigures;
  using namespace figure_units;
  see(FigureEntry{"moved_aside", joint,
                  "largest way of a joint from the ramp's end to the hold's (m where it slides)",
                  "moved aside", 2},
      &H::moved_aside);
  see(FigureEntry{"slip", metre, "farthest that the tool was off its point along the surface",
                  "slip of the tool"},
      &H::slip);
}

}  // namespace burnish::press_hold

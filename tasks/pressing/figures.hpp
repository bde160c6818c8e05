// The rows of the table of figures that are of a controller's ticks: see report/figures.hpp.
#pragma once

#include "burnish/tasks/pressing/plants.hpp"
#include "report/figures.hpp"

namespace burnish::pressing {

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

}  // namespace burnish::pressing

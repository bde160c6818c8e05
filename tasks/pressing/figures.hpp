// Table of statistics about how long the ticks of a controller take; report/figures.hpp describes
// such tables.
#pragma once

#include "burnish/tasks/pressing/plants.hpp"
#include "report/figures.hpp"

namespace burnish::pressing {

/// Calls see(entry, member) for each statistic, a member of TickTimes. The full name of a statistic
/// is "ticks." followed by the name of its entry.
template <class See>
void each_tick_figure(const See& see) {
  using T = TickTimes;
  using namespace figure_units;
  see(FigureEntry{"count", none,
                  "number of timed ticks; of more than a million, only every nth is timed", "", 0},
      &T::count);
  see(FigureEntry{"period", second, "time between two ticks"}, &T::period);
  see(FigureEntry{"median", computing, "median computing time of a tick"}, &T::median);
  see(FigureEntry{"p99", computing, "99th percentile of the computing time of a tick"}, &T::p99);
  see(FigureEntry{"maximum", computing, "longest computing time of a tick"}, &T::maximum);
  see(FigureEntry{"mean", computing, "mean computing time of a tick"}, &T::mean);
  see(FigureEntry{"late", none, "number of ticks that took longer than a period", "", 0}, &T::late);
}

}  // namespace burnish::pressing

namespace burnish {

/// Returns the description of the figures, from their table.
inline const Description& description_of(const TickTimes* /*of*/) {
  static const Description all =
      described_figures<TickTimes>("pressing", "TickTimes",
                                   "Computing times of a controller's ticks after the first [s].",
                                   [](const auto& see) { pressing::each_tick_figure(see); })
          .result();
  return all;
}

}  // namespace burnish

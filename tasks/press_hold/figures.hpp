// Table of the figures (measured quantities) of press_hold; report/figures.hpp describes such
// tables.
#pragma once

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "report/figures.hpp"

namespace burnish::press_hold {

/// Calls see(entry, member) for each statistic of the hold. The full name of a statistic is "hold."
/// followed by the name of its entry.
template <class See>
void each_hold_figure(const See& see) {
  using H = HoldFigures;
  using namespace figure_units;
  see(
      FigureEntry{
          "moved_aside", joint,
          "largest motion of a joint from the end of the ramp to the end of the hold (m for "
          "prismatic joints)",
          "largest joint displacement", 2},
      &H::moved_aside);
  see(FigureEntry{"slip", metre, "largest distance of the tool from its point along the surface",
                  "slip of the tool"},
      &H::slip);
}

/// Returns the description of the figures, from their table.
inline const Description& description_of(const HoldFigures* /*of*/) {
  static const Description all =
      described_figures<HoldFigures>("press_hold", "HoldFigures",
                                     "Figures from the end of the ramp to the end of the hold.",
                                     [](const auto& see) { each_hold_figure(see); })
          .result();
  return all;
}

}  // namespace burnish::press_hold

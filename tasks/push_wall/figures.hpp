// Table of the figures (measured quantities) of push_wall; report/figures.hpp describes such
// tables.
#pragma once

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "report/figures.hpp"

namespace burnish::push_wall {

/// Calls see(entry, member) for each statistic of the push. The full name of a statistic is "push."
/// followed by the name of its entry.
template <class See>
void each_push_figure(const See& see) {
  using P = PushFigures;
  using namespace figure_units;
  see(FigureEntry{"force_rmse", newton,
                  "root mean square error of the worse hand's force during the hold (mean over 10 "
                  "ms)",
                  "force error of a hand, rms"},
      &P::force_rmse);
  see(FigureEntry{"force_peak", newton, "largest error of either hand's force during the hold",
                  "force error of a hand, peak", 2},
      &P::force_peak);
  see(FigureEntry{"force_mean", newton, "mean force of both hands during the hold",
                  "mean force of a hand", 2},
      &P::force_mean);
  see(FigureEntry{"largest_force", newton,
                  "mean force of the weaker hand while the largest force is held", "largest force",
                  1},
      &P::largest_force);
  see(
      FigureEntry{
          "largest_rmse", newton,
          "root mean square error of the worse hand's force while the largest force is held",
          "force error at the largest force, rms"},
      &P::largest_rmse);
  see(FigureEntry{"search_force", newton, "target force of each hand at the end of the search",
                  "target force at the end of the search", 1},
      &P::search_force);
  see(FigureEntry{"com_displacement", metre,
                  "largest displacement of the centre of mass towards the wall",
                  "displacement of the centre of mass", 1},
      &P::com_displacement);
  see(FigureEntry{"hand_slip", metre,
                  "largest distance that a hand slid along the wall since the ramp began, without "
                  "rolling",
                  "slip of a hand", 2},
      &P::hand_slip);
  see(FigureEntry{"foot_slip", metre, "largest distance of a foot from its start along the ground",
                  "slip of a foot", 2},
      &P::foot_slip);
  see(
      FigureEntry{
          "sole_share", share,
          "largest offset of the centre of pressure from the middle of a sole, as a fraction "
          "of half its side",
          "offset of the centre of pressure", 0},
      &P::sole_share);
}

/// Returns the description of the figures, from their table.
inline const Description& description_of(const PushFigures* /*of*/) {
  static const Description all =
      described_figures<PushFigures>(
          "push_wall", "PushFigures",
          "Figures of the plant's true forces and positions. Forces are means over 10 ms. Forces "
          "of the hold are measured from 0.3 s after the ramp.",
          [](const auto& see) { each_push_figure(see); })
          .result();
  return all;
}

}  // namespace burnish::push_wall

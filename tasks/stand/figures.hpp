// Table of the figures (measured quantities) of stand; report/figures.hpp describes such tables.
#pragma once

#include "burnish/tasks/stand/stand.hpp"
#include "report/figures.hpp"

namespace burnish::stand {

/// Calls see(entry, member) for each statistic of the sway. The full name of a statistic is "sway."
/// followed by the name of its entry.
template <class See>
void each_sway_figure(const See& see) {
  using S = SwayFigures;
  using namespace figure_units;
  see(FigureEntry{"com_rmse", metre,
                  "root mean square distance of the centre of mass from its target",
                  "centre of mass error, rms", 2},
      &S::com_rmse);
  see(FigureEntry{"com_peak", metre, "largest distance of the centre of mass from its target",
                  "centre of mass error, peak", 2},
      &S::com_peak);
  see(FigureEntry{"turn_rmse", angle, "root mean square angle of the base from its target",
                  "base orientation error, rms", 2},
      &S::turn_rmse);
  see(FigureEntry{"turn_peak", angle, "largest angle of the base from its target",
                  "base orientation error, peak", 2},
      &S::turn_peak);
  see(FigureEntry{"position_estimate_rmse", metre,
                  "root mean square error of the estimated position of the base",
                  "base position estimate error, rms", 2},
      &S::position_estimate_rmse);
  see(FigureEntry{"orientation_estimate_rmse", angle,
                  "root mean square error of the estimated orientation of the base",
                  "base orientation estimate error, rms", 2},
      &S::orientation_estimate_rmse);
  see(FigureEntry{"foot_slip", metre,
                  "largest distance of a foot from its start along the ground, without the rolling "
                  "of a point foot",
                  "slip of a foot, without rolling", 2},
      &S::foot_slip);
  see(FigureEntry{"com_end", metre,
                  "distance of the centre of mass from its position at the start when the run ends",
                  "centre of mass error at the end", 2},
      &S::com_end);
}

/// Returns the description of the figures, from their table.
inline const Description& description_of(const SwayFigures* /*of*/) {
  static const Description all =
      described_figures<SwayFigures>("stand", "SwayFigures",
                                     "Figures of the plant's true positions, from the beginning of "
                                     "the sway to the end of the run or a fault.",
                                     [](const auto& see) { each_sway_figure(see); })
          .result();
  return all;
}

}  // namespace burnish::stand

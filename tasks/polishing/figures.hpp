// Tables of metrics of a polishing run, for its verdict and for a resting hand. report/figures.hpp
// describes such tables.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "pressing/figures.hpp"

namespace burnish::polishing {

using pressing::each_tick_figure;

/// Calls see(entry, member, limit, is_lower) for each metric of a verdict. `limit` is the limit of
/// the task, and `is_lower` is true for a lower limit. Full names begin with "verdict.". The limit
/// of the force error is a fraction of the target force.
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

/// Calls see(entry, member) for each statistic of a resting hand. The full name of a statistic is
/// "rest." followed by the name of its entry.
template <class See>
void each_rest_figure(const See& see) {
  using R = RestFigures;
  using namespace figure_units;
  see(FigureEntry{"force_mean", newton, "mean normal force of the resting hand on the path",
                  "mean force of the resting hand", 2},
      &R::force_mean);
  see(FigureEntry{"force_rmse", newton,
                  "root mean square error of the resting hand's force (mean over 10 ms)",
                  "force error of the resting hand, rms"},
      &R::force_rmse);
  see(FigureEntry{"force_peak", newton, "largest error of the resting hand's force",
                  "force error of the resting hand, peak", 2},
      &R::force_peak);
  see(FigureEntry{"slip", metre,
                  "largest distance that the resting hand slid on the path, without rolling",
                  "slip of the resting hand"},
      &R::slip);
}

/// Returns the description of the figures, from their table.
inline const Description& description_of(const VerdictFigures* /*of*/) {
  static const Description all =
      described_figures<VerdictFigures>("polishing", "VerdictFigures",
                                        "Metrics of a run, to compare with Verdict.",
                                        [](const auto& see) { each_verdict_figure(see); })
          .result();
  return all;
}

/// Returns the description of the figures, from their table.
inline const Description& description_of(const RestFigures* /*of*/) {
  static const Description all =
      described_figures<RestFigures>(
          "polishing", "RestFigures",
          "Figures of the hand that rests on a plane, from the plant's true force and position.",
          [](const auto& see) { each_rest_figure(see); })
          .result();
  return all;
}

}  // namespace burnish::polishing

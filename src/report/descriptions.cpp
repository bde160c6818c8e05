#include "report/descriptions.hpp"

#include "report/figures.hpp"

namespace burnish {

const Description& description_of(const SolverFigures* /*of*/) {
  static const Description all =
      described_figures<SolverFigures>("report", "SolverFigures",
                                       "Statistics of the solver over the plans in the window.",
                                       [](const auto& see) { each_solver_figure(see); })
          .result();
  return all;
}

const Description& description_of(const Metrics* /*of*/) {
  static const Description all =
      described_figures<Metrics>(
          "report", "Metrics",
          "Metrics of a polishing run, in SI units. They are computed from true forces and "
          "positions, over the window if not stated otherwise.",
          [](const auto& see) { each_metric(see); })
          .field("solver", &Metrics::solver,
                 "statistics of the solver; none if the trace has no solve times")
          .result();
  return all;
}

const Description& description_of(const StandingFigures* /*of*/) {
  static const Description all =
      described_figures<StandingFigures>(
          "report", "StandingFigures",
          "Measures of how well a robot stood during a run, computed from the plant's true forces "
          "and positions. Forces in the first 50 ms are ignored, because the ground is still "
          "taking "
          "up the robot's load.",
          [](const auto& see) { each_standing_figure(see); })
          .result();
  return all;
}

}  // namespace burnish

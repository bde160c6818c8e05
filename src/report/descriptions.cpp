#include "report/descriptions.hpp"

#include "report/figures.hpp"

namespace burnish {

const Description& description_of(const SolverFigures* /*of*/) {
  static const Description all = [] {
    Describe<SolverFigures> figures("report", "SolverFigures",
                                    "Statistics of the solver over the plans in the window.");
    each_solver_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

const Description& description_of(const Metrics* /*of*/) {
  static const Description all = [] {
    Describe<Metrics> figures("report", "Metrics",
                              "Metrics of a polishing run, in SI units. They are computed from "
                              "true forces and positions, over the window if not stated "
                              "otherwise.");
    each_metric([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures
        .field("solver", &Metrics::solver,
               "statistics of the solver; none if the trace has no solve times")
        .result();
  }();
  return all;
}

const Description& description_of(const StandingFigures* /*of*/) {
  static const Description all = [] {
    Describe<StandingFigures> figures("report", "StandingFigures",
                                      "Measures of how well a robot stood during a run, computed "
                                      "from the plant's true forces and positions. Forces in the "
                                      "first 50 ms are ignored, because the ground is still taking "
                                      "up the robot's load.");
    each_standing_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish

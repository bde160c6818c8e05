#include "report/descriptions.hpp"

#include "report/figures.hpp"

namespace burnish {

const Description& description_of(const SolverFigures* /*of*/) {
  static const Description all = [] {
    Describe<SolverFigures> figures("report", "SolverFigures",
                                    "Over the control ticks of the window that solved something.");
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
                              "How well a run polished: all of the window unless it says "
                              "otherwise, on true forces and positions, SI units.");
    each_metric([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.field("solver", &Metrics::solver, "where a controller reports solve times")
        .result();
  }();
  return all;
}

const Description& description_of(const StandingFigures* /*of*/) {
  static const Description all = [] {
    Describe<StandingFigures> figures("report", "StandingFigures",
                                      "How a robot stood: all of the run, from the plant's true "
                                      "forces and positions; of forces all "
                                      "but its first 50 ms, in which the ground takes the robot.");
    each_standing_figure([&](const FigureEntry& entry, auto member) {
      figures.field(entry.name, member, described_as(entry).c_str());
    });
    return figures.result();
  }();
  return all;
}

}  // namespace burnish

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

const Description& description_of(const MetricsSpec* /*of*/) {
  using M = MetricsSpec;
  static const Description all =
      Describe<M>("report", "MetricsSpec", "What of a trace is measured.")
          .field("start", &M::start, "{s}, of the window")
          .field("end", &M::end, "{s}, of the window")
          .field("normal_world", &M::normal_world,
                 "Along which the force is measured and across which the position, towards the "
                 "robot, any length but zero; none: the normal of the surface at the tool, as it "
                 "is in each row.")
          .field("average", &M::average,
                 "{s}, of the moving average of the force, centred; 0: none")
          .field("tool_axis", &M::tool_axis,
                 "that the tool presses along, in its frame, any length but zero; none: "
                 "tool_to_normal is not measured")
          .field("tool_start_world", &M::tool_start_world,
                 "columns: the tool's axes where the trace begins, world");
  return all;
}

const Description& description_of(const NamedMetrics* /*of*/) {
  using N = NamedMetrics;
  static const Description all =
      Describe<N>("report", "NamedMetrics", "Metrics of a run, and what it is called.")
          .result()
          .field("name", &N::name)
          .field("metrics", &N::metrics);
  return all;
}

const Description& description_of(const Curve* /*of*/) {
  using C = Curve;
  static const Description all =
      Describe<C>("report", "Curve", "One line. Points that are not finite interrupt it.")
          .field("name", &C::name, "in the legend; empty: not listed")
          .field("x", &C::x)
          .field("y", &C::y)
          .field("color", &C::color, "of the palette; -1: the next one")
          .field("dashed", &C::dashed, "limits and targets");
  return all;
}

const Description& description_of(const Panel* /*of*/) {
  using P = Panel;
  static const Description all =
      Describe<P>("report", "Panel", "Axes with curves in them.")
          .field("title", &P::title)
          .field("x_label", &P::x_label, "with units, such as \"time [s]\"")
          .field("y_label", &P::y_label)
          .field("curves", &P::curves)
          .field("equal_aspect", &P::equal_aspect, "a metre is as long upwards as to the right")
          .field("log_y", &P::log_y, "values that are not positive are left out");
  return all;
}

const Description& description_of(const PlotSpec* /*of*/) {
  using P = PlotSpec;
  static const Description all =
      Describe<P>("report", "PlotSpec", "Line plots as an SVG file that any browser shows.")
          .field("title", &P::title)
          .field("panels", &P::panels)
          .field("columns", &P::columns, "panels beside each other")
          .field("panel_width", &P::panel_width, "{px}, the legend included")
          .field("panel_height", &P::panel_height, "{px}");
  return all;
}

}  // namespace burnish

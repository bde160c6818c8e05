// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "report/descriptions.hpp"
#include "report/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const MetricsSpec* /*of*/) {
  using S = MetricsSpec;
  static const Description all =
      Describe<S>("report", "MetricsSpec",
                  "Settings of measure(): time window and directions for the metrics of a trace.")
          .field("start", &S::start,
                 "Start of the time window [{s}]")
          .field("end", &S::end,
                 "End of the time window [{s}]")
          .field("normal_world", &S::normal_world,
                 "Surface normal towards the robot, in world axes (none: the true normal at the "
                 "tool, in each row of the trace)")
          .more("Forces are measured along the normal, position errors perpendicular to the "
                "normal. The normal may have any length except zero")
          .field("average", &S::average,
                 "Width of the centred moving average of the force (0: no average) [{s}]")
          .field("tool_axis", &S::tool_axis,
                 "Direction in which the tool presses, in the tool's frame (none: "
                 "Metrics.tool_to_normal is not computed)")
          .more("The vector may have any length except zero")
          .field("tool_start_world", &S::tool_start_world,
                 "Axes of the tool at the start of the trace, as columns in world axes");
  return all;
}

const Description& description_of(const NamedMetrics* /*of*/) {
  using S = NamedMetrics;
  static const Description all =
      Describe<S>("report", "NamedMetrics",
                  "Metrics of a run together with the run's name.")
          .result()
          .field("name", &S::name)
          .field("metrics", &S::metrics);
  return all;
}

const Description& description_of(const Curve* /*of*/) {
  using S = Curve;
  static const Description all =
      Describe<S>("report", "Curve",
                  "A curve in a plot. Points that are not finite leave gaps in the curve.")
          .field("name", &S::name,
                 "Name in the legend (empty: not listed)")
          .field("x", &S::x)
          .field("y", &S::y)
          .field("color", &S::color,
                 "Index of the colour in the palette (-1: the next colour)")
          .field("dashed", &S::dashed,
                 "Whether the line is dashed, such as for limits and targets");
  return all;
}

const Description& description_of(const Panel* /*of*/) {
  using S = Panel;
  static const Description all =
      Describe<S>("report", "Panel",
                  "A pair of axes with its curves.")
          .field("title", &S::title)
          .field("x_label", &S::x_label,
                 "Label of the x axis, with its unit, such as \"time [s]\"")
          .field("y_label", &S::y_label)
          .field("curves", &S::curves)
          .field("equal_aspect", &S::equal_aspect,
                 "Whether both axes have the same scale")
          .field("log_y", &S::log_y,
                 "Whether the y axis is logarithmic")
          .more("Values <= 0 are then left out");
  return all;
}

const Description& description_of(const PlotSpec* /*of*/) {
  using S = PlotSpec;
  static const Description all =
      Describe<S>("report", "PlotSpec",
                  "A figure with one or more panels of line plots. The result is an SVG file that"
                  " any browser shows.")
          .field("title", &S::title)
          .field("panels", &S::panels)
          .field("columns", &S::columns,
                 "Number of panels side by side")
          .field("panel_width", &S::panel_width,
                 "Width of a panel, including its legend, in {px}")
          .field("panel_height", &S::panel_height,
                 "Height of a panel, in {px}");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)

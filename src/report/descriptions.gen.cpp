// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "report/descriptions.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const MetricsSpec* /*of*/) {
  using S = MetricsSpec;
  static const Description all =
      Describe<S>("report", "MetricsSpec",
                  "What of a trace is measured.")
          .field("start", &S::start,
                 "{s}, of the window")
          .field("end", &S::end,
                 "{s}, of the window")
          .field("normal_world", &S::normal_world,
                 "Along which the force is measured and across which the position, towards the "
                 "robot, any length but zero; none: the normal of the surface at the tool, as it "
                 "is in each row.")
          .field("average", &S::average,
                 "{s}, of the moving average of the force, centred; 0: none")
          .field("tool_axis", &S::tool_axis,
                 "that the tool presses along, in its frame, any length but zero; none: "
                 "tool_to_normal is not measured")
          .field("tool_start_world", &S::tool_start_world,
                 "columns: the tool's axes where the trace begins, world");
  return all;
}

const Description& description_of(const NamedMetrics* /*of*/) {
  using S = NamedMetrics;
  static const Description all =
      Describe<S>("report", "NamedMetrics",
                  "Metrics of a run, and what it is called.")
          .result()
          .field("name", &S::name)
          .field("metrics", &S::metrics);
  return all;
}

const Description& description_of(const Curve* /*of*/) {
  using S = Curve;
  static const Description all =
      Describe<S>("report", "Curve",
                  "One line. Points that are not finite interrupt it.")
          .field("name", &S::name,
                 "in the legend; empty: not listed")
          .field("x", &S::x)
          .field("y", &S::y)
          .field("color", &S::color,
                 "of the palette; -1: the next one")
          .field("dashed", &S::dashed,
                 "limits and targets");
  return all;
}

const Description& description_of(const Panel* /*of*/) {
  using S = Panel;
  static const Description all =
      Describe<S>("report", "Panel",
                  "Axes with curves in them.")
          .field("title", &S::title)
          .field("x_label", &S::x_label,
                 "with units, such as \"time [s]\"")
          .field("y_label", &S::y_label)
          .field("curves", &S::curves)
          .field("equal_aspect", &S::equal_aspect,
                 "a metre is as long upwards as to the right")
          .field("log_y", &S::log_y,
                 "values that are not positive are left out");
  return all;
}

const Description& description_of(const PlotSpec* /*of*/) {
  using S = PlotSpec;
  static const Description all =
      Describe<S>("report", "PlotSpec",
                  "Line plots as an SVG file that any browser shows.")
          .field("title", &S::title)
          .field("panels", &S::panels)
          .field("columns", &S::columns,
                 "panels beside each other")
          .field("panel_width", &S::panel_width,
                 "{px}, the legend included")
          .field("panel_height", &S::panel_height,
                 "{px}");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)

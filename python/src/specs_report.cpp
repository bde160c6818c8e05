#include "specs_report.hpp"

#include "report/figures.hpp"

namespace burnish::python {

template <>
const SpecTable& AsDataclass<MetricsSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "MetricsSpec")
                                      .field("start", &MetricsSpec::start)
                                      .field("end", &MetricsSpec::end)
                                      .field("normal_world", &MetricsSpec::normal_world)
                                      .field("average", &MetricsSpec::average);
  return fields;
}
template <>
const SpecTable& AsDataclass<SolverFigures>::table() {
  static const SpecTable fields = [] {
    SpecTable table("burnish.report", "SolverFigures");
    each_solver_figure(
        [&](const FigureEntry& entry, auto member) { table.field(entry.name, member); });
    return table;
  }();
  return fields;
}
template <>
const SpecTable& AsDataclass<Metrics>::table() {
  static const SpecTable fields = [] {
    SpecTable table("burnish.report", "Metrics");
    each_metric([&](const FigureEntry& entry, auto member) { table.field(entry.name, member); });
    return table.field("solver", &Metrics::solver);
  }();
  return fields;
}
template <>
const SpecTable& AsDataclass<NamedMetrics>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "NamedMetrics")
                                      .field("name", &NamedMetrics::name)
                                      .field("metrics", &NamedMetrics::metrics);
  return fields;
}
template <>
const SpecTable& AsDataclass<Curve>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "Curve")
                                      .field("name", &Curve::name)
                                      .field("x", &Curve::x)
                                      .field("y", &Curve::y)
                                      .field("color", &Curve::color)
                                      .field("dashed", &Curve::dashed);
  return fields;
}
template <>
const SpecTable& AsDataclass<Panel>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "Panel")
                                      .field("title", &Panel::title)
                                      .field("x_label", &Panel::x_label)
                                      .field("y_label", &Panel::y_label)
                                      .field("curves", &Panel::curves)
                                      .field("equal_aspect", &Panel::equal_aspect)
                                      .field("log_y", &Panel::log_y);
  return fields;
}
template <>
const SpecTable& AsDataclass<PlotSpec>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "PlotSpec")
                                      .field("title", &PlotSpec::title)
                                      .field("panels", &PlotSpec::panels)
                                      .field("columns", &PlotSpec::columns)
                                      .field("panel_width", &PlotSpec::panel_width)
                                      .field("panel_height", &PlotSpec::panel_height);
  return fields;
}

}  // namespace burnish::python

#include "specs_report.hpp"

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
  static const SpecTable fields = SpecTable("burnish.report", "SolverFigures")
                                      .field("ticks", &SolverFigures::ticks)
                                      .field("median", &SolverFigures::median)
                                      .field("p99", &SolverFigures::p99)
                                      .field("maximum", &SolverFigures::maximum)
                                      .field("mean_iterations", &SolverFigures::mean_iterations)
                                      .field("missed_deadlines", &SolverFigures::missed_deadlines);
  return fields;
}
template <>
const SpecTable& AsDataclass<Metrics>::table() {
  static const SpecTable fields = SpecTable("burnish.report", "Metrics")
                                      .field("start", &Metrics::start)
                                      .field("end", &Metrics::end)
                                      .field("rows", &Metrics::rows)
                                      .field("average", &Metrics::average)
                                      .field("force_mean", &Metrics::force_mean)
                                      .field("force_mae", &Metrics::force_mae)
                                      .field("force_rmse", &Metrics::force_rmse)
                                      .field("force_peak", &Metrics::force_peak)
                                      .field("force_rmse_raw", &Metrics::force_rmse_raw)
                                      .field("force_peak_raw", &Metrics::force_peak_raw)
                                      .field("estimate_rmse", &Metrics::estimate_rmse)
                                      .field("without_contact", &Metrics::without_contact)
                                      .field("impact_peak", &Metrics::impact_peak)
                                      .field("overshoot", &Metrics::overshoot)
                                      .field("position_mean", &Metrics::position_mean)
                                      .field("position_rmse", &Metrics::position_rmse)
                                      .field("position_p95", &Metrics::position_p95)
                                      .field("orientation_drift", &Metrics::orientation_drift)
                                      .field("joint_margin", &Metrics::joint_margin)
                                      .field("tightest_joint", &Metrics::tightest_joint)
                                      .field("torque_margin", &Metrics::torque_margin)
                                      .field("tightest_torque", &Metrics::tightest_torque)
                                      .field("limited_torque", &Metrics::limited_torque)
                                      .field("solver", &Metrics::solver);
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

// Bindings of metrics and plots of runs.
#include "bind.hpp"
#include "specs_report.hpp"

namespace burnish::python {

// Docstrings.

constexpr const char* measure_doc = R"(Computes the metrics of a polishing run.

Parameters
----------
trace : Trace
    Trace of a ClosedLoop.
model : Model
spec : MetricsSpec, optional

Returns
-------
Metrics

Raises
------
Error
    If a column is missing, the normal is zero, or the window has no rows.)";

constexpr const char* measure_standing_doc = R"(Computes the figures of a standing robot.

Parameters
----------
trace : Trace
    Trace of a ClosedLoop.
model : Model
    Model of the plant.
supports : sequence of TouchSpec
    Supports of the plant, at least one: see SceneSpec.supports().

Returns
-------
StandingFigures

Raises
------
Error
    If a column is missing, the trace has no rows, its first row is not a valid state, or the
    supports do not fit.)";

constexpr const char* metrics_table_doc =
    R"(Returns a table with a line per figure and a column per run, in N, mm, degrees, ms and %.

Parameters
----------
runs : sequence of NamedMetrics

Returns
-------
str)";

constexpr const char* svg_plot_doc = R"(Returns a plot as the text of an SVG file.

Parameters
----------
spec : PlotSpec

Returns
-------
str)";

constexpr const char* write_svg_plot_doc = R"(Writes a plot to an SVG file.

Parameters
----------
spec : PlotSpec
file : str or Path

Raises
------
Error
    If the file cannot be written.)";

void bind_report(py::module_& m) {
  m.def(
      "measure",
      [](const Trace& trace, const Model& model, const std::optional<MetricsSpec>& spec) {
        return measure(trace, model, spec.value_or(MetricsSpec{}));
      },
      py::arg("trace"), py::arg("model"), py::arg("spec") = py::none(),
      py::call_guard<py::gil_scoped_release>(), measure_doc);
  m.def("measure_standing", &measure_standing, py::arg("trace"), py::arg("model"),
        py::arg("supports"), py::call_guard<py::gil_scoped_release>(), measure_standing_doc);
  m.def("metrics_table", &metrics_table, py::arg("runs"), metrics_table_doc);
  m.def("metrics_text", &metrics_text, py::arg("metrics"));
  m.def("svg_plot", &svg_plot, py::arg("spec"), svg_plot_doc);
  m.def("write_svg_plot", &write_svg_plot, py::arg("spec"), py::arg("file"), write_svg_plot_doc);
  m.def("plot_palette", &plot_palette,
        "Returns the colours of curves, which suit people with colour vision deficiencies.");
}

}  // namespace burnish::python

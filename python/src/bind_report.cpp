// The measures of a run, and plots.
#include "bind.hpp"
#include "specs_report.hpp"

namespace burnish::python {

void bind_report(py::module_& m) {
  m.def(
      "measure",
      [](const Trace& trace, const Model& model, const std::optional<MetricsSpec>& spec) {
        return measure(trace, model, spec.value_or(MetricsSpec{}));
      },
      py::arg("trace"), py::arg("model"), py::arg("spec") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "How well a run polished, from a trace of ClosedLoop. Raises Error for a missing column, a "
      "zero normal, and a window without rows.");
  m.def("measure_standing", &measure_standing, py::arg("trace"), py::arg("model"),
        py::arg("supports"), py::call_guard<py::gil_scoped_release>(),
        "How a robot stood (StandingFigures), from a trace of ClosedLoop; model and supports "
        "(SupportSpec) as the plant has them. Raises Error for a missing column, a trace without "
        "rows or whose first one is no state, no supports, and supports that do not fit.");
  m.def("metrics_table", &metrics_table, py::arg("runs"),
        "One line per figure, under its name in files, and a column per run (NamedMetrics): N, mm, "
        "degrees, ms, %.");
  m.def("metrics_text", &metrics_text, py::arg("metrics"));
  m.def("svg_plot", &svg_plot, py::arg("spec"), "The text of an SVG file.");
  m.def("write_svg_plot", &write_svg_plot, py::arg("spec"), py::arg("file"),
        "Writes an SVG file. Raises Error if that fails.");
  m.def("plot_palette", &plot_palette,
        "The colours of curves, told apart by people of any colour vision.");
}

}  // namespace burnish::python

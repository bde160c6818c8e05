// Errors, statuses, records of runs.
#include "bind.hpp"
#include "burnish/base/trace.hpp"
#include "machine.hpp"
#include "specs_base.hpp"

namespace burnish::python {

namespace {

/// The rows of a trace as a structured array on the trace's own memory.
py::array rows_of(const Trace& trace, py::handle owner) {
  py::list fields;
  for (const TraceColumn& column : trace.columns())
    fields.append(py::make_tuple(column.name, "f8"));
  const py::dtype dtype = py::dtype::from_args(fields);
  const double* data = trace.rows() > 0 ? trace.column(0).data() : nullptr;
  py::array array(dtype, {trace.rows()}, {dtype.itemsize()}, data,
                  data != nullptr ? owner : py::handle());
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace

void bind_base(py::module_& m) {
  const py::object error = py::register_exception<Error>(m, "Error", PyExc_ValueError);
  error.attr("__doc__") =
      "A specification, a file or an argument that cannot be used: one sentence that names what, "
      "what came and what was wanted.";
  const py::object evaluation =
      py::register_exception<EvaluationError>(m, "EvaluationError", error);
  evaluation.attr("__doc__") =
      "An evaluation that has no result: singular contacts, a state that is not finite, ...";

  m.def(
      "describe", [](Status status) { return std::string(describe(status)); }, py::arg("status"),
      "One sentence that says what the status means and what to do about it.");

  py::class_<Trace>(m, "Trace",
                    "A record of a run: named columns with units, one row per sample.\n\n"
                    "len(trace) is the number of rows, trace['time'] a column; array() has all.")
      .def_property_readonly(
          "columns",
          [](const Trace& trace) {
            std::vector<std::string> names;
            for (const TraceColumn& column : trace.columns()) names.push_back(column.name);
            return names;
          },
          "Names of the columns.")
      .def_property_readonly(
          "units",
          [](const Trace& trace) {
            py::dict units;
            for (const TraceColumn& column : trace.columns())
              units[py::str(column.name)] = column.unit;
            return units;
          },
          "Unit of each column by its name; '-' for counts and flags.")
      .def_property_readonly("dropped", &Trace::dropped,
                             "Rows that came when the record was full, and are not in it.")
      .def("__len__", &Trace::rows)
      .def("__contains__",
           [](const Trace& trace, const std::string& name) { return trace.has(name); })
      .def(
          "__getitem__",
          [](const py::object& self, const std::string& name) {
            const auto& trace = py::cast<const Trace&>(self);
            const Trace::Column column = trace.column(name);
            const auto stride =
                static_cast<py::ssize_t>(column.innerStride() * py::ssize_t{sizeof(double)});
            return view_of(column.data(), {trace.rows()}, {stride}, self);
          },
          py::arg("column"),
          "One column, (rows,), a read-only view of the record. Raises Error with the nearest "
          "known "
          "name.")
      .def(
          "array",
          [](const py::object& self) { return rows_of(py::cast<const Trace&>(self), self); },
          "All rows as a structured array with a field per column, (rows,): a read-only view of "
          "the "
          "record, ready for pandas.DataFrame(trace.array()).")
      .def(
          "write_csv",
          [](const Trace& trace, const std::filesystem::path& file) { trace.write_csv(file); },
          py::arg("file"), py::call_guard<py::gil_scoped_release>(),
          "Writes `name [unit],...` and one line per row. Raises Error if that fails.")
      .def("__repr__", [](const Trace& trace) {
        return "<Trace: " + std::to_string(trace.rows()) + " rows of " +
               std::to_string(trace.columns().size()) + " columns>";
      });
}

}  // namespace burnish::python

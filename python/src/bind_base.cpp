// Bindings of errors, statuses, signals and traces.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/renames.hpp"
#include "bind.hpp"
#include "burnish/base/trace.hpp"
#include "machine.hpp"
#include "specs_base.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* describe_doc =
    R"(Returns a sentence with the meaning of a status and a remedy.

Parameters
----------
status : Status

Returns
-------
str)";

/// Returns the rows of a trace as a structured array, a view of the trace's memory.
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

/// Returns a trace with the given rows. `units` holds the unit of each column by its name.
Trace trace_of(const py::dict& units, const std::optional<Eigen::Ref<const RowMatrix>>& rows) {
  std::vector<TraceColumn> columns;
  for (const auto& [name, unit] : units)
    columns.push_back({py::cast<std::string>(name), py::cast<std::string>(unit)});
  if (!rows) return {std::move(columns), 0};
  if (rows->cols() != static_cast<Eigen::Index>(columns.size()))
    throw Error("Trace: the rows have " + std::to_string(rows->cols()) + " entries; wanted " +
                std::to_string(columns.size()) + ", one per column");
  Trace trace(std::move(columns), static_cast<int>(rows->rows()));
  for (Eigen::Index row = 0; row < rows->rows(); ++row)
    Eigen::Map<Eigen::RowVectorXd>(trace.add_row(), rows->cols()) = rows->row(row);
  return trace;
}

py::dict units_of(const Trace& trace) {
  py::dict units;
  for (const TraceColumn& column : trace.columns()) units[py::str(column.name)] = column.unit;
  return units;
}

/// Returns units and rows of a trace, for pickling. The number of dropped rows is not included.
py::tuple trace_state(const Trace& trace) {
  const auto columns = static_cast<Eigen::Index>(trace.columns().size());
  RowMatrix rows(trace.rows(), columns);
  for (int column = 0; column < columns; ++column) rows.col(column) = trace.column(column);
  return py::make_tuple(units_of(trace), rows);
}

/// Returns whether two traces are equal, bit by bit.
bool same(const Trace& a, const Trace& b) {
  if (a.rows() != b.rows() || !units_of(a).equal(units_of(b))) return false;
  for (int column = 0; column < static_cast<int>(a.columns().size()); ++column)
    if (a.columns()[static_cast<std::size_t>(column)].name !=
            b.columns()[static_cast<std::size_t>(column)].name ||
        !std::equal(a.column(column).begin(), a.column(column).end(), b.column(column).begin(),
                    [](double x, double y) {
                      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
                    }))
      return false;
  return true;
}

void bind_errors(py::module_& m) {
  const py::object error = py::register_exception<Error>(m, "Error", PyExc_ValueError);
  error.attr("__doc__") =
      "Invalid specification, file or argument. The message is one sentence with the object, its "
      "value and the requirement.";
  const py::object evaluation =
      py::register_exception<EvaluationError>(m, "EvaluationError", error);
  evaluation.attr("__doc__") =
      "Evaluation without a result, for example with singular contacts or a state that is not "
      "finite.";

  m.def(
      "describe", [](Status status) { return std::string(describe(status)); }, py::arg("status"),
      describe_doc);
  m.def("did_you_mean", &did_you_mean, py::arg("name"), py::arg("known"),
        "Returns the end of an error message: \"; did you mean 'x'?\", or an empty text if no "
        "known name is similar.");
  m.def(
      "renames",
      [] {
        std::vector<std::pair<std::string, std::string>> all;
        for (const Rename& rename : renames()) all.emplace_back(rename.old_name, rename.new_name);
        return all;
      },
      "Names of version 0.3 and the names that replaced them, as pairs.");
}

void bind_trace(py::class_<Trace>& of) {
  of.def_property_readonly(
        "columns",
        [](const Trace& trace) {
          std::vector<std::string> names;
          for (const TraceColumn& column : trace.columns()) names.push_back(column.name);
          return names;
        },
        "Names of the columns.")
      .def(py::init(&trace_of), py::arg("units") = py::dict(), py::arg("rows") = py::none(),
           "Makes a record: `units` by column name, in the order of the columns, and rows, shape "
           "(n, columns).")
      .def_property_readonly("units", &units_of, "Units by column name; '-' for counts and flags.")
      .def_property_readonly("dropped", &Trace::dropped,
                             "Number of rows that were dropped because the record was full.")
      .def(
          "write_csv",
          [](const Trace& trace, const std::filesystem::path& file) { trace.write_csv(file); },
          py::arg("file"), py::call_guard<py::gil_scoped_release>(),
          "Writes a CSV file with the header `name [unit],...`. Raises Error if writing fails.")
      .def("__copy__", [](const Trace& trace) { return trace; })
      .def("__deepcopy__", [](const Trace& trace, const py::dict&) { return trace; })
      .def(py::pickle(&trace_state,
                      [](const py::tuple& state) {
                        return trace_of(state[0], py::cast<Eigen::Ref<const RowMatrix>>(state[1]));
                      }))
      .def("__eq__", &same, py::is_operator())
      .def("__repr__", [](const Trace& trace) {
        return "<Trace: " + std::to_string(trace.rows()) + " rows of " +
               std::to_string(trace.columns().size()) + " columns>";
      });
}

/// Binds access to the columns, as in a dictionary of arrays.
void bind_columns(py::class_<Trace>& of) {
  of.def("__len__", &Trace::rows)
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
          "Returns a read-only view of one column, shape (rows,). Raises Error with the nearest "
          "name for an unknown column.")
      .def(
          "array",
          [](const py::object& self) { return rows_of(py::cast<const Trace&>(self), self); },
          "Returns a read-only view of all rows as a structured array with a field per column, "
          "shape (rows,). pandas.DataFrame(trace.array()) makes a data frame.");
}

}  // namespace

void bind_base(py::module_& m) {
  bind_errors(m);
  py::class_<SignalFunction>(m, "SignalFunction",
                             "Function of time [s] from C++, for example from a problem file.")
      .def(
          "__call__",
          [](const SignalFunction& self, double time) {
            Eigen::VectorXd value(self.signal.size());
            self.signal.at(time, value);
            return value;
          },
          py::arg("time"), "Returns the values at a time [s].")
      .def("__copy__", [](const SignalFunction& self) { return self; })
      .def("__deepcopy__", [](const SignalFunction& self, const py::dict&) { return self; });
  py::class_<Trace> trace(
      m, "Trace",
      "Record of a run: named columns with units, and a row per sample.\n"
      "\n"
      "len(trace) is the number of rows, trace['time'] a column, and trace.array() all rows.");
  bind_trace(trace);
  bind_columns(trace);
}

}  // namespace burnish::python

// Bindings of problem files and YAML.
#include "base/parse_number.hpp"
#include "bind.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"
#include "machine_ocp.hpp"
#include "specs_files.hpp"

namespace burnish::python {
namespace {

// Docstrings.

constexpr const char* read_problem_file_doc = R"(Reads a problem file (YAML).

Parameters
----------
file : str or Path
    Problem file. Paths in it are relative to its folder.

Returns
-------
ProblemFile

Raises
------
Error
    If the file is invalid; the message has the file, line, keys and requirement.)";

constexpr const char* make_guess_doc = R"(Makes the initial trajectory of a solve.

Parameters
----------
problem : Problem
start : WarmStart, optional

Returns
-------
TrajectoryGuess
    States xs (N + 1, nx) and controls us (N, max_controls).

Raises
------
Error
    If a file cannot be read, or does not fit the problem.)";

/// Returns a document as Python object, made of dictionaries, lists, texts, numbers, True, False
/// and None.
py::object object_of(const document::Node& node) {
  switch (node.kind) {
    case document::Kind::Null:
      return py::none();
    case document::Kind::Bool:
      return py::bool_(node.text == "true");
    case document::Kind::Text:
      return py::str(node.text);
    case document::Kind::Number: {
      if (node.text.find_first_not_of("+-0123456789") == std::string::npos)
        return py::int_(py::str(node.text));
      return py::float_(*parse_number(node.text));
    }
    case document::Kind::List: {
      py::list list;
      for (const document::Node& value : node.values) list.append(object_of(value));
      return list;
    }
    case document::Kind::Map:
      break;
  }
  py::dict map;
  for (std::size_t i = 0; i < node.values.size(); i += 2)
    map[py::str(node.values[i].text)] = object_of(node.values[i + 1]);
  return map;
}

void bind_documents(py::module_& m) {
  m.def(
      "read_yaml",
      [](const std::filesystem::path& file) {
        return object_of(document::Reader::load(file).node());
      },
      py::arg("file"),
      "Reads a YAML file into dictionaries, lists, texts, numbers, True, False and None. Raises "
      "Error with file and line.");
  m.def(
      "parse_yaml",
      [](const std::string& text, const std::string& name) {
        return object_of(document::parse_yaml(text, name));
      },
      py::arg("text"), py::arg("name") = "the text",
      "Reads a YAML text, called `name` in messages.");
  m.def(
      "json_as_yaml",
      [](const std::string& json) {
        return document::yaml_text(document::parse_json(json, "the value"));
      },
      py::arg("json"),
      "Returns a JSON value as one line of YAML, with quotes only where YAML needs them.");
}

}  // namespace

void bind_files(py::module_& m) {
  bind_documents(m);
  m.def("read_problem_file", &read_problem_file, py::arg("file"),
        py::call_guard<py::gil_scoped_release>(), read_problem_file_doc);
  m.def(
      "make_guess",
      [](ProblemMachine& machine, const std::optional<WarmStart>& start) {
        const Busy::Lock lock(machine.busy, "make_guess");
        return make_guess(machine.problem, start.value_or(WarmStart{}));
      },
      py::arg("problem"), py::arg("start") = py::none(), py::call_guard<py::gil_scoped_release>(),
      make_guess_doc);
}

}  // namespace burnish::python

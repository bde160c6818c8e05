// Problems in files.
#include "base/parse_number.hpp"
#include "bind.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"
#include "machine_ocp.hpp"
#include "specs_files.hpp"

namespace burnish::python {
namespace {

/// Dictionaries, lists, texts, numbers, True, False and None.
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
      "A file of YAML as dictionaries, lists, texts, numbers, True, False and None. Raises Error "
      "naming file and line.");
  m.def(
      "parse_yaml",
      [](const std::string& text, const std::string& name) {
        return object_of(document::parse_yaml(text, name));
      },
      py::arg("text"), py::arg("name") = "the text",
      "The same of a text, called `name` in refusals.");
  m.def(
      "json_as_yaml",
      [](const std::string& json) {
        return document::yaml_text(document::parse_json(json, "the value"));
      },
      py::arg("json"),
      "A value of JSON in one line of YAML, without the quotes that it does not need.");
}

}  // namespace

void bind_files(py::module_& m) {
  bind_documents(m);
  m.def(
      "read_problem_file", &read_problem_file, py::arg("file"),
      py::call_guard<py::gil_scoped_release>(),
      "Reads a problem file (YAML): a ProblemFile. Relative names in it are looked up in its "
      "folder. Raises Error with one sentence that names the file, the line, the keys that lead to "
      "the place, and what was wanted.");
  m.def(
      "make_guess",
      [](ProblemMachine& machine, const std::optional<WarmStart>& start) {
        const Busy::Lock lock(machine.busy, "make_guess");
        return make_guess(machine.problem, start.value_or(WarmStart{}));
      },
      py::arg("problem"), py::arg("start") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "States (N + 1, nx) and controls (N, max_controls) to start from: a TrajectoryGuess. Raises "
      "Error where a file cannot be read or does not fit the problem.");
}

}  // namespace burnish::python

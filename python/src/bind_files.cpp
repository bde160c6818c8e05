// Problems in files.
#include "bind.hpp"
#include "machine_ocp.hpp"
#include "specs_files.hpp"

namespace burnish::python {

void bind_files(py::module_& m) {
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

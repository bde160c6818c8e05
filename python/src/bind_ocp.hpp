// Bindings of the parts of the ocp layer, in separate files.
#pragma once

#include "arrays.hpp"
#include "machine_ocp.hpp"

namespace burnish::python {

using ProblemClass = py::class_<ProblemMachine>;

void bind_problem(py::module_& m);
void bind_trajectory(ProblemClass& c);

}  // namespace burnish::python

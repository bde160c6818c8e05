// The parts of bind_ocp.cpp that are files of their own.
#pragma once

#include "arrays.hpp"
#include "machine_ocp.hpp"

namespace burnish::python {

using ProblemClass = py::class_<ProblemMachine>;

void bind_problem(py::module_& m);
void bind_trajectory(ProblemClass& c);

}  // namespace burnish::python

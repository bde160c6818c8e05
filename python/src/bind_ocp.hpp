// Bindings of the parts of the ocp layer, in separate files.
#pragma once

#include <string>
#include <variant>

#include "arrays.hpp"
#include "machine_ocp.hpp"

namespace burnish::python {

using ProblemClass = py::class_<ProblemMachine>;

/// Index or name of a stage, a term, a contact or an input.
using Name = std::variant<int, std::string>;

/// Throws Error("<call>: ...") unless an argument has the wanted number of entries.
void check_size(const char* call, const char* argument, Eigen::Index came, int wanted_size);

void bind_problem(py::module_& m);
void bind_inputs(ProblemClass& c);
void bind_trajectory(ProblemClass& c);

}  // namespace burnish::python

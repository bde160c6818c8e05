// Differential dynamic programming.
#include "bind.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

void bind_solver(py::module_& /*m*/) {}

}  // namespace burnish::python

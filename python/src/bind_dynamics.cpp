// Where frames are, and what their motions are written in.
#include "bind.hpp"
#include "specs_dynamics.hpp"

namespace burnish::python {

void bind_dynamics(py::module_& /*m*/) {}

}  // namespace burnish::python

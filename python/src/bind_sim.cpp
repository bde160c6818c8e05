// Plants, disturbances, closed loops.
#include "bind.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

void bind_sim(py::module_& /*m*/) {}

}  // namespace burnish::python

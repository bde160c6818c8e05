// Optimal control problems: residuals, costs, stages, horizons, the checker.
#include "bind.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

void bind_ocp(py::module_& /*m*/) {}

}  // namespace burnish::python

// Contact dynamics with all derivatives, batches of states, the checker.
#include "bind.hpp"
#include "specs_derivatives.hpp"

namespace burnish::python {

void bind_derivatives(py::module_& /*m*/) {}

}  // namespace burnish::python

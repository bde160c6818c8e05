// The polishing task: what it is, its runs and experiments.
#include "bind.hpp"
#include "specs_polishing.hpp"

namespace burnish::python {

void bind_polishing(py::module_& /*m*/) {}

}  // namespace burnish::python

// The measures of a run.
#include "bind.hpp"
#include "specs_report.hpp"

namespace burnish::python {

void bind_report(py::module_& /*m*/) {}

}  // namespace burnish::python

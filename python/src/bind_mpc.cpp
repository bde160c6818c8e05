// Model predictive control.
#include "bind.hpp"
#include "specs_mpc.hpp"

namespace burnish::python {

void bind_mpc(py::module_& m) { m.def("fault_text", &FaultReport::text, py::arg("report")); }

}  // namespace burnish::python

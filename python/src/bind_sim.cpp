// Plants, disturbances, closed loops.
#include "bind.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

void bind_sim(py::module_& m) {
  m.def("circle_path_at", &CirclePath::at, py::arg("path"), py::arg("t"));
}

}  // namespace burnish::python

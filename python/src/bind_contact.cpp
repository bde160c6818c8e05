// References, directions and forces: what their dataclasses ask the library for.
#include "bind.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

void bind_contact(py::module_& m) {
  m.def("surface_with_normal", &Reference::surface_with_normal, py::arg("normal"));
  m.def("parse_reference", &Reference::parse, py::arg("name"));
  m.def("reference_at", &Reference::at, py::arg("reference"), py::arg("time"));
  m.def("reference_name", &Reference::name, py::arg("reference"));
  m.def("force_in", &ContactForce::in, py::arg("force"), py::arg("reference"));
  m.def("force_axes", &ContactForce::axes, py::arg("force"));
  m.def("force_origin", &ContactForce::origin, py::arg("force"));
  m.def("force_text", &ContactForce::text, py::arg("force"));
}

}  // namespace burnish::python

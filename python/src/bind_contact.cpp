// References, directions and forces: what their dataclasses ask the library for.
#include "bind.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

void bind_contact(py::module_& m) {
  m.def("surface_with_normal", &Reference::surface_with_normal, py::arg("normal"));
  m.def(
      "reference_on",
      [](const Quadric& surface, const Eigen::Vector3d& near,
         const std::optional<Eigen::Vector3d>& along) {
        return along ? Reference::on(surface, near, *along) : Reference::on(surface, near);
      },
      py::arg("surface"), py::arg("near"), py::arg("along") = py::none());
  m.def("quadric_plane", &Quadric::plane, py::arg("point"), py::arg("normal"));
  m.def("quadric_sphere", &Quadric::sphere, py::arg("center"), py::arg("radius"),
        py::arg("hollow"));
  m.def("quadric_cylinder", &Quadric::cylinder, py::arg("point"), py::arg("axis"),
        py::arg("radius"), py::arg("hollow"));
  m.def("quadric_cone", &Quadric::cone, py::arg("apex"), py::arg("axis"), py::arg("half_angle"),
        py::arg("hollow"));
  m.def("quadric_ellipsoid", &Quadric::ellipsoid, py::arg("center"), py::arg("axes"),
        py::arg("semi_axes"), py::arg("hollow"));
  m.def("quadric_osculating", &Quadric::osculating, py::arg("point"), py::arg("axes"),
        py::arg("k_xx"), py::arg("k_xy"), py::arg("k_yy"));
  m.def("quadric_value", &Quadric::value, py::arg("surface"), py::arg("x"));
  m.def("quadric_normal", &Quadric::normal, py::arg("surface"), py::arg("x"));
  m.def("parse_reference", &Reference::parse, py::arg("name"));
  m.def(
      "reference_at", [](const Reference& self, double time) { return self.at(time); },
      py::arg("reference"), py::arg("time"));
  m.def(
      "reference_at_point",
      [](const Reference& self, const Eigen::Vector3d& point) { return self.at(point); },
      py::arg("reference"), py::arg("point"));
  m.def("reference_name", &Reference::name, py::arg("reference"));
  m.def("force_in", &ContactForce::in, py::arg("force"), py::arg("reference"));
  m.def("force_axes", &ContactForce::axes, py::arg("force"));
  m.def("force_origin", &ContactForce::origin, py::arg("force"));
  m.def("force_text", &ContactForce::text, py::arg("force"));
}

}  // namespace burnish::python

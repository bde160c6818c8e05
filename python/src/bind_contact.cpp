// Bindings of references, surfaces, loops and contact forces: functions that their dataclasses
// call.
#include "bind.hpp"
#include "specs_contact.hpp"

namespace burnish::python {
namespace {

// Docstrings.

constexpr const char* loop_contacts_doc =
    R"(Makes one contact per loop of the robot, with the name of the loop.

Parameters
----------
model : Model
gains : LoopGains, optional
    Gains that stabilize the loops.
all_directions : bool
    If False, each contact has independent rows. If True, it has all directions of the description.

Returns
-------
list of ContactSpec)";

constexpr const char* loop_freedom_doc = R"(Counts the degrees of freedom that the loops leave.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.

Returns
-------
LoopFreedom
    Rows of all loops, their rank, remaining degrees of freedom, and redundant rows.)";

constexpr const char* project_onto_loops_doc =
    R"(Closes the loops of a configuration by damped Gauss-Newton steps of minimum norm.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.
options : LoopProjectionOptions, optional

Returns
-------
LoopProjection
    Configuration, and a status that is not OK if the loops are still open.)";

constexpr const char* loop_misses_doc = R"(Returns the closure error of each loop.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.

Returns
-------
list of LoopMiss)";

constexpr const char* project_velocity_doc =
    R"(Projects a velocity onto the velocities that the loops allow.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity.
metric : LoopMetric, optional
    Metric of the distance to v; default: PLAIN.
keep : sequence of str
    Joints whose velocities are kept if the other joints can close the loops.

Returns
-------
ndarray, shape (nv,))";

constexpr const char* closed_configuration_doc =
    R"(Makes a configuration from a posture, and closes the loops.

Parameters
----------
model : Model
posture : dict of str to list of float
    Joint coordinates by name. The joints in it keep their values if the other joints can close
    the loops.

Returns
-------
ndarray, shape (nq,)

Raises
------
Error
    If the loops cannot be closed.)";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

void bind_loops(py::module_& m) {
  m.def(
      "loop_contacts",
      [](const Model& model, const std::optional<LoopGains>& gains, bool all_directions) {
        return loop_contacts(model, gains.value_or(LoopGains{}), all_directions);
      },
      py::arg("model"), py::arg("gains") = py::none(), py::arg("all_directions") = false,
      loop_contacts_doc);
  m.def("loop_freedom", &loop_freedom, py::arg("model"), py::arg("q"), loop_freedom_doc);
  m.def(
      "project_onto_loops",
      [](const Model& model, const Vector& q, const std::optional<LoopProjectionOptions>& options) {
        return project_onto_loops(model, q, options.value_or(LoopProjectionOptions{}));
      },
      py::arg("model"), py::arg("q"), py::arg("options") = py::none(), project_onto_loops_doc);
  m.def("loop_misses", &loop_misses, py::arg("model"), py::arg("q"), loop_misses_doc);
  m.def(
      "project_velocity_onto_loops",
      [](const Model& model, const Vector& q, const Vector& v,
         const std::optional<LoopMetric>& metric, const std::vector<std::string>& keep) {
        return project_velocity_onto_loops(model, q, v, metric.value_or(LoopMetric::Plain), keep);
      },
      py::arg("model"), py::arg("q"), py::arg("v"), py::arg("metric") = py::none(),
      py::arg("keep") = std::vector<std::string>{}, project_velocity_doc);
  m.def(
      "closed_configuration",
      [](const Model& model, const Posture& posture) {
        return closed_configuration(model, posture);
      },
      py::arg("model"), py::arg("posture"), closed_configuration_doc);
  m.def("loop_gains_for_step", &LoopGains::for_step, py::arg("step"));
  m.def("loop_projection_explanation", &LoopProjection::explanation, py::arg("projection"));
}

}  // namespace

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
  bind_loops(m);
}

}  // namespace burnish::python

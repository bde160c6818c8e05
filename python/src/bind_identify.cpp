// Bindings of inertial parameters and their identification.
#include "bind.hpp"
#include "burnish/identify/trial.hpp"
#include "specs_model.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* inertia_parameters_doc = R"(Returns the ten inertial parameters of a body.

Parameters
----------
inertia : InertiaSpec

Returns
-------
ndarray, shape (10,)
    Mass [kg], mass times centre of mass (3) [kg m], and moments xx, xy, xz, yy, yz, zz about the
    origin [kg m^2].)";

constexpr const char* inertia_of_doc = R"(Makes an InertiaSpec from ten inertial parameters.

Parameters
----------
parameters : array_like, shape (10,)
    Parameters in the order of inertia_parameters().

Returns
-------
InertiaSpec)";

constexpr const char* inertia_of_body_doc = R"(Returns the inertia of the body that a joint moves.

Parameters
----------
model : Model
body : int
    Index of the joint.

Returns
-------
InertiaSpec)";

constexpr const char* inertia_problem_doc = R"(Checks whether a solid body can have an inertia.

Parameters
----------
inertia : InertiaSpec

Returns
-------
str
    Sentence with the reason why no solid has this inertia; empty if a solid can have it.)";

constexpr const char* with_payload_doc = R"(Returns a model with an additional payload.

Parameters
----------
model : Model
frame : str
    Frame of the payload.
inertia : InertiaSpec
    Inertia of the payload, in the axes of the frame.

Returns
-------
Model)";

constexpr const char* identify_doc =
    R"(Estimates inertias from a motion without contact. See docs/identification.md.

Parameters
----------
model : Model
q : array_like, shape (n, nq)
    Measured positions. A continuous joint can have one column with its angle in place of its cosine
    and sine.
tau : array_like, shape (n, nv)
    Measured torques [Nm or N].
period : float
    Time between samples [s].
bodies : sequence of str
    Links whose inertias are estimated; empty: only the payload.
payload : str
    Frame of the payload, if `bodies` is empty.
friction, armature, offset, delay : bool
    Whether joint friction, armature, torque offsets and the delay of torques are estimated too.
motion_window : float
    Window of the polynomials that differentiate the motion [s].
window : float
    Window for the smoothing of torques [s].
start : float
    Duration at the start of the record that is not used [s].
torque_noise : float
    Standard deviation of the noise of a torque sample [Nm or N]; 0: estimated.

Returns
-------
Identification

Raises
------
Error
    If the record is implausible, for example in other units; the message has the column, the
    time and the probable cause.)";

constexpr const char* excitation_doc =
    R"(Plans a motion from rest to rest that excites the inertia of a payload. Obstacles are not
considered.

Parameters
----------
model : Model
q_start : array_like, shape (nq,)
    Configuration at the start.
frame : str
    Frame of the payload.
duration : float
    Duration of the motion [s].
highest : float
    Highest frequency [Hz].
range : float
    Largest distance of a joint from its start position [rad or m].
seed : int
    Seed of the random motion.
period : float
    Time between samples of the result [s].
effort_share : float
    Fraction of the effort limits that the motion may use, without the torque of the payload.

Returns
-------
Trace
    Columns time, q_, v_ and a_ of each joint. Continuous joints have angles [rad].

Warns
-----
UserWarning
    If an effort limit makes the motion smaller than `range` and the speed limits allow.)";

using Matrix = Eigen::Ref<const RowMatrix>;

py::dict named(const Vector10& values) {
  py::dict result;
  for (std::size_t i = 0; i < 10; ++i)
    result[py::str(std::string(estimate_names[i]))] = values[static_cast<Eigen::Index>(i)];
  return result;
}

/// Returns two arrays, values and standard deviations; None without estimates.
py::object arrays_of(const std::vector<Estimate>& estimates) {
  if (estimates.empty()) return py::none();
  Eigen::VectorXd values(static_cast<Eigen::Index>(estimates.size())), sigma(values);
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    values[static_cast<Eigen::Index>(i)] = estimates[i].value;
    sigma[static_cast<Eigen::Index>(i)] = estimates[i].sigma;
  }
  return py::cast(std::pair{values, sigma});
}

void bind_inertia(py::module_& m) {
  m.def("inertia_parameters", &inertia_parameters, py::arg("inertia"), inertia_parameters_doc);
  m.def("inertia_of", &inertia_of, py::arg("parameters"), inertia_of_doc);
  m.def(
      "inertia_of_body", [](const Model& model, int body) { return inertia_of_body(model, body); },
      py::arg("model"), py::arg("body"), inertia_of_body_doc);
  m.def("inertia_problem", &inertia_problem, py::arg("inertia"), inertia_problem_doc);
  m.def(
      "with_payload",
      [](const Model& model, const std::string& frame, const InertiaSpec& inertia) {
        return with_payload(model, {frame, inertia});
      },
      py::arg("model"), py::arg("frame"), py::arg("inertia"), with_payload_doc);
}

void bind_results(py::module_& m) {
  using E = EstimatedInertia;
  py::class_<E>(m, "EstimatedInertia", "Inertia estimated from a motion, in the axes of `frame`.")
      .def_readonly("frame", &E::frame, "Name of the link, or of the frame of the payload.")
      .def_readonly("inertia", &E::inertia, "Estimated InertiaSpec, always physically possible.")
      .def_property_readonly(
          "values", [](const E& e) { return named(e.values); },
          "Estimates by name: mass [kg], com [m], moments about com [kg m^2].")
      .def_property_readonly(
          "sigma", [](const E& e) { return named(e.sigma); },
          "Standard deviations of the estimates, by name.")
      .def_property_readonly(
          "not_shown",
          [](const E& e) {
            std::vector<std::string> names;
            for (const int i : e.not_shown())
              names.emplace_back(estimate_names[static_cast<std::size_t>(i)]);
            return names;
          },
          "Names of the values that the motion does not determine.");
  using I = Identification;
  py::class_<I>(m, "Identification", "Result of identify().")
      .def_readonly("inertias", &I::inertias, "EstimatedInertia of each requested body.")
      .def_property_readonly(
          "viscous", [](const I& i) { return arrays_of(i.viscous); },
          "Viscous friction and its standard deviations, two arrays of shape (nv,) [Nms/rad or "
          "Ns/m], or None.")
      .def_property_readonly(
          "coulomb", [](const I& i) { return arrays_of(i.coulomb); },
          "Coulomb friction and its standard deviations, two arrays of shape (nv,) [Nm or N], or "
          "None.")
      .def_property_readonly(
          "armature", [](const I& i) { return arrays_of(i.armature); },
          "Armature and its standard deviations, two arrays of shape (nv,) [kg m^2 or kg], or "
          "None.")
      .def_property_readonly(
          "offset", [](const I& i) { return arrays_of(i.offset); },
          "Torque offsets and their standard deviations, two arrays of shape (nv,) [Nm or N], or "
          "None.")
      .def_property_readonly(
          "delay",
          [](const I& i) {
            return std::pair{i.delay.value, i.delay.sigma};
          },
          "Delay of the torques relative to the positions, and its standard deviation [s].")
      .def_readonly("rms_before", &I::rms_before,
                    "RMS torque residual of the original model, shape (nv,) [Nm or N].")
      .def_readonly("rms_after", &I::rms_after,
                    "RMS torque residual with the estimates, shape (nv,) [Nm or N].")
      .def_readonly("rms_expected", &I::rms_expected,
                    "RMS torque residual that noise, smoothing and sampling explain, shape (nv,) "
                    "[Nm or N].")
      .def_readonly("samples", &I::samples, "Number of used samples of each torque.")
      .def_readonly("converged", &I::converged, "True if the estimate converged.")
      .def_readonly("warnings", &I::warnings, "Warnings, one sentence each.");
}

}  // namespace

void bind_identify(py::module_& m) {
  bind_inertia(m);
  bind_results(m);
  m.def(
      "identify",
      [](const Model& model, const Matrix& q, const Matrix& tau, double period,
         const std::vector<std::string>& bodies, const std::string& payload, bool friction,
         bool armature, bool offset, bool delay, double motion_window, double window, double start,
         double torque_noise) {
        const py::gil_scoped_release release;
        return identify(model, {period, q, tau},
                        {bodies, payload, friction, armature, offset, delay, motion_window, window,
                         start, torque_noise});
      },
      py::arg("model"), py::arg("q"), py::arg("tau"), py::arg("period"),
      py::arg("bodies") = std::vector<std::string>(), py::arg("payload") = "tool",
      py::arg("friction") = false, py::arg("armature") = false, py::arg("offset") = false,
      py::arg("delay") = true, py::arg("motion_window") = 0.04, py::arg("window") = 0.25,
      py::arg("start") = 0.0, py::arg("torque_noise") = 0.0, identify_doc);
  m.def(
      "excitation",
      [](const Model& model, const Eigen::VectorXd& q_start, const std::string& frame,
         double duration, double highest, double range, std::uint64_t seed, double period,
         double effort_share) {
        ExcitationSpec spec;
        spec.duration = duration;
        spec.highest = highest;
        spec.range = range;
        spec.seed = seed;
        spec.effort_share = effort_share;
        py::gil_scoped_release release;
        const Excitation motion(model, q_start, frame, spec);
        const Trace trace = motion.trace(period);
        const py::gil_scoped_acquire acquire;
        for (const std::string& warning : motion.warnings())
          if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0)
            throw py::error_already_set();
        return trace;
      },
      py::arg("model"), py::arg("q_start"), py::arg("frame") = "tool", py::arg("duration") = 10.0,
      py::arg("highest") = 0.7, py::arg("range") = 0.8, py::arg("seed") = 1,
      py::arg("period") = 1e-3, py::arg("effort_share") = 0.8, excitation_doc);
}

}  // namespace burnish::python

// Mass distributions as numbers, and their identification from recorded motions.
#include "bind.hpp"
#include "burnish/identify/trial.hpp"
#include "specs_model.hpp"
#include "specs_sim.hpp"

namespace burnish::python {

namespace {

using Matrix = Eigen::Ref<const RowMatrix>;

py::dict named(const Vector10& values) {
  py::dict result;
  for (std::size_t i = 0; i < 10; ++i)
    result[py::str(std::string(estimate_names[i]))] = values[static_cast<Eigen::Index>(i)];
  return result;
}

/// values and standard deviations, two arrays.
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
  m.def(
      "inertia_parameters", &inertia_parameters, py::arg("inertia"),
      "(10,): mass, mass times centre, and xx xy xz yy yz zz about the origin, of an InertiaSpec.");
  m.def("inertia_of", &inertia_of, py::arg("parameters"),
        "The InertiaSpec that has these ten parameters.");
  m.def(
      "inertia_of_body", [](const Model& model, int body) { return inertia_of_body(model, body); },
      py::arg("model"), py::arg("body"), "Of the body that a joint (its number) carries.");
  m.def("inertia_problem", &inertia_problem, py::arg("inertia"),
        "Why no solid has it, one sentence; empty where one has.");
  m.def(
      "with_payload",
      [](const Model& model, const std::string& frame, const InertiaSpec& inertia) {
        return with_payload(model, {frame, inertia});
      },
      py::arg("model"), py::arg("frame"), py::arg("inertia"),
      "The model with what it carries at a frame, in the frame's axes, beside its own.");
}

void bind_results(py::module_& m) {
  using E = EstimatedInertia;
  py::class_<E>(m, "EstimatedInertia", "A mass distribution from a motion, in the axes of `frame`.")
      .def_readonly("frame", &E::frame, "The link, or the frame of the payload.")
      .def_readonly("inertia", &E::inertia, "InertiaSpec: a solid has it.")
      .def_property_readonly(
          "values", [](const E& e) { return named(e.values); },
          "By name: mass (kg), com (m), moments about com (kg m^2).")
      .def_property_readonly(
          "sigma", [](const E& e) { return named(e.sigma); }, "Their standard deviations.")
      .def_property_readonly(
          "not_shown",
          [](const E& e) {
            std::vector<std::string> names;
            for (const int i : e.not_shown())
              names.emplace_back(estimate_names[static_cast<std::size_t>(i)]);
            return names;
          },
          "Names of the values that the motion does not show.");
  using I = Identification;
  py::class_<I>(m, "Identification", "What identify() found.")
      .def_readonly("inertias", &I::inertias, "An EstimatedInertia for each that was asked for.")
      .def_property_readonly(
          "viscous", [](const I& i) { return arrays_of(i.viscous); },
          "Values and standard deviations (nv,) each, Nms/rad (Ns/m), or None.")
      .def_property_readonly(
          "coulomb", [](const I& i) { return arrays_of(i.coulomb); }, "Likewise, Nm (N).")
      .def_property_readonly(
          "armature", [](const I& i) { return arrays_of(i.armature); }, "Likewise, kg m^2 (kg).")
      .def_property_readonly(
          "offset", [](const I& i) { return arrays_of(i.offset); }, "Likewise, Nm (N).")
      .def_property_readonly(
          "delay",
          [](const I& i) {
            return std::pair{i.delay.value, i.delay.sigma};
          },
          "s of torques behind positions, and its standard deviation.")
      .def_readonly("rms_before", &I::rms_before, "(nv,), Nm (N), that the model leaves.")
      .def_readonly("rms_after", &I::rms_after, "(nv,), Nm (N), that what was found leaves.")
      .def_readonly("rms_expected", &I::rms_expected,
                    "(nv,), Nm (N), that noise, smoothing and sampling explain.")
      .def_readonly("samples", &I::samples, "Of each torque, that were used.")
      .def_readonly("converged", &I::converged, "Whether the estimate settled.")
      .def_readonly("warnings", &I::warnings, "Sentences.");
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
      py::arg("start") = 0.0, py::arg("torque_noise") = 0.0,
      "Mass distributions from a motion in the air: q (n, nq) and tau (n, nv), `period` s apart; "
      "q may have one angle for each continuous joint in place of its cosine and sine; "
      "of the links `bodies`, or of what is carried at the frame `payload`. Raises Error, naming "
      "column, time and guess, for a record that cannot be right, such as one in other units. See "
      "docs/identification.md.");
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
      py::arg("period") = 1e-3, py::arg("effort_share") = 0.8,
      "A motion from rest to rest that shows what is carried at a frame: a Trace with time, q_, v_ "
      "and a_ columns of each joint, angles [rad] of continuous joints too. It knows no "
      "obstacles. Warns where an effort limit makes it smaller than range and speeds allow.");
}

}  // namespace burnish::python

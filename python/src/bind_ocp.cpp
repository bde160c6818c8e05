// Optimal control problems: residuals, costs, stages, horizons, the checker.
#include "bind_ocp.hpp"

#include "bind.hpp"
#include "node_handle.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

void bind_node_view(py::module_& m) {
  py::class_<NodeHandle, std::shared_ptr<NodeHandle>>(
      m, "NodeView",
      "One knot as a residual of the user's own sees it. Valid inside the call that it comes with; "
      "frames and contacts go by name, or by place in the lists that the residual declares. Arrays "
      "are copies.")
      .def_property_readonly(
          "layout", [](const NodeHandle& at) { return at.view().layout(); },
          "Where the parts of z = (du, dq, dv, dtau) start: a StateLayout.")
      .def_property_readonly(
          "time", [](const NodeHandle& at) { return at.view().time(); }, "s.")
      .def_property_readonly(
          "q", [](const NodeHandle& at) { return copied(at.view().q()); }, "(nq,).")
      .def_property_readonly(
          "v", [](const NodeHandle& at) { return copied(at.view().v()); }, "(nv,).")
      .def_property_readonly(
          "u", [](const NodeHandle& at) { return copied(at.view().u()); },
          "(nu,), zero at the end of the horizon.")
      .def_property_readonly(
          "tau", [](const NodeHandle& at) { return copied(at.view().tau()); },
          "(nv,), what the actuators apply, Nm (N).")
      .def_property_readonly(
          "acceleration", [](const NodeHandle& at) { return copied(at.view().acceleration()); },
          "(nv,), rad/s^2 (m/s^2); zero where nothing solves for it (impacts, the end of the "
          "horizon).")
      .def(
          "placement",
          [](const NodeHandle& at, const NodeHandle::Place& frame) {
            return at.view().placement(at.frame(frame));
          },
          py::arg("frame"), "(4, 4), of the frame in the world, m.")
      .def(
          "velocity",
          [](const NodeHandle& at, const NodeHandle::Place& frame, const Reference& reference) {
            return at.view().velocity(at.frame(frame), reference);
          },
          py::arg("frame"), py::arg("reference"), "(6,), m/s and rad/s, in that reference.")
      .def(
          "force",
          [](const NodeHandle& at, const NodeHandle::Place& contact) {
            return copied(at.view().force(at.contact(contact)));
          },
          py::arg("contact"), "(rows held,), force of a contact in its own reference, N and Nm.")
      .def(
          "jacobian",
          [](const NodeHandle& at, const NodeHandle::Place& frame, const Reference& reference) {
            return copied(at.view().jacobian(at.frame(frame), reference));
          },
          py::arg("frame"), py::arg("reference"),
          "(6, nv), d(velocity)/dv in that reference; its linear rows in 'centered' are dp/dq.")
      .def(
          "force_derivative",
          [](const NodeHandle& at, const NodeHandle::Place& contact) {
            const int place = at.contact(contact);
            if (!at.with_derivatives())
              throw Error("NodeView.force_derivative: asked for by value; only jacobian has it");
            return copied(at.view().force_derivative(place));
          },
          py::arg("contact"), "(rows held, nz), d(force)/dz; inside jacobian only.")
      .def("__repr__", [](const NodeHandle&) { return "<NodeView>"; });
}

void bind_check(py::module_& m) {
  m.def(
      "check_problem",
      [](ProblemMachine& machine, const std::optional<ProblemCheckOptions>& given) {
        const Busy::Lock lock(machine.busy, "check_problem");
        ProblemCheckOptions options = given.value_or(ProblemCheckOptions{});
        options.progress = [progress = options.progress](int done, int total) {
          let_signals_through();
          if (progress) progress(done, total);
        };
        const py::gil_scoped_release release;
        return check_problem(machine.problem, options);
      },
      py::arg("problem"), py::arg("options") = py::none(),
      "Compares at random states, for every stage and the terminal state, the derivatives of the "
      "next state, of every residual and of the costs with differences of the values: a "
      "ProblemReport. Raises Error for options that cannot be used, and when the states of a stage "
      "cannot be evaluated.");
  m.def(
      "complaints",
      [](ProblemMachine& machine) {
        const Busy::Lock lock(machine.busy, "complaints");
        return complaints(machine.problem);
      },
      py::arg("problem"), py::call_guard<py::gil_scoped_release>(),
      "Sentences about what will not go well: targets that are not finite or out of reach, initial "
      "states outside limits, bounds that cannot hold the initial posture, redundant contacts with "
      "mu = 0. Empty when nothing was found.");
  m.def("problem_report_text", &ProblemReport::text, py::arg("report"));
  m.def(
      "check_steps",
      [](ProblemMachine& machine, const Eigen::Ref<const RowMatrix>& xs,
         const Eigen::Ref<const RowMatrix>& us) {
        const Busy::Lock lock(machine.busy, "check_steps");
        const py::gil_scoped_release release;
        return check_steps(machine.problem, {xs.data(), xs.rows(), xs.cols()},
                           {us.data(), us.rows(), us.cols()});
      },
      py::arg("problem"), py::arg("xs"), py::arg("us"),
      "Integrates every knot of a trajectory (xs: (N + 1, nx), us: (N, nu)) again in small steps, "
      "from its state with its control held, and compares with the problem's own step: a "
      "StepReport. Raises Error for other sizes.");
  m.def(
      "step_complaints",
      [](ProblemMachine& machine) {
        const Busy::Lock lock(machine.busy, "step_complaints");
        return step_complaints(machine.problem);
      },
      py::arg("problem"), py::call_guard<py::gil_scoped_release>(),
      "Of the complaints() those about what the steps of a stage are too long for: gains of "
      "contacts, friction of tools, damping, friction and springs of joints.");
  m.def("step_report_text", &StepReport::text, py::arg("report"));
  m.def("step_report_warning", &StepReport::warning, py::arg("report"));
}

}  // namespace

void bind_ocp(py::module_& m) {
  bind_node_view(m);
  bind_problem(m);
  bind_check(m);
}

}  // namespace burnish::python

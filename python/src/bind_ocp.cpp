// Bindings of optimal control problems: view of a knot, checks.
#include "bind_ocp.hpp"

#include "bind.hpp"
#include "node_handle.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* check_problem_doc =
    R"(Compares the derivatives of a problem with finite differences at random states.

The check covers the next state, all residuals and all costs, for each stage and the terminal knot.

Parameters
----------
problem : Problem
options : ProblemCheckOptions, optional

Returns
-------
ProblemReport

Raises
------
Error
    If the options are invalid, or the states of a stage cannot be evaluated.)";

constexpr const char* complaints_doc = R"(Checks a problem for probable mistakes.

The check covers targets that are not finite or out of reach, initial states outside limits, control
bounds that cannot hold the initial posture, and redundant contacts with mu = 0.

Parameters
----------
problem : Problem

Returns
-------
list of str
    One sentence per problem; empty if none was found.)";

constexpr const char* check_steps_doc =
    R"(Compares the step of each knot of a trajectory with an integration in small steps.

Parameters
----------
problem : Problem
xs : array_like, shape (N + 1, nx)
    States; each step starts at its state.
us : array_like, shape (N, nu)
    Controls, constant during a step.

Returns
-------
StepReport

Raises
------
Error
    If the sizes are wrong.)";

constexpr const char* step_complaints_doc =
    R"(Returns the complaints() about steps that are too long.

Reasons are gains of contacts, friction of tools, and damping, friction and springs of joints.

Parameters
----------
problem : Problem

Returns
-------
list of str)";

using NodeClass = py::class_<NodeHandle, std::shared_ptr<NodeHandle>>;

void bind_node_state(NodeClass& of) {
  of.def_property_readonly(
        "layout", [](const NodeHandle& at) { return at.view().layout(); },
        "StateLayout with the first columns of the parts of z = (du, dq, dv, dtau).")
      .def_property_readonly(
          "time", [](const NodeHandle& at) { return at.view().time(); }, "s.")
      .def_property_readonly(
          "q", [](const NodeHandle& at) { return copied(at.view().q()); }, "(nq,).")
      .def_property_readonly(
          "v", [](const NodeHandle& at) { return copied(at.view().v()); }, "(nv,).")
      .def_property_readonly(
          "u", [](const NodeHandle& at) { return copied(at.view().u()); },
          "Controls, shape (nu,); zero at the end of the horizon.")
      .def_property_readonly(
          "tau", [](const NodeHandle& at) { return copied(at.view().tau()); },
          "Torques of the actuators, shape (nv,) [Nm or N].")
      .def_property_readonly(
          "acceleration", [](const NodeHandle& at) { return copied(at.view().acceleration()); },
          "Joint accelerations, shape (nv,) [rad/s^2 or m/s^2]; zero for impacts and at the end "
          "of the horizon.");
}

void bind_node_frames(NodeClass& of) {
  of.def(
        "placement",
        [](const NodeHandle& at, const NodeHandle::Place& frame) {
          return at.view().placement(at.frame(frame));
        },
        py::arg("frame"), "Returns the placement of a frame in the world, shape (4, 4) [m].")
      .def(
          "velocity",
          [](const NodeHandle& at, const NodeHandle::Place& frame, const Reference& reference) {
            return at.view().velocity(at.frame(frame), reference);
          },
          py::arg("frame"), py::arg("reference"),
          "Returns the velocity of a frame in a reference, shape (6,) [m/s, rad/s].")
      .def(
          "force",
          [](const NodeHandle& at, const NodeHandle::Place& contact) {
            return copied(at.view().force(at.contact(contact)));
          },
          py::arg("contact"),
          "Returns the force of a contact in its own reference, shape (rows,) [N, Nm].")
      .def(
          "jacobian",
          [](const NodeHandle& at, const NodeHandle::Place& frame, const Reference& reference) {
            return copied(at.view().jacobian(at.frame(frame), reference));
          },
          py::arg("frame"), py::arg("reference"),
          "Returns d(velocity)/dv of a frame in a reference, shape (6, nv). Its linear rows in "
          "\"centered\" are dp/dq.")
      .def(
          "force_derivative",
          [](const NodeHandle& at, const NodeHandle::Place& contact) {
            const int place = at.contact(contact);
            if (!at.with_derivatives())
              throw Error(
                  "NodeView.force_derivative: called in value(); wanted a call in jacobian()");
            return copied(at.view().force_derivative(place));
          },
          py::arg("contact"),
          "Returns d(force)/dz of a contact, shape (rows, nz); only in jacobian().")
      .def("__repr__", [](const NodeHandle&) { return "<NodeView>"; });
}

void bind_node_view(py::module_& m) {
  NodeClass of(
      m, "NodeView",
      "View of one knot for a user-defined residual. It is valid only during the call. Frames and "
      "contacts are selected by name, or by index in the lists of the residual. Arrays are "
      "copies.");
  bind_node_state(of);
  bind_node_frames(of);
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
      py::arg("problem"), py::arg("options") = py::none(), check_problem_doc);
  m.def(
      "complaints",
      [](ProblemMachine& machine) {
        const Busy::Lock lock(machine.busy, "complaints");
        return complaints(machine.problem);
      },
      py::arg("problem"), py::call_guard<py::gil_scoped_release>(), complaints_doc);
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
      py::arg("problem"), py::arg("xs"), py::arg("us"), check_steps_doc);
  m.def(
      "step_complaints",
      [](ProblemMachine& machine) {
        const Busy::Lock lock(machine.busy, "step_complaints");
        return step_complaints(machine.problem);
      },
      py::arg("problem"), py::call_guard<py::gil_scoped_release>(), step_complaints_doc);
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

// Model predictive control.
#include "bind.hpp"
#include "loop_parts.hpp"
#include "machine_ocp.hpp"

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

void bind_controller(py::module_& m) {
  py::class_<BoundController>(m, "CompiledController",
                              "A controller of the library; see burnish.Controller.")
      .def_property_readonly(
          "nv", [](const BoundController& self) { return self.controller->nv(); },
          "Torques of a command.")
      .def(
          "reset",
          [](BoundController& self) {
            const Busy::Lock lock(self.busy, "Controller.reset");
            self.controller->reset();
            (void)self.take_exception();
          },
          "Forgets all ticks before.")
      .def(
          "tick",
          [](BoundController& self, const Measurement& measurement) {
            Command command;
            const py::gil_scoped_release release;
            const Busy::Lock lock(self.busy, "Controller.tick");
            command = self.controller->tick(measurement);
            if (const std::exception_ptr thrown = self.take_exception())
              std::rethrow_exception(thrown);
            return command;
          },
          py::arg("measurement"),
          "The command that follows a measurement, at once. Numerical trouble shows in its "
          "status, and its torque is one that can be applied. What a function of the "
          "specification raised is raised here, after the tick went on without it.")
      .def("__repr__", [](const BoundController& self) {
        return "<Controller of " + std::to_string(self.controller->nv()) + " torques>";
      });
}

void bind_schedule(py::module_& m) {
  py::class_<Schedule>(m, "Schedule",
                       "A clock that runs along phases. Its time is the time of a task's targets.")
      .def(py::init<std::vector<SchedulePhase>>(), py::arg("phases"),
           "Raises Error for no phases, durations that are not positive, an infinite one before "
           "the last, and a hold that is not a positive time where contact is waited for.")
      .def_property_readonly(
          "phases", [](const Schedule& self) { return self.phases(); }, "As given.")
      .def(
          "start_of",
          [](const Schedule& self, int phase) {
            if (phase < 0 || phase >= static_cast<int>(self.phases().size()))
              throw Error("Schedule.start_of: there is no phase " + std::to_string(phase));
            return self.start_of(phase);
          },
          py::arg("phase"), "Planned start of a phase, s.")
      .def("reset", &Schedule::reset, "Back to time zero.")
      .def("advance", &Schedule::advance, py::arg("dt"), py::arg("contact"),
           "Lets dt s pass. True if the clock jumped or stood still.")
      .def(
          "jump_to",
          [](Schedule& self, int phase) {
            if (phase < 0)
              throw Error("Schedule.jump_to: there is no phase " + std::to_string(phase));
            self.jump_to(phase);
          },
          py::arg("phase"), "Goes to the start of a phase; past the last one, to the last one.")
      .def_property_readonly("time", &Schedule::time, "s.")
      .def_property_readonly("waits", &Schedule::waits,
                             "The last advance() found the clock standing still for contact.")
      .def_property_readonly("phase", &Schedule::phase, "Index of the phase now.")
      .def("phase_at", &Schedule::phase_at, py::arg("time"),
           "Index of the phase at a time of the clock; the last one after the end.")
      .def_property_readonly("finished", &Schedule::finished,
                             "All phases of finite duration are over.")
      .def("__copy__", [](const Schedule& self) { return self; })
      .def("__deepcopy__", [](const Schedule& self, const py::dict&) { return self; })
      .def("__repr__", [](const Schedule& self) {
        return "<Schedule: phase " + std::to_string(self.phase()) + " of " +
               std::to_string(self.phases().size()) + " at " + std::to_string(self.time()) + " s>";
      });
}

void bind_observer(py::module_& m) {
  py::class_<TorqueErrorObserver>(
      m, "TorqueErrorObserver",
      "An observer of the joint velocity with the torque error d of M a + b = tau + J^T f + d as "
      "its disturbance state, critically damped at the bandwidth: after 4.8 / bandwidth s a "
      "constant error is known to 5 %.")
      .def(py::init([](const Model& model, const std::string& tool,
                       const std::optional<ModelErrorOptions>& options) {
             return TorqueErrorObserver(model, tool, options.value_or(ModelErrorOptions{}));
           }),
           py::arg("model"), py::arg("tool") = "tool", py::arg("options") = py::none(),
           "tool: frame that the force acts at. Raises Error for an unknown frame and options out "
           "of range.")
      .def("reset", &TorqueErrorObserver::reset, "Forgets all measurements.")
      .def(
          "update",
          [](TorqueErrorObserver& self, const Vector& q, const Vector& v, const Vector& tau,
             const Eigen::Vector3d& force_world, double dt) {
            const Status status = self.update(q, v, tau, force_world, dt);
            require(status, "TorqueErrorObserver.update");
            return status;
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), py::arg("force_world"), py::arg("dt"),
          "A measurement, dt s after the last one: q (nq,), v (nv,), and what has acted since: "
          "joint torques tau (nv,) and the force on the tool (3,; N, world axes). The first one "
          "after reset() only sets the velocity. Raises EvaluationError for a measurement that "
          "cannot be evaluated; it then changes nothing.")
      .def_property_readonly(
          "torque_error", [](const TorqueErrorObserver& self) { return self.torque_error(); },
          "d (nv,), Nm or N.")
      .def("__repr__", [](const TorqueErrorObserver& self) {
        return "<TorqueErrorObserver of " + std::to_string(self.torque_error().size()) +
               " torques>";
      });
}

void bind_mpc_controller(py::module_& m) {
  py::class_<BoundMpc, BoundController>(
      m, "MpcController",
      "Model predictive control of a contact task. A new controller is ready; reset() makes it so "
      "again, and the same measurements then give the same torques to the last bit. tick() is to "
      "be called once per tick_period; the first call solves the problem to its end. An update "
      "that fails is bridged by the plan before it; the first fault latches the fallback until "
      "reset(). What targets and residuals raise fails the update, and is raised by tick(), or by "
      "the run of a ClosedLoop.")
      .def(py::init([](const MpcSpec& spec) {
             const py::gil_scoped_release release;
             return std::make_unique<BoundMpc>(spec);
           }),
           py::arg("spec"),
           "Raises Error with one sentence for a specification that does not fit together.")
      .def_property_readonly(
          "spec", [](const BoundMpc& self) { return self.spec(); }, "As given: a copy.")
      .def_property_readonly(
          "problem",
          [](const BoundMpc& self) {
            return std::make_unique<ProblemMachine>(self.spec().problem);
          },
          "A Problem of the specification; the controller's own moves with its schedule.")
      .def(
          "fault", [](const BoundMpc& self) { return self.mpc().fault(); },
          "A FaultReport; its kind is NONE until there is a fault.")
      .def(
          "feedback", [](const BoundMpc& self) { return self.mpc().feedback(); },
          "The policy of the last tick, a LinearFeedback.")
      .def_property_readonly(
          "torque_error", [](const BoundMpc& self) { return self.mpc().torque_error(); },
          "(nv,), estimated, Nm or N.")
      .def_property_readonly(
          "force_error", [](const BoundMpc& self) { return self.mpc().force_error(); },
          "N, estimated (ModelErrorKind.FORCE).")
      .def_property_readonly(
          "schedule", [](const BoundMpc& self) { return self.mpc().schedule(); },
          "A copy of the schedule with its clock as it is now.")
      .def(
          "plan", [](const BoundMpc& self) { return copied(self.mpc().plan()); },
          "States of the plan as solved last (N + 1, nx), a copy; with a solver delay not in use "
          "yet.")
      .def(
          "plan_costs",
          [](BoundMpc& self, int knot) {
            const Busy::Lock lock(self.busy, "MpcController.plan_costs");
            std::vector<double> costs;
            {
              const py::gil_scoped_release release;
              costs = self.mpc().plan_costs(knot);
            }
            py::dict named;
            const std::vector<std::string> names = self.mpc().problem().term_names(knot);
            for (std::size_t i = 0; i < costs.size(); ++i) named[py::str(names.at(i))] = costs[i];
            return named;
          },
          py::arg("knot"),
          "Cost of each term by its name at a knot of that plan; the knots' steps are in it.");
}

}  // namespace

void bind_mpc(py::module_& m) {
  bind_controller(m);
  bind_mpc_controller(m);
  bind_schedule(m);
  bind_observer(m);
  m.def("fault_text", &FaultReport::text, py::arg("report"));
}

}  // namespace burnish::python

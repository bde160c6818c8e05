// Model predictive control.
#include "bind.hpp"
#include "burnish/mpc/plan_check.hpp"
#include "loop_parts.hpp"
#include "machine_solver.hpp"

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
           "the last, and a hold that is not a positive time where an event is waited for.")
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
      .def_property_readonly(
          "events", [](const Schedule& self) { return self.events(); },
          "Those that phases wait for, in their order.")
      .def("advance", &Schedule::advance, py::arg("dt"), py::arg("happened"),
           "Lets dt s pass. happened: bit e for entry e of `events`; of one event True will do. "
           "True "
           "if the clock jumped or stood still.")
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
                             "The last advance() found the clock standing still for an event.")
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

struct ObserverMachine {
  explicit ObserverMachine(TorqueErrorObserver made) : observer(std::move(made)) {}
  TorqueErrorObserver observer;
  Busy busy;
};

void bind_observer(py::module_& m) {
  py::class_<ObserverMachine>(
      m, "TorqueErrorObserver",
      "An observer of the joint velocity with the torque error d of M a + b = tau + J^T f + d as "
      "its disturbance state, critically damped at the bandwidth: after 4.8 / bandwidth s a "
      "constant error is known to 5 %.")
      .def(py::init([](const Model& model, const std::string& tool,
                       const std::optional<ModelErrorOptions>& options) {
             return std::make_unique<ObserverMachine>(
                 TorqueErrorObserver(model, tool, options.value_or(ModelErrorOptions{})));
           }),
           py::arg("model"), py::arg("tool") = "tool", py::arg("options") = py::none(),
           "tool: frame that the force acts at. Raises Error for an unknown frame and options out "
           "of range.")
      .def(
          "reset",
          [](ObserverMachine& self) {
            const Busy::Lock lock(self.busy, "TorqueErrorObserver.reset");
            self.observer.reset();
          },
          "Forgets all measurements.")
      .def(
          "update",
          [](ObserverMachine& self, const Vector& q, const Vector& v, const Vector& tau,
             const Eigen::Vector3d& force_world, double dt) {
            const Busy::Lock lock(self.busy, "TorqueErrorObserver.update");
            const py::gil_scoped_release release;
            const Status status = self.observer.update(q, v, tau, force_world, dt);
            require(status, "TorqueErrorObserver.update");
            return status;
          },
          py::arg("q"), py::arg("v"), py::arg("tau"), py::arg("force_world"), py::arg("dt"),
          "A measurement, dt s after the last one: q (nq,), v (nv,), and what has acted since: "
          "joint torques tau (nv,) and the force on the tool (3,; N, world axes). The first one "
          "after reset() only sets the velocity. Raises EvaluationError for a measurement that "
          "cannot be evaluated; it then changes nothing.")
      .def_property_readonly(
          "torque_error",
          [](ObserverMachine& self) {
            const Busy::Lock lock(self.busy, "TorqueErrorObserver.torque_error");
            return self.observer.torque_error();
          },
          "d (nv,), Nm or N.")
      .def("__repr__", [](const ObserverMachine& self) {
        return "<TorqueErrorObserver of " + std::to_string(self.observer.torque_error().size()) +
               " torques>";
      });
}

using PlanClass = py::class_<FeedbackPlan>;

void bind_plan_policy(PlanClass& c) {
  c.def(
       "at",
       [](const FeedbackPlan& self, double time) {
         if (self.empty()) throw Error("FeedbackPlan.at: there is no plan; load one first");
         LinearFeedback feedback = self.make_feedback();
         self.at(time, feedback);
         return feedback;
       },
       py::arg("time"),
       "The policy at a time (s), a LinearFeedback: the controls and gains of the knot that it "
       "falls into, about a state between that knot's and the next one's; the first and the "
       "last beyond the ends. Raises Error while the plan is empty.")
      .def(
          "control",
          [](const FeedbackPlan& self, double time, const Vector& x) {
            if (self.empty()) throw Error("FeedbackPlan.control: there is no plan; load one first");
            LinearFeedback feedback = self.make_feedback();
            if (x.size() != feedback.state.size())
              throw Error("FeedbackPlan.control: a state of " + std::to_string(x.size()) +
                          " numbers; wanted " + std::to_string(feedback.state.size()));
            self.at(time, feedback);
            Eigen::VectorXd u(feedback.feedforward.size());
            self.control(feedback, Eigen::VectorXd(x), u);
            return u;
          },
          py::arg("time"), py::arg("x"),
          "u = feedforward + gain (x (-) state) of that policy (nu,), Nm or N; x: (nx,).");
}

void bind_feedback_plan(py::module_& m) {
  PlanClass c(
      m, "FeedbackPlan",
      "The plan of a solve as a controller between two solves: a copy of the first knots of a "
      "solution and their policy, for a controller of your own.");
  c.def(py::init([](const ProblemMachine& machine, int knots, double step) {
          return FeedbackPlan(machine.problem, knots, step);
        }),
        py::arg("problem"), py::arg("knots"), py::arg("step"), py::keep_alive<1, 2>(),
        "Room for `knots` knots of the problem's horizon, all of them if there are no more; "
        "step: s between them. Raises Error for fewer than one knot and for a step that is not "
        "positive.")
      .def(py::init([](const ProblemMachine& machine, const std::vector<double>& steps) {
             return FeedbackPlan(machine.problem, steps);
           }),
           py::arg("problem"), py::arg("steps"), py::keep_alive<1, 2>(),
           "Room for a knot per step (s), whose lengths may differ; all of the horizon's if there "
           "are no more. Raises Error for no steps and for one that is not positive.")
      .def(
          "load",
          [](FeedbackPlan& self, SolverMachine& machine, double time) {
            const Busy::Lock lock(machine.busy, "FeedbackPlan.load");
            const MatrixView xs = machine.solver.xs();
            const LinearFeedback sizes = self.make_feedback();
            if (xs.rows() <= self.knots() || xs.cols() != sizes.state.size() ||
                machine.solver.us().cols() != sizes.feedforward.size())
              throw Error("FeedbackPlan.load: the solver is of another problem");
            self.load(machine.solver, time);
          },
          py::arg("solver"), py::arg("time"),
          "Copies the trajectory and gains of a DdpSolver of the plan's problem, to hold from "
          "`time` (s) on.")
      .def("clear", &FeedbackPlan::clear, "Forgets the plan.")
      .def_property_readonly("empty", &FeedbackPlan::empty, "Whether there is no plan.")
      .def_property_readonly("knots", &FeedbackPlan::knots, "Knots that it has room for.")
      .def_property_readonly("start", &FeedbackPlan::start, "s.")
      .def(
          "time_of",
          [](const FeedbackPlan& self, int knot) {
            if (knot < 0 || knot > self.knots())
              throw Error("FeedbackPlan.time_of: knot " + std::to_string(knot) + "; wanted 0 to " +
                          std::to_string(self.knots()));
            return self.time_of(knot);
          },
          py::arg("knot"), "s, of a knot, 0 to knots; the last is the end.");
  bind_plan_policy(c);
  c.def("__repr__", [](const FeedbackPlan& self) {
    return "<FeedbackPlan of " + std::to_string(self.knots()) + " knots" +
           (self.empty() ? ", empty>" : ">");
  });
}

/// Reads what a controller holds, which no other thread may be changing.
template <class Get>
auto reading(const char* what, Get get) {
  return [what, get](BoundMpc& self) {
    const Busy::Lock lock(self.busy, what);
    return get(self.mpc());
  };
}

using MpcClass = py::class_<BoundMpc, BoundController>;

void bind_mpc_plan(MpcClass& c) {
  c.def("plan",
        reading("MpcController.plan", [](const MpcController& mpc) { return copied(mpc.plan()); }),
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

void bind_mpc_readings(MpcClass& c) {
  c.def_property_readonly("torque_error",
                          reading("MpcController.torque_error",
                                  [](const MpcController& mpc) { return mpc.torque_error(); }),
                          "(nv,), estimated, Nm or N.")
      .def_property_readonly("force_error",
                             reading("MpcController.force_error",
                                     [](const MpcController& mpc) { return mpc.force_error(); }),
                             "N, estimated (ModelErrorKind.FORCE).")
      .def_property_readonly(
          "support_friction",
          reading("MpcController.support_friction",
                  [](const MpcController& mpc) { return mpc.support_friction(); }),
          "Per support that holds always: the coefficient of friction that plans reckon with, "
          "SlipOptions; infinite without a cone.")
      .def_property_readonly("schedule",
                             reading("MpcController.schedule",
                                     [](const MpcController& mpc) { return mpc.schedule(); }),
                             "A copy of the schedule with its clock as it is now.")
      .def_property_readonly("plan_age",
                             reading("MpcController.plan_age",
                                     [](const MpcController& mpc) { return mpc.plan_age(); }),
                             "s from the measurement that the plan in use was made from to the "
                             "last good one; infinite while there is none.");
}

void bind_mpc_controller(py::module_& m) {
  MpcClass c(
      m, "MpcController",
      "Model predictive control of a task. A new controller is ready; reset() makes it so "
      "again, and the same measurements then give the same torques to the last bit. tick() is to "
      "be called once per tick_period; the first call solves the problem to its end. An update "
      "that fails is bridged by the plan before it; the first fault latches the fallback until "
      "reset(). What targets and residuals raise fails the update, and is raised by tick(), or by "
      "the run of a ClosedLoop.");
  c.def(py::init([](const MpcSpec& spec) {
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
          "set_payload",
          [](BoundMpc& self, const std::string& frame, const InertiaSpec& payload) {
            constexpr const char* call = "MpcController.set_payload";
            const Busy::Lock lock(self.busy, call);
            check_payload(call, payload);
            require(self.mpc().set_payload(frame, payload), call);
          },
          py::arg("frame"), py::arg("payload"),
          "What the robot carries at a frame from the next tick on: an InertiaSpec in the frame's "
          "axes, in the place of what that frame's body carried before. Raises Error where the "
          "base "
          "is estimated (ClosedLoop.estimate_base), which a payload does not reach.")
      .def("fault",
           reading("MpcController.fault", [](const MpcController& mpc) { return mpc.fault(); }),
           "A FaultReport; its kind is NONE until there is a fault.")
      .def("feedback",
           reading("MpcController.feedback",
                   [](const MpcController& mpc) { return mpc.feedback(); }),
           "The policy of the last tick, a LinearFeedback.");
  bind_mpc_readings(c);
  bind_mpc_plan(c);
}

}  // namespace

void bind_mpc(py::module_& m) {
  bind_controller(m);
  bind_mpc_controller(m);
  bind_feedback_plan(m);
  bind_schedule(m);
  bind_observer(m);
  m.def("fault_text", &FaultReport::text, py::arg("report"));
  m.def(
      "step_complaints",
      [](const MpcSpec& spec) {
        const py::gil_scoped_release release;
        return step_complaints(spec);
      },
      py::arg("spec"),
      "The same of a controller's plans, and of the first one what check_steps() says. Solves it.");
}

}  // namespace burnish::python

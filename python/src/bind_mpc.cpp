// Bindings of model predictive control.
#include "bind.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/mpc/plan_check.hpp"
#include "loop_parts.hpp"
#include "machine_solver.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* controller_tick_doc = R"(Computes the command for a measurement.

If a function of the specification raised an exception, the tick continues without it, and then
raises the exception.

Parameters
----------
measurement : Measurement

Returns
-------
Command
    Command with a status. Its torque can always be applied.)";

constexpr const char* schedule_advance_doc = R"(Advances the clock.

Parameters
----------
dt : float
    Time step [s].
happened : int or bool
    Bit e is set if event e of `events` has happened; True is accepted for a single event.

Returns
-------
bool
    True if the clock jumped or stood still.)";

constexpr const char* observer_update_doc =
    R"(Updates the observer with a measurement. The first call after reset() only sets the velocity.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity [rad/s or m/s].
tau : array_like, shape (nv,)
    Joint torques since the previous call [Nm or N].
force_world : array_like, shape (3,)
    Force on the tool since the previous call, in world axes [N].
dt : float
    Time since the previous call [s].

Raises
------
EvaluationError
    If the measurement is invalid; the observer does not change.)";

constexpr const char* plan_at_doc = R"(Returns the policy at a time.

Parameters
----------
time : float
    Time [s].

Returns
-------
LinearFeedback
    Controls and gains of the knot before the time, and a state interpolated between that knot
    and the next one. Before and after the plan, it is the policy of the first or last knot.

Raises
------
Error
    If the plan is empty.)";

constexpr const char* plan_control_doc =
    R"(Returns u = feedforward + gain (x (-) state) of the policy at a time.

Parameters
----------
time : float
    Time [s].
x : array_like, shape (nx,)
    State.

Returns
-------
ndarray, shape (nu,)
    Controls [Nm or N].

Raises
------
Error
    If the plan is empty, or the size of x is wrong.)";

constexpr const char* plan_load_doc = R"(Copies the trajectory and gains of a solver.

Parameters
----------
solver : DdpSolver
    Solver of the same problem.
time : float
    Start of the plan [s].)";

constexpr const char* mpc_payload_doc = R"(Sets the payload at a frame from the next tick.

The payload replaces that of the body of the frame. In a ClosedLoop that estimates the base, call
ClosedLoop.set_payload instead.

Parameters
----------
frame : str
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.)";

constexpr const char* plan_complaints_doc =
    R"(Returns sentences about steps that are too long for the plans of a controller.

Solves the first plan, and compares its steps with check_steps().

Parameters
----------
spec : MpcSpec

Returns
-------
list of str)";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

/// Returns the unit of each value that a controller publishes, by name.
std::map<std::string, std::string> signal_units(const BoundController& bound) {
  std::map<std::string, std::string> units;
  for (const TraceColumn& signal : bound.controller->signals()) units[signal.name] = signal.unit;
  return units;
}

/// Returns the values that a controller published at its last tick, by name.
std::map<std::string, double> signal_values(const BoundController& bound) {
  const std::vector<TraceColumn> signals = bound.controller->signals();
  std::vector<double> values(signals.size());
  bound.controller->write_signals(values);
  std::map<std::string, double> by_name;
  for (std::size_t i = 0; i < signals.size(); ++i) by_name[signals[i].name] = values[i];
  return by_name;
}

void bind_controller(py::module_& m) {
  py::class_<BoundController>(m, "CompiledController",
                              "Controller of the library; see burnish.Controller.")
      .def_property_readonly(
          "nv", [](const BoundController& self) { return self.controller->nv(); },
          "Number of torques of a command.")
      .def_property_readonly(
          "touches",
          [](const BoundController& self) {
            std::optional<std::vector<std::string>> frames;
            if (const auto touches = self.controller->touches())
              for (frames.emplace(); const TouchSensor& touch : *touches)
                frames->push_back(touch.frame);
            return frames;
          },
          "Frames of the columns of Measurement.wrenches, as the controller reads them; None: all "
          "touches of the plant's scene, in their order.")
      .def_property_readonly(
          "tools", [](const BoundController& self) { return self.controller->tools(); },
          "Frames of the tools of Command.tools; an empty list stands for one entry, which belongs "
          "to the first tool of the plant's scene.")
      .def_property_readonly(
          "signals", &signal_units,
          "Units of the values that the controller publishes, by name. A loop records each value "
          "in a column 'signal_<name>' of its trace.")
      .def_property_readonly("signal_values", &signal_values,
                             "Values of `signals` at the last tick, by name.")
      .def(
          "reset",
          [](BoundController& self) {
            const Busy::Lock lock(self.busy, "Controller.reset");
            self.controller->reset();
            (void)self.take_exception();
          },
          "Resets the controller to its state before the first tick.")
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
          py::arg("measurement"), controller_tick_doc)
      .def("__repr__", [](const BoundController& self) {
        return "<Controller of " + std::to_string(self.controller->nv()) + " torques>";
      });
}

void bind_schedule(py::module_& m) {
  py::class_<Schedule>(m, "Schedule",
                       "Clock that runs through the phases of a task. Targets of the task are "
                       "functions of its time.")
      .def(py::init<std::vector<SchedulePhase>>(), py::arg("phases"),
           "Raises Error for an empty list, a duration that is not positive, an infinite duration "
           "before the last phase, and a hold time that is not positive in a phase with an event.")
      .def_property_readonly(
          "phases", [](const Schedule& self) { return self.phases(); }, "As given.")
      .def(
          "start_of",
          [](const Schedule& self, int phase) {
            if (phase < 0 || phase >= static_cast<int>(self.phases().size()))
              throw Error("Schedule.start_of: there is no phase " + std::to_string(phase) +
                          "; wanted an index into Schedule.phases");
            return self.start_of(phase);
          },
          py::arg("phase"), "Returns the planned start of a phase [s].")
      .def("reset", &Schedule::reset, "Resets the clock to time zero.")
      .def_property_readonly(
          "events", [](const Schedule& self) { return self.events(); },
          "Events that phases wait for, in the order of the phases.")
      .def("advance", &Schedule::advance, py::arg("dt"), py::arg("happened"), schedule_advance_doc)
      .def(
          "jump_to",
          [](Schedule& self, int phase) {
            if (phase < 0)
              throw Error("Schedule.jump_to: there is no phase " + std::to_string(phase) +
                          "; wanted at least 0");
            self.jump_to(phase);
          },
          py::arg("phase"), "Sets the clock to the start of a phase, at most of the last one.")
      .def_property_readonly("time", &Schedule::time, "s.")
      .def_property_readonly("waits", &Schedule::waits,
                             "True if the clock stood still in the last advance(), waiting for an "
                             "event.")
      .def_property_readonly("phase", &Schedule::phase, "Index of the current phase.")
      .def("phase_at", &Schedule::phase_at, py::arg("time"),
           "Returns the index of the phase at a time of the clock [s]; the last one after the "
           "end.")
      .def_property_readonly("finished", &Schedule::finished,
                             "True if all phases of finite duration have ended.")
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
      "Observer of the joint velocity and the torque error d in M a + b = tau + J^T f + d. It is "
      "critically damped: the estimate of a constant error reaches 95 % after 4.8 / bandwidth "
      "[s].")
      .def(py::init([](const Model& model, const std::string& tool,
                       const std::optional<ModelErrorOptions>& options) {
             return std::make_unique<ObserverMachine>(
                 TorqueErrorObserver(model, tool, options.value_or(ModelErrorOptions{})));
           }),
           py::arg("model"), py::arg("tool") = "tool", py::arg("options") = py::none(),
           "`tool` is the frame at which the force acts. Raises Error for an unknown frame and "
           "options out of range.")
      .def(
          "reset",
          [](ObserverMachine& self) {
            const Busy::Lock lock(self.busy, "TorqueErrorObserver.reset");
            self.observer.reset();
          },
          "Resets the observer.")
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
          observer_update_doc)
      .def_property_readonly(
          "torque_error",
          [](ObserverMachine& self) {
            const Busy::Lock lock(self.busy, "TorqueErrorObserver.torque_error");
            return self.observer.torque_error();
          },
          "Estimated torque error d, shape (nv,) [Nm or N].")
      .def("__repr__", [](const ObserverMachine& self) {
        return "<TorqueErrorObserver of " + std::to_string(self.observer.torque_error().size()) +
               " torques>";
      });
}

using PlanClass = py::class_<FeedbackPlan>;

void bind_plan_policy(PlanClass& c) {
  c.def(
       "at",
       [](FeedbackPlan& self, double time) {
         if (self.empty()) throw Error("FeedbackPlan.at: there is no plan; load one first");
         LinearFeedback feedback = self.make_feedback();
         self.at(time, feedback);
         return feedback;
       },
       py::arg("time"), plan_at_doc)
      .def(
          "control",
          [](FeedbackPlan& self, double time, const Vector& x) {
            if (self.empty()) throw Error("FeedbackPlan.control: there is no plan; load one first");
            LinearFeedback feedback = self.make_feedback();
            if (x.size() != feedback.state.size())
              throw Error("FeedbackPlan.control: the state has " + std::to_string(x.size()) +
                          " entries; wanted " + std::to_string(feedback.state.size()));
            self.at(time, feedback);
            Eigen::VectorXd u(feedback.feedforward.size());
            self.control(feedback, Eigen::VectorXd(x), u);
            return u;
          },
          py::arg("time"), py::arg("x"), plan_control_doc);
}

void bind_feedback_plan(py::module_& m) {
  PlanClass c(m, "FeedbackPlan",
              "Controller between two solves: a copy of the first knots of a solution and of "
              "their policy, for controllers of your own.");
  c.def(py::init([](const ProblemMachine& machine, int knots, double step) {
          return FeedbackPlan(machine.problem, knots, step);
        }),
        py::arg("problem"), py::arg("knots"), py::arg("step"), py::keep_alive<1, 2>(),
        "Allocates memory for `knots` knots, at most those of the problem; `step` is the time "
        "between knots [s]. Raises Error for fewer than one knot, and a step that is not "
        "positive.")
      .def(py::init([](const ProblemMachine& machine, const std::vector<double>& steps) {
             return FeedbackPlan(machine.problem, steps);
           }),
           py::arg("problem"), py::arg("steps"), py::keep_alive<1, 2>(),
           "Allocates memory for one knot per entry of `steps`, which are the times between knots "
           "[s]. Raises Error for an empty list, and a step that is not positive.")
      .def(
          "load",
          [](FeedbackPlan& self, SolverMachine& machine, double time) {
            const Busy::Lock lock(machine.busy, "FeedbackPlan.load");
            const MatrixView xs = machine.solver.xs();
            const LinearFeedback sizes = self.make_feedback();
            if (xs.rows() <= self.knots() || xs.cols() != sizes.state.size() ||
                machine.solver.us().cols() != sizes.feedforward.size())
              throw Error(
                  "FeedbackPlan.load: the solver belongs to another problem; wanted a solver of "
                  "the problem that this FeedbackPlan was made for");
            self.load(machine.solver, time);
          },
          py::arg("solver"), py::arg("time"), plan_load_doc)
      .def("clear", &FeedbackPlan::clear, "Deletes the plan.")
      .def_property_readonly("empty", &FeedbackPlan::empty, "True if there is no plan.")
      .def_property_readonly("knots", &FeedbackPlan::knots, "Largest number of knots.")
      .def_property_readonly("start", &FeedbackPlan::start, "s.")
      .def(
          "time_of",
          [](const FeedbackPlan& self, int knot) {
            if (knot < 0 || knot > self.knots())
              throw Error("FeedbackPlan.time_of: knot " + std::to_string(knot) +
                          " does not exist; wanted 0 to " + std::to_string(self.knots()));
            return self.time_of(knot);
          },
          py::arg("knot"),
          "Returns the time of a knot, 0 to knots [s]; the last one is the end of the plan.");
  bind_plan_policy(c);
  c.def("__repr__", [](const FeedbackPlan& self) {
    return "<FeedbackPlan of " + std::to_string(self.knots()) + " knots" +
           (self.empty() ? ", empty>" : ">");
  });
}

/// Reads a member of a controller under its lock.
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
        "Returns a copy of the states of the last plan, shape (N + 1, nx). With a solver delay, "
        "this plan is not yet in use.")
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
          "Returns the cost of each term at a knot of the last plan, by name; includes the length "
          "of the step.");
}

void bind_mpc_readings(MpcClass& c) {
  c.def_property_readonly("torque_error",
                          reading("MpcController.torque_error",
                                  [](const MpcController& mpc) { return mpc.torque_error(); }),
                          "Estimated torque error, shape (nv,) [Nm or N].")
      .def_property_readonly("force_error",
                             reading("MpcController.force_error",
                                     [](const MpcController& mpc) { return mpc.force_error(); }),
                             "Estimated force error at each tool, with ModelErrorKind.FORCE [N].")
      .def_property_readonly(
          "support_friction",
          reading("MpcController.support_friction",
                  [](const MpcController& mpc) { return mpc.support_friction(); }),
          "Friction coefficients that plans use for the permanent supports (see SlipOptions); "
          "infinite without a friction cone.")
      .def_property_readonly("schedule",
                             reading("MpcController.schedule",
                                     [](const MpcController& mpc) { return mpc.schedule(); }),
                             "Copy of the schedule with its present time.")
      .def_property_readonly("plan_age",
                             reading("MpcController.plan_age",
                                     [](const MpcController& mpc) { return mpc.plan_age(); }),
                             "Age of the plan in use: time from its measurement to the last valid "
                             "measurement [s]; infinite without a plan.");
}

void bind_mpc_controller(py::module_& m) {
  MpcClass c(
      m, "MpcController",
      "Model predictive controller of a task.\n"
      "\n"
      "A new controller, and a controller after reset(), gives equal torques, bit by bit, for "
      "equal measurements. tick() must be called once per tick_period; the first call solves the "
      "problem to convergence. After a failed update, the controller uses the previous plan. The "
      "first fault activates the fallback until reset(). Exceptions of targets and residuals fail "
      "the update; tick(), or the run of a ClosedLoop, raises them.");
  c.def(py::init([](const MpcSpec& spec) {
          const py::gil_scoped_release release;
          return std::make_unique<BoundMpc>(spec);
        }),
        py::arg("spec"), "Raises Error for a contradictory specification.")
      .def_property_readonly(
          "spec", [](const BoundMpc& self) { return self.spec(); }, "Specification, a copy.")
      .def_property_readonly(
          "problem",
          [](const BoundMpc& self) {
            return std::make_unique<ProblemMachine>(self.spec().problem);
          },
          "Makes a Problem from the specification. The problem of the controller itself moves "
          "with its schedule.")
      .def(
          "set_payload",
          [](BoundMpc& self, const std::string& frame, const InertiaSpec& payload) {
            constexpr const char* call = "MpcController.set_payload";
            const Busy::Lock lock(self.busy, call);
            check_payload(call, payload);
            require(self.mpc().set_payload(frame, payload), call);
          },
          py::arg("frame"), py::arg("payload"), mpc_payload_doc)
      .def("fault",
           reading("MpcController.fault", [](const MpcController& mpc) { return mpc.fault(); }),
           "FaultReport; its kind is NONE without a fault.")
      .def("feedback",
           reading("MpcController.feedback",
                   [](const MpcController& mpc) { return mpc.feedback(); }),
           "Policy of the last tick, a LinearFeedback.");
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
      py::arg("spec"), plan_complaints_doc);
}

}  // namespace burnish::python

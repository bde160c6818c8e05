// Plants, disturbances, closed loops.
#include "bind.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "loop_parts.hpp"
#include "specs_estimate.hpp"

#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

std::unique_ptr<BoundPlant> ideal_plant(const Model& model, const SceneSpec& scene,
                                        const std::optional<IdealPlantOptions>& options) {
  return std::make_unique<BoundPlant>(
      make_ideal_plant(model, scene, options.value_or(IdealPlantOptions{})));
}

#ifdef BURNISH_HAS_MUJOCO
constexpr bool with_mujoco = true;
std::unique_ptr<BoundPlant> mujoco_plant(const Model& model, const SceneSpec& scene,
                                         const std::optional<MujocoPlantOptions>& options) {
  return std::make_unique<BoundPlant>(
      make_mujoco_plant(model, scene, options.value_or(MujocoPlantOptions{})));
}
#else
constexpr bool with_mujoco = false;
std::unique_ptr<BoundPlant> mujoco_plant(const Model&, const SceneSpec&,
                                         const std::optional<MujocoPlantOptions>&) {
  throw Error(
      "make_mujoco_plant: this build of burnish has no MuJoCo; wanted is a build where it was "
      "found, or make_ideal_plant");
}
#endif

/// A loop with all that it needs to go on.
class BoundLoop {
 public:
  BoundLoop(py::object plant, py::object controller, const Disturbances& disturbances,
            const ClosedLoopOptions& options)
      : plant_(std::move(plant)),
        controller_(std::move(controller)),
        loop_(plant_.plant(), controller_.controller(), disturbances, options) {}

  ClosedLoop& loop() { return loop_; }
  const py::object& plant() const { return plant_.object(); }
  const py::object& controller() const { return controller_.object(); }

  void reset(const Vector& q, const std::optional<Eigen::VectorXd>& v) {
    const Eigen::Index nv = plant_.plant().model().nv;
    require(
        drive("ClosedLoop.reset",
              [&] { return loop_.reset(q, v ? *v : Eigen::VectorXd(Eigen::VectorXd::Zero(nv))); }),
        "ClosedLoop.reset");
  }

  Status step() {
    return drive("ClosedLoop.step", [&] { return loop_.step(); });
  }

  Status run(double duration) {
    const double steps = std::round(duration / plant_.plant().dt());
    if (!(steps >= 0.0 && steps < 1e15))
      throw Error("ClosedLoop.run: got a duration of " + std::to_string(duration) +
                  ", wanted seconds that are not negative");
    SignalWatch watch;
    watch.begin();
    return drive("ClosedLoop.run", [&] {
      Status status = Status::Ok;
      for (auto left = static_cast<long>(steps); left > 0; --left) {
        status = worst(status, loop_.step());
        rethrow();
        if (status > Status::NotConverged) break;
        watch.look();
      }
      return status;
    });
  }

 private:
  template <class Call>
  Status drive(const char* what, Call&& call) {
    const py::gil_scoped_release release;
    const Busy::Lock lock(busy_, what);
    const auto plant = plant_.lock(what);
    const auto controller = controller_.lock(what);
    const Status status = call();
    rethrow();
    require(status, what);
    return status;
  }

  /// What Python threw where C++ bears no exception.
  void rethrow() {
    std::exception_ptr first = plant_.take_exception();
    if (!first) first = controller_.take_exception();
    if (first) std::rethrow_exception(first);
  }

  PlantPart plant_;
  ControllerPart controller_;
  ClosedLoop loop_;
  Busy busy_;
};

using PlantClass = py::class_<BoundPlant>;

void bind_plant_readings(PlantClass& c) {
  c.def_property_readonly(
       "model", [](const BoundPlant& self) -> const Model& { return self.plant->model(); },
       py::return_value_policy::reference_internal, "The robot as it is.")
      .def_property_readonly(
          "scene", [](const BoundPlant& self) { return self.plant->scene(); },
          "Surface and tip as they are; a normal of length one.")
      .def_property_readonly(
          "dt", [](const BoundPlant& self) { return self.plant->dt(); }, "s, of a step.")
      .def_property_readonly(
          "time", [](const BoundPlant& self) { return self.plant->time(); }, "s since reset().")
      .def_property_readonly(
          "q", [](const BoundPlant& self) { return self.plant->q(); }, "Configuration (nq,).")
      .def_property_readonly(
          "v", [](const BoundPlant& self) { return self.plant->v(); }, "Velocity (nv,).")
      .def_property_readonly(
          "contact_force_world",
          [](const BoundPlant& self) { return self.plant->contact_force_world(); },
          "Force of the surface on the tip during the last step (3,), N, world axes.")
      .def_property_readonly(
          "in_contact", [](const BoundPlant& self) { return self.plant->in_contact(); },
          "Whether the surface pushed during the last step.")
      .def_property_readonly(
          "friction_torque", [](const BoundPlant& self) { return self.plant->friction_torque(); },
          "Torque of joint friction during the last step (nv,), Nm or N: against the motion.");
}

void bind_plant_motion(PlantClass& c) {
  c.def(
       "reset",
       [](BoundPlant& self, const Vector& q, const std::optional<Eigen::VectorXd>& v) {
         const py::gil_scoped_release release;
         const Busy::Lock lock(self.busy, "Plant.reset");
         require(self.plant->reset(
                     q, v ? *v : Eigen::VectorXd(Eigen::VectorXd::Zero(self.plant->model().nv))),
                 "Plant.reset");
       },
       py::arg("q"), py::arg("v") = py::none(),
       "Starts at the configuration q (nq,) with the velocity v (nv,), None: at rest, at time "
       "zero, without force. Raises EvaluationError for a state that is none.")
      .def(
          "step",
          [](BoundPlant& self, const Vector& tau, const std::optional<Eigen::Vector3d>& push) {
            const py::gil_scoped_release release;
            const Busy::Lock lock(self.busy, "Plant.step");
            const Status status =
                self.plant->step(tau, push.value_or(Eigen::Vector3d(Eigen::Vector3d::Zero())));
            require(status, "Plant.step");
            return status;
          },
          py::arg("tau"), py::arg("push_world") = py::none(),
          "Advances by dt with the torques tau (nv,; Nm, N) and a force on the tip (3,; N, world "
          "axes, at the tip frame's origin; None: zero), held over the step. Raises "
          "EvaluationError for torques that are none or a motion that is not finite; the state is "
          "then as it was.")
      .def(
          "save",
          [](BoundPlant& self) {
            const Busy::Lock lock(self.busy, "Plant.save");
            PlantSnapshot snapshot;
            self.plant->save(snapshot);
            return snapshot;
          },
          "A snapshot of all that the future depends on, and of the readings.")
      .def(
          "restore",
          [](BoundPlant& self, const PlantSnapshot& snapshot) {
            const Busy::Lock lock(self.busy, "Plant.restore");
            require(self.plant->restore(snapshot), "Plant.restore");
          },
          py::arg("snapshot"),
          "Goes back: the same torques then give the same bits. Raises EvaluationError for "
          "another plant's snapshot.");
}

void bind_plant(py::module_& m) {
  PlantClass c(m, "CompiledPlant", "A plant of the library; see burnish.Plant.");
  bind_plant_readings(c);
  bind_plant_motion(c);
  c.def("__repr__", [](const BoundPlant& self) {
    return "<Plant of '" + self.plant->model().name + "' at " + std::to_string(self.plant->time()) +
           " s>";
  });

  m.def("make_ideal_plant", &ideal_plant, py::arg("model"), py::arg("scene"),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
        "The library's own contact dynamics as a plant: a rigid surface, exact torques, a plastic "
        "impact where the tip meets the surface. Raises Error for a scene or options that cannot "
        "be used.");
  m.def("make_mujoco_plant", &mujoco_plant, py::arg("model"), py::arg("scene"),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
        "MuJoCo as a plant: the surface is a spring and damper, friction cones are elliptic. "
        "Raises Error for a scene or options that cannot be used, and where has_mujoco() is "
        "False.");
  m.def(
      "has_mujoco", [] { return with_mujoco; }, "Whether this build has MuJoCo as a plant.");
}

void bind_scene(py::module_& m) {
  m.def("checked_scene", &checked_scene, py::arg("model"), py::arg("scene"),
        "The scene with a normal of length one. Raises Error for numbers out of range and a tip "
        "frame that is unknown or does not move.");
  m.def(
      "scene_under_tip",
      [](const Model& model, const Vector& q, const Eigen::Vector3d& normal,
         const std::optional<SceneSpec>& scene, double clearance) {
        return scene_under_tip(model, q, normal, scene.value_or(SceneSpec{}), clearance);
      },
      py::arg("model"), py::arg("q"), py::arg("normal"), py::arg("scene") = py::none(),
      py::arg("clearance") = 0.0,
      "The scene with its surface put under the tip at the configuration q (nq,): `clearance` m "
      "between tip and surface along `normal` (3,; world, any length). Raises Error as "
      "checked_scene() does.");
  m.def("gap", &gap, py::arg("scene"), py::arg("p_tip_world"),
        "Distance from the tip to the surface, m; negative inside. p_tip_world (3,): origin of the "
        "tip's frame; the scene's normal of length one.");
  m.def("check_disturbances", &check_disturbances, py::arg("model"), py::arg("disturbances"),
        "Raises Error naming the entry that is not finite, negative where it may not be, or of "
        "the wrong size.");
  m.def("plant_model", &plant_model, py::arg("nominal"), py::arg("disturbances"),
        "The robot as it is, from the robot as the controller knows it: masses scaled, and joint "
        "friction as the disturbances say (none without them, whatever the description states).");
  m.def("plant_scene", &plant_scene, py::arg("nominal"), py::arg("disturbances"),
        "The scene as it is, from the scene as the controller knows it.");
  m.def("push_at", &push_at, py::arg("pushes"), py::arg("time"),
        "Sum of the pushes at a time (3,), N, world axes.");
  m.def("circle_path_at", &CirclePath::at, py::arg("path"), py::arg("t"));
  m.def(
      "make_admittance_controller",
      [](const Model& model, const AdmittanceSpec& spec) -> std::unique_ptr<BoundController> {
        return bound(model, spec, make_admittance_controller);
      },
      py::arg("model"), py::arg("spec"),
      "Force error to joint positions that are held, as a controller with the phases APPROACH, "
      "RAMP, TRACK. Raises Error for a specification that cannot be used. What its task raises "
      "ends a run or tick.");
  m.def(
      "make_impedance_controller",
      [](const Model& model, const ImpedanceSpec& spec) -> std::unique_ptr<BoundController> {
        return bound(model, spec, make_impedance_controller);
      },
      py::arg("model"), py::arg("spec"),
      "The baseline as a controller, with the phases APPROACH, RAMP, TRACK. Raises Error for a "
      "specification that cannot be used. What its task raises ends a run or tick.");
}

void bind_between(py::module_& m) {
  py::class_<Actuation>(m, "Actuation",
                        "What happens to a torque between the controller and the joint, one call "
                        "per plant step: delay, lag, scale and bias (or torque loop), noise, "
                        "limits.")
      .def(py::init<const Model&, const Disturbances&, double>(), py::arg("model"),
           py::arg("disturbances"), py::arg("dt"),
           "dt: the plant's step, s. Raises Error as check_disturbances() does.")
      .def(
          "reset",
          [](Actuation& self, const std::optional<Eigen::VectorXd>& tau) {
            if (tau && tau->size() != self.scale().size())
              throw Error("Actuation.reset: got a torque of " + std::to_string(tau->size()) +
                          " numbers, wanted " + std::to_string(self.scale().size()));
            tau ? self.reset(*tau) : self.reset();
          },
          py::arg("tau") = py::none(),
          "Back to the start, with the same random numbers to come; tau (nv,): what was applied "
          "before, None: zero.")
      .def(
          "apply",
          [](Actuation& self, const Vector& command) {
            if (command.size() != self.scale().size())
              throw Error("Actuation.apply: got a torque of " + std::to_string(command.size()) +
                          " numbers, wanted " + std::to_string(self.scale().size()));
            return self.apply(command);
          },
          py::arg("command"), "The torque (nv,) for the plant's next step.")
      .def_property_readonly("last_step", &Actuation::step,
                             "The torque after each part, of the last step.")
      .def_property_readonly(
          "scale", [](const Actuation& self) { return self.scale(); }, "(nv,), as drawn or given.")
      .def_property_readonly(
          "bias", [](const Actuation& self) { return self.bias(); },
          "(nv,), Nm or N, as drawn or given.")
      .def_property_readonly("delay_steps", &Actuation::delay_steps, "Plant steps.");

  py::class_<Sensing>(m, "Sensing",
                      "What a controller gets to see of a plant, one call per tick: noise, "
                      "encoder, differences and filters.")
      .def(py::init<const Model&, const Disturbances&>(), py::arg("model"), py::arg("disturbances"),
           "Raises Error as check_disturbances() does.")
      .def("reset", &Sensing::reset,
           "Forgets all measurements, with the same random numbers to come.")
      .def(
          "measure",
          [](Sensing& self, const BoundPlant& plant, const Vector& applied) {
            if (applied.size() != plant.plant->v().size())
              throw Error("Sensing.measure: got a torque of " + std::to_string(applied.size()) +
                          " numbers, wanted " + std::to_string(plant.plant->v().size()));
            return self.measure(*plant.plant, applied);
          },
          py::arg("plant"), py::arg("applied"),
          "Reads a plant of the library; applied (nv,): the motors' torque during its last step.");
}

void bind_loop(py::module_& m) {
  py::class_<BoundLoop>(
      m, "ClosedLoop",
      "A controller and a plant, with the disturbances between them, and the record of their "
      "run.\n\nThe controller ticks at the start of every control period and its torque is held "
      "until the next. Plants and controllers are the library's or subclasses of burnish.Plant "
      "and burnish.Controller (or any object with their attributes); what those raise is raised "
      "by reset(), step() and run(). The disturbances of model and scene are not applied here: "
      "build the plant with plant_model() and plant_scene().")
      .def(py::init([](py::object plant, py::object controller,
                       const std::optional<Disturbances>& disturbances,
                       const std::optional<ClosedLoopOptions>& options) {
             return std::make_unique<BoundLoop>(std::move(plant), std::move(controller),
                                                disturbances.value_or(Disturbances{}),
                                                options.value_or(ClosedLoopOptions{}));
           }),
           py::arg("plant"), py::arg("controller"), py::arg("disturbances") = py::none(),
           py::arg("options") = py::none(),
           "Raises Error for periods that do not fit, for a controller of another size and for "
           "bad disturbances.")
      .def(
          "estimate_base",
          [](BoundLoop& self, const Model& known, const BaseEstimatorOptions& estimator,
             const std::optional<FootContactOptions>& feet) {
            self.loop().estimate_base(known, estimator, feet.value_or(FootContactOptions{}));
          },
          py::arg("known"), py::arg("estimator"), py::arg("feet") = py::none(),
          "From the next reset() on the controller is given an estimate of where the base is, in "
          "place of the plant's own entries: from a measurement unit, the joints and the feet. It "
          "starts where the robot does. known: the Model as the controller knows it. Raises Error "
          "for a robot without a floating base, unknown frames, options out of range, and a "
          "controller that carries a payload, which the estimate would not know of.")
      .def("reset", &BoundLoop::reset, py::arg("q"), py::arg("v") = py::none(),
           "Puts the plant at q (nq,) with the velocity v (nv,), None: at rest, and everything "
           "else to its start. Empties the trace: views of it are then of the new run.")
      .def("step", &BoundLoop::step, "One plant step. Raises EvaluationError if the plant fails.")
      .def("run", &BoundLoop::run, py::arg("duration"),
           "Steps until `duration` s have passed. Raises EvaluationError if the plant fails, and "
           "what Python code of plant, controller, targets or residuals raised, after the step in "
           "which it did; the trace then ends there. Ctrl-C is let through.")
      .def_property_readonly(
          "trace", [](BoundLoop& self) -> const Trace& { return self.loop().trace(); },
          py::return_value_policy::reference_internal,
          "The record so far, on the loop's memory: it grows with the run, and reset() empties "
          "it. copy.copy(loop.trace) keeps it.")
      .def_property_readonly(
          "actuation", [](BoundLoop& self) -> const Actuation& { return self.loop().actuation(); },
          py::return_value_policy::copy, "A copy of the actuation as it is now.")
      .def_property_readonly(
          "measurement", [](BoundLoop& self) { return self.loop().measurement(); },
          "Of the last tick.")
      .def_property_readonly(
          "command", [](BoundLoop& self) { return self.loop().command(); }, "Of the last tick.")
      .def_property_readonly("plant", &BoundLoop::plant, "As given.")
      .def_property_readonly("controller", &BoundLoop::controller, "As given.")
      .def("__repr__", [](BoundLoop& self) {
        return "<ClosedLoop: " + std::to_string(self.loop().trace().rows()) + " rows recorded>";
      });
}

}  // namespace

void bind_sim(py::module_& m) {
  bind_plant(m);
  bind_scene(m);
  bind_between(m);
  bind_loop(m);
}

}  // namespace burnish::python

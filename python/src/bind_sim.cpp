// Bindings of plants, disturbances, controllers and closed loops.
#include "bind.hpp"
#include "bind_derivatives.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "loop_parts.hpp"
#include "specs_estimate.hpp"

#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* plant_reset_doc = R"(Sets the state, at time zero and without forces.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,), optional
    Velocity; default: at rest.

Raises
------
EvaluationError
    If the state is not finite or not normalized.
Error
    If an argument has the wrong number of entries.)";

constexpr const char* plant_step_doc =
    R"(Advances by dt, with constant torques.

A ClosedLoop simulates pushes: see Disturbances.pushes. Without a loop, add J^T f to the torques,
with the Jacobian J of the frame and the force f on it.

Parameters
----------
tau : array_like, shape (nv,)
    Torques [Nm or N]. The entries of a floating base are a wrench in the axes of the base.

Raises
------
EvaluationError
    If the input or the motion is not finite; the state does not change.
Error
    If tau has the wrong number of entries.)";

constexpr const char* plant_restore_doc =
    R"(Restores a saved state. The same torques then give the same motion, bit by bit.

Parameters
----------
snapshot : PlantSnapshot

Raises
------
EvaluationError
    If the snapshot is of another plant.)";

constexpr const char* loop_estimate_base_doc =
    R"(Makes the controller use an estimate of the base, from the next reset().

The estimator uses a measurement unit, the joints and the feet, and starts at the true state.

Parameters
----------
known : Model
    Model of the controller.
estimator : BaseEstimatorOptions
feet : FootContactOptions, optional

Raises
------
Error
    If the robot has no floating base, a frame is unknown, or an option is out of range.)";

constexpr const char* loop_payload_doc =
    R"(Sets the payload that the controller and the estimate of the base assume, from the next tick.

The plant does not change. The payload replaces that of the body of the frame.

Parameters
----------
frame : str
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.

Raises
------
EvaluationError
    If the controller does not account for payloads.
Error
    If the frame is unknown or fixed to the world, or if no body can have such an inertia.)";

constexpr const char* loop_reset_doc =
    R"(Resets the plant, the controller and the disturbances, and empties the trace.

Views of the trace then show the new run.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,), optional
    Velocity; default: at rest.)";

constexpr const char* loop_run_doc = R"(Runs for a duration. Ctrl-C interrupts the run.

Exceptions of Python code in plant, controller, targets or residuals are raised after the step
in which they occur; the trace then ends there.

Parameters
----------
duration : float
    Duration [s].

Returns
-------
Status

Raises
------
EvaluationError
    If the plant fails.)";

constexpr const char* make_ideal_plant_doc =
    R"(Makes a plant with the contact dynamics of the library: rigid surface, exact torques, plastic
impacts.

Parameters
----------
model : Model
scene : SceneSpec
options : IdealPlantOptions, optional

Returns
-------
Plant

Raises
------
Error
    If the scene or the options are invalid.)";

constexpr const char* make_mujoco_plant_doc =
    R"(Makes a MuJoCo plant: the surface is a spring and damper, and friction cones are elliptic.

Parameters
----------
model : Model
scene : SceneSpec
options : MujocoPlantOptions, optional

Returns
-------
Plant

Raises
------
Error
    If the scene or the options are invalid, or has_mujoco() is False.)";

constexpr const char* checked_scene_doc = R"(Checks a scene.

Parameters
----------
model : Model
scene : SceneSpec

Returns
-------
SceneSpec
    Scene with unit normals.

Raises
------
Error
    If a number is out of range, if a frame is unknown or does not move, if two touches have the
    same frame, or if a touch does not fit its surface.)";

constexpr const char* with_surface_at_doc =
    R"(Returns a touch with its surface moved to the robot.

Parameters
----------
model : Model
q : array_like, shape (nq,)
    Configuration.
normal : array_like, shape (3,)
    Normal of the surface, of any length, in the axes of the frame that carries the surface. Without
    such a frame, in world axes.
touch : TouchSpec
clearance : float
    Distance from the sphere of the touch to the surface, along the normal [m].

Returns
-------
TouchSpec
    Copy with a unit normal and another point of the surface.

Raises
------
Error
    In the cases of checked_scene().)";

constexpr const char* gap_doc = R"(Computes the distance from the sphere of a touch to its surface.

Parameters
----------
touch : TouchSpec
    Touch whose surface has a unit normal.
p : array_like, shape (3,)
    Origin of the frame of the touch, in the axes of the frame that carries the surface [m]. Without
    such a frame, in world axes.

Returns
-------
float
    Distance [m]; negative inside.)";

constexpr const char* check_disturbances_doc = R"(Checks disturbances.

Parameters
----------
model : Model
disturbances : Disturbances

Raises
------
Error
    If an entry is not finite, out of range, or of the wrong size; the message names the entry.)";

constexpr const char* plant_model_doc =
    R"(Returns the model of the plant.

It is the nominal model with scaled masses and the joint friction of the disturbances. Joint
friction of the nominal model is replaced, by zero if the disturbances have none.

Parameters
----------
nominal : Model
    Model of the controller.
disturbances : Disturbances

Returns
-------
Model)";

constexpr const char* plant_scene_doc =
    R"(Returns the scene of the plant: the nominal scene with the disturbances of the ground and of
the surfaces of all tools.

Parameters
----------
nominal : SceneSpec
    Scene of the controller.
disturbances : Disturbances

Returns
-------
SceneSpec)";

constexpr const char* make_admittance_controller_doc =
    R"(Makes an admittance controller with the phases APPROACH, RAMP and TRACK.

Parameters
----------
model : Model
spec : AdmittanceSpec

Returns
-------
Controller
    Exceptions of its task end a run or tick.

Raises
------
Error
    If the specification is invalid.)";

constexpr const char* make_impedance_controller_doc =
    R"(Makes the baseline, an impedance controller with the phases APPROACH, RAMP and TRACK.

Parameters
----------
model : Model
spec : ImpedanceSpec

Returns
-------
Controller
    Exceptions of its task end a run or tick.

Raises
------
Error
    If the specification is invalid.)";

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
      "make_mujoco_plant: this build of burnish has no MuJoCo; wanted a build with MuJoCo, "
      "or make_ideal_plant()");
}
#endif

/// Closed loop together with the Python objects that it uses.
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
      throw Error("ClosedLoop.run: the duration is " + std::to_string(duration) +
                  " s; wanted at least 0");
    SignalWatch watch;
    watch.begin();
    return drive("ClosedLoop.run", [&] {
      Status status = Status::Ok;
      for (auto left = static_cast<long>(steps); left > 0; --left) {
        status = worst(status, loop_.step());
        rethrow();
        if (!is_usable(status)) break;
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

  /// Rethrows an exception of Python code that was caught in a noexcept call.
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
       py::return_value_policy::reference_internal, "True model of the robot.")
      .def_property_readonly(
          "scene", [](const BoundPlant& self) { return self.plant->scene(); },
          "True touches and their surfaces, with unit normals.")
      .def_property_readonly(
          "dt", [](const BoundPlant& self) { return self.plant->dt(); }, "Time step [s].")
      .def_property_readonly(
          "time", [](const BoundPlant& self) { return self.plant->time(); },
          "Time since reset() [s].")
      .def_property_readonly(
          "q", [](const BoundPlant& self) { return self.plant->q(); },
          "Configuration, shape (nq,).")
      .def_property_readonly(
          "v", [](const BoundPlant& self) { return self.plant->v(); }, "Velocity, shape (nv,).")
      .def_property_readonly(
          "wrenches", [](const BoundPlant& self) { return self.plant->wrenches(); },
          "Wrenches of the surfaces on the touches of the scene during the last step, shape (6, "
          "touches): force [N], then moment [Nm] about the origin of the touch's frame. The axes "
          "are those of this frame at the start of the step. Zero without contact.")
      .def_property_readonly(
          "friction_torque", [](const BoundPlant& self) { return self.plant->friction_torque(); },
          "Torques of joint friction during the last step, against the motion, shape (nv,) [Nm or "
          "N].");
}

void bind_plant_motion(PlantClass& c) {
  c.def(
       "reset",
       [](BoundPlant& self, const Vector& q, const std::optional<Eigen::VectorXd>& v) {
         const Model& model = self.plant->model();
         require_size("Plant.reset", "q", q.size(), model.nq);
         if (v) require_size("Plant.reset", "v", v->size(), model.nv);
         const py::gil_scoped_release release;
         const Busy::Lock lock(self.busy, "Plant.reset");
         require(self.plant->reset(q, v ? *v : Eigen::VectorXd(Eigen::VectorXd::Zero(model.nv))),
                 "Plant.reset");
       },
       py::arg("q"), py::arg("v") = py::none(), plant_reset_doc)
      .def(
          "step",
          [](BoundPlant& self, const Vector& tau, const py::args& more, const py::kwargs& named) {
            if (!more.empty() || !named.empty())
              throw py::type_error(
                  "Plant.step: got more than the torques; wanted pushes in Disturbances.pushes of "
                  "a ClosedLoop, or J^T f added to tau");
            require_size("Plant.step", "tau", tau.size(), self.plant->model().nv);
            const py::gil_scoped_release release;
            const Busy::Lock lock(self.busy, "Plant.step");
            const Status status = self.plant->step(tau);
            require(status, "Plant.step");
            return status;
          },
          py::arg("tau"), plant_step_doc)
      .def(
          "save",
          [](BoundPlant& self) {
            const Busy::Lock lock(self.busy, "Plant.save");
            PlantSnapshot snapshot;
            self.plant->save(snapshot);
            return snapshot;
          },
          "Returns a snapshot: all data on which future steps depend, and the forces of the last "
          "step.")
      .def(
          "restore",
          [](BoundPlant& self, const PlantSnapshot& snapshot) {
            const Busy::Lock lock(self.busy, "Plant.restore");
            require(self.plant->restore(snapshot), "Plant.restore");
          },
          py::arg("snapshot"), plant_restore_doc);
}

void bind_plant(py::module_& m) {
  PlantClass c(m, "CompiledPlant", "Plant of the library; see burnish.Plant.");
  bind_plant_readings(c);
  bind_plant_motion(c);
  c.def("__repr__", [](const BoundPlant& self) {
    return "<Plant of '" + self.plant->model().name + "' at " + std::to_string(self.plant->time()) +
           " s>";
  });

  m.def("make_ideal_plant", &ideal_plant, py::arg("model"), py::arg("scene"),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
        make_ideal_plant_doc);
  m.def("make_mujoco_plant", &mujoco_plant, py::arg("model"), py::arg("scene"),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
        make_mujoco_plant_doc);
  m.def(
      "has_mujoco", [] { return with_mujoco; }, "Returns whether this build has the MuJoCo plant.");
}

void bind_scene(py::module_& m) {
  m.def("checked_scene", &checked_scene, py::arg("model"), py::arg("scene"), checked_scene_doc);
  m.def(
      "with_surface_at",
      [](const Model& model, const Vector& q, const Eigen::Vector3d& normal, const TouchSpec& touch,
         double clearance) { return with_surface_at(model, q, normal, touch, clearance); },
      py::arg("model"), py::arg("q"), py::arg("normal"), py::arg("touch"),
      py::arg("clearance") = 0.0, with_surface_at_doc);
  m.def("gap", &gap, py::arg("touch"), py::arg("p"), gap_doc);
  m.def("check_disturbances", &check_disturbances, py::arg("model"), py::arg("disturbances"),
        check_disturbances_doc);
  m.def("plant_model", &plant_model, py::arg("nominal"), py::arg("disturbances"), plant_model_doc);
  m.def("plant_scene", &plant_scene, py::arg("nominal"), py::arg("disturbances"), plant_scene_doc);
  m.def("circle_path_at", &CirclePath::at, py::arg("path"), py::arg("t"));
  m.def(
      "make_admittance_controller",
      [](const Model& model, const AdmittanceSpec& spec) -> std::unique_ptr<BoundController> {
        return bound(model, spec, make_admittance_controller);
      },
      py::arg("model"), py::arg("spec"), make_admittance_controller_doc);
  m.def(
      "make_impedance_controller",
      [](const Model& model, const ImpedanceSpec& spec) -> std::unique_ptr<BoundController> {
        return bound(model, spec, make_impedance_controller);
      },
      py::arg("model"), py::arg("spec"), make_impedance_controller_doc);
}

std::vector<std::string> frames_of(const SceneSpec& scene) {
  std::vector<std::string> frames;
  for (const TouchSpec& touch : scene.touches) frames.push_back(touch.frame);
  return frames;
}

/// Sensing object, with the touches (tools and feet) of its scene.
class BoundSensing {
 public:
  BoundSensing(const Model& model, const Disturbances& disturbances, const SceneSpec& scene,
               const std::optional<std::vector<std::string>>& touches)
      : frames_(frames_of(scene)),
        sensing_(model, disturbances, scene, touches.value_or(frames_)) {}

  void reset() { sensing_.reset(); }

  Measurement measure(const BoundPlant& plant, const Vector& applied) {
    if (applied.size() != plant.plant->v().size())
      throw Error("Sensing.measure: the torque has " + std::to_string(applied.size()) +
                  " entries; wanted " + std::to_string(plant.plant->v().size()));
    if (frames_of(plant.plant->scene()) != frames_)
      throw Error(
          "Sensing.measure: the touches of the plant differ from those of the scene given to "
          "Sensing; wanted equal touches in the same order");
    return sensing_.measure(*plant.plant, applied);
  }

 private:
  std::vector<std::string> frames_;
  Sensing sensing_;
};

void bind_between(py::module_& m) {
  py::class_<Actuation>(m, "Actuation",
                        "Actuation between controller and joint, one call per plant step: delay, "
                        "lag, scale and bias (or torque loop), noise, limits.")
      .def(py::init<const Model&, const Disturbances&, double>(), py::arg("model"),
           py::arg("disturbances"), py::arg("dt"),
           "`dt` is the time step of the plant [s]. Raises Error in the cases of "
           "check_disturbances().")
      .def(
          "reset",
          [](Actuation& self, const std::optional<Eigen::VectorXd>& tau) {
            if (tau && tau->size() != self.scale().size())
              throw Error("Actuation.reset: the torque has " + std::to_string(tau->size()) +
                          " entries; wanted " + std::to_string(self.scale().size()));
            tau ? self.reset(*tau) : self.reset();
          },
          py::arg("tau") = py::none(),
          "Resets the actuation, with the same sequence of random numbers. `tau` (nv,) was "
          "applied before; None: zero.")
      .def(
          "apply",
          [](Actuation& self, const Vector& command) {
            if (command.size() != self.scale().size())
              throw Error("Actuation.apply: the torque has " + std::to_string(command.size()) +
                          " entries; wanted " + std::to_string(self.scale().size()));
            return self.apply(command);
          },
          py::arg("command"), "Returns the torque for the next step of the plant, shape (nv,).")
      .def_property_readonly("last_step", &Actuation::step,
                             "ActuationStep: torques after each part in the last step.")
      .def_property_readonly(
          "scale", [](const Actuation& self) { return self.scale(); },
          "Scale of the torques, drawn or given, shape (nv,).")
      .def_property_readonly(
          "bias", [](const Actuation& self) { return self.bias(); },
          "Bias of the torques, drawn or given, shape (nv,) [Nm or N].")
      .def_property_readonly("delay_steps", &Actuation::delay_steps,
                             "Delay in steps of the plant.");

  py::class_<BoundSensing>(m, "Sensing",
                           "Measurements of a plant for a controller, one call per tick: noise, "
                           "encoders, differences and filters.")
      .def(py::init<const Model&, const Disturbances&, const SceneSpec&,
                    const std::optional<std::vector<std::string>>&>(),
           py::arg("model"), py::arg("disturbances"), py::arg("scene"),
           py::arg("touches") = py::none(),
           "`scene` is the scene of the plant. `touches` are the frames of the columns of "
           "Measurement.wrenches; None: all touches of the scene. Raises Error in the cases of "
           "check_disturbances(), and for a frame without a touch in the scene.")
      .def("reset", &BoundSensing::reset,
           "Resets the sensing, with the same sequence of random numbers.")
      .def("measure", &BoundSensing::measure, py::arg("plant"), py::arg("applied"),
           "Measures a plant of the library. `applied` (nv,) are the motor torques during its last "
           "step.");
}

void bind_loop_views(py::class_<BoundLoop>& loop) {
  loop.def_property_readonly(
          "trace", [](BoundLoop& self) -> const Trace& { return self.loop().trace(); },
          py::return_value_policy::reference_internal,
          "Record of the run, in the memory of the loop. It grows with the run, and reset() "
          "empties it. copy.copy(loop.trace) copies it.")
      .def_property_readonly(
          "actuation", [](BoundLoop& self) -> const Actuation& { return self.loop().actuation(); },
          py::return_value_policy::copy, "Actuation, a copy.")
      .def_property_readonly(
          "measurement", [](BoundLoop& self) { return self.loop().measurement(); },
          "Measurement of the last tick.")
      .def_property_readonly(
          "command", [](BoundLoop& self) { return self.loop().command(); },
          "Command of the last tick.")
      .def_property_readonly("plant", &BoundLoop::plant, "Plant of the loop.")
      .def_property_readonly("controller", &BoundLoop::controller, "Controller of the loop.");
}

void bind_loop(py::module_& m) {
  py::class_<BoundLoop> loop(
      m, "ClosedLoop",
      "Closed loop of a controller and a plant, with disturbances between them and a record of "
      "the run.\n"
      "\n"
      "The controller ticks at the start of each control period, and its torque is constant "
      "during the period. Plants and controllers are those of the library, or subclasses of "
      "burnish.Plant and burnish.Controller, or objects with their attributes. reset(), step() "
      "and run() raise the exceptions of these objects. The loop does not apply disturbances of "
      "model and scene: make the plant with plant_model() and plant_scene().");
  loop.def(py::init([](py::object plant, py::object controller,
                       const std::optional<Disturbances>& disturbances,
                       const std::optional<ClosedLoopOptions>& options) {
             return std::make_unique<BoundLoop>(std::move(plant), std::move(controller),
                                                disturbances.value_or(Disturbances{}),
                                                options.value_or(ClosedLoopOptions{}));
           }),
           py::arg("plant"), py::arg("controller"), py::arg("disturbances") = py::none(),
           py::arg("options") = py::none(),
           "Raises Error for periods that do not match, a controller of another size, a controller "
           "that reads the wrench on a touch that the plant lacks, and invalid disturbances.")
      .def(
          "estimate_base",
          [](BoundLoop& self, const Model& known, const BaseEstimatorOptions& estimator,
             const std::optional<FootContactOptions>& feet) {
            self.loop().estimate_base(known, estimator, feet.value_or(FootContactOptions{}));
          },
          py::arg("known"), py::arg("estimator"), py::arg("feet") = py::none(),
          loop_estimate_base_doc)
      .def(
          "set_payload",
          [](BoundLoop& self, const std::string& frame, const InertiaSpec& payload) {
            constexpr const char* call = "ClosedLoop.set_payload";
            check_payload(call, payload);
            require(self.loop().set_payload(frame, payload), call);
          },
          py::arg("frame"), py::arg("payload"), loop_payload_doc)
      .def("reset", &BoundLoop::reset, py::arg("q"), py::arg("v") = py::none(), loop_reset_doc)
      .def("step", &BoundLoop::step,
           "Makes one step of the plant. Raises EvaluationError if the plant fails.")
      .def("run", &BoundLoop::run, py::arg("duration"), loop_run_doc)
      .def("__repr__", [](BoundLoop& self) {
        return "<ClosedLoop: " + std::to_string(self.loop().trace().rows()) + " rows recorded>";
      });
  bind_loop_views(loop);
}

}  // namespace

void bind_sim(py::module_& m) {
  bind_plant(m);
  bind_scene(m);
  bind_between(m);
  bind_loop(m);
}

}  // namespace burnish::python

// Bindings of kinematics and dynamics without contacts: frames, centre of mass, momentum, energy.
#include "bind_derivatives.hpp"
#include "machine.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* body_frame_doc =
    R"(Returns the index of a frame, which makes repeated calls faster.

Parameters
----------
name : str
    Name of a frame, or "world".

Returns
-------
int

Raises
------
Error
    If the frame is unknown; the message has the nearest name.)";

constexpr const char* body_placement_doc = R"(Returns the placement of a frame in the world.

Parameters
----------
frame : str or int
    Name or index.

Returns
-------
ndarray, shape (4, 4))";

constexpr const char* body_velocity_doc = R"(Returns the velocity of a frame in a reference.

Parameters
----------
frame : str or int
    Name or index.
reference : Reference or str

Returns
-------
ndarray, shape (6,)
    Linear part [m/s], angular part [rad/s].)";

constexpr const char* body_acceleration_doc = R"(Returns the time derivative of velocity().

Parameters
----------
frame : str or int
    Name or index.
reference : Reference or str

Returns
-------
ndarray, shape (6,)
    Linear part [m/s^2], angular part [rad/s^2].)";

constexpr const char* body_derivatives_doc =
    R"(Returns the derivatives of velocity() and acceleration().

Parameters
----------
frame : str or int
    Name or index.
reference : Reference or str

Returns
-------
FrameDerivatives
    Arrays of shape (6, nv).)";

constexpr const char* body_error_doc =
    R"(Returns the SE(3) logarithm of the placement of a frame in a target.

The result is in the axes of the target.

Parameters
----------
frame : str or int
    Name or index.
target : array_like, shape (4, 4)
    Target placement.

Returns
-------
ndarray, shape (6,)
    Linear part [m], angular part [rad].)";

constexpr const char* body_placement_derivatives_doc =
    R"(Returns the derivatives of placement(), and of its error relative to a target.

Parameters
----------
frame : str or int
    Name or index.
target : array_like, shape (4, 4)
    Target placement.

Returns
-------
PlacementDerivatives)";

constexpr const char* body_update_doc = R"(Evaluates a state.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,), optional
    Velocity; default: at rest.
a : array_like, shape (nv,), optional
    Acceleration; default: zero.

Raises
------
EvaluationError
    If the state is not finite or not normalized; results do not change.
Error
    If sizes are wrong.)";

constexpr const char* body_payload_doc =
    R"(Sets the payload at a frame, and updates the results of the last state.

The payload replaces that of the body of the frame. Derivatives become invalid.

Parameters
----------
frame : str
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.)";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

struct Body {
  Body(const Model& model, double slip_velocity)
      : machine(model, slip_velocity),
        robot(model.name),
        frames(static_cast<int>(model.frames.size())) {}

  /// Returns the index of a frame. The index of the world is the number of frames.
  int frame(const char* name, const NumberOrName& of) const {
    if (const auto* text = std::get_if<std::string>(&of)) return machine.frame(*text);
    const int number = std::get<int>(of);
    if (number >= 0 && number <= frames) return number;
    throw Error("RigidBody." + std::string(name) + ": there is no frame " + std::to_string(number) +
                "; the robot has " + std::to_string(frames) + " frames");
  }

  void update(const Vector& q, const std::optional<Eigen::VectorXd>& given,
              const std::optional<Eigen::VectorXd>& a) {
    constexpr const char* name = "RigidBody.update";
    const Eigen::VectorXd v = given ? *given : Eigen::VectorXd(Eigen::VectorXd::Zero(machine.nv()));
    require_size(name, "q", q.size(), machine.nq());
    require_size(name, "v", v.size(), machine.nv());
    if (a) require_size(name, "a", a->size(), machine.nv());
    const Busy::Lock lock(busy, name);
    Status status = Status::Ok;
    {
      const py::gil_scoped_release unlocked;
      status = a ? machine.update(q, v, *a) : machine.update(q, v);
    }
    require(status, name);
    differentiated = false;
  }

  RigidBody machine;
  std::string robot;
  int frames;
  bool differentiated = false;
  Busy busy;
};

using BodyClass = py::class_<Body>;

/// Binds a property that copies a result.
template <class Result>
void result(BodyClass& of, const char* name, Result (RigidBody::*get)() const, const char* text) {
  of.def_property_readonly(
      name,
      [=](Body& self) {
        const Busy::Lock lock(self.busy, name);
        if constexpr (std::is_same_v<Result, VectorView>) {
          return copied((self.machine.*get)());
        } else {
          return (self.machine.*get)();
        }
      },
      text);
}

/// Binds a property that copies a result of update_derivatives().
template <class View>
void derivative(BodyClass& of, const char* name, View (RigidBody::*get)() const, const char* text) {
  of.def_property_readonly(
      name,
      [=](Body& self) {
        const Busy::Lock lock(self.busy, name);
        if (!self.differentiated)
          throw EvaluationError(
              "RigidBody." + std::string(name) +
              ": this is a result of update_derivatives(), which was not called since "
              "the last update()");
        return copied((self.machine.*get)());
      },
      text);
}

void bind_frames(BodyClass& of) {
  of.def(
        "frame", [](const Body& self, const std::string& name) { return self.machine.frame(name); },
        py::arg("name"), body_frame_doc)
      .def(
          "placement",
          [](Body& self, const NumberOrName& frame) {
            const Busy::Lock lock(self.busy, "RigidBody.placement");
            return self.machine.placement(self.frame("placement", frame));
          },
          py::arg("frame"), body_placement_doc)
      .def(
          "velocity",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.velocity");
            return self.machine.velocity(self.frame("velocity", frame), reference);
          },
          py::arg("frame"), py::arg("reference"), body_velocity_doc)
      .def(
          "acceleration",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.acceleration");
            return self.machine.acceleration(self.frame("acceleration", frame), reference);
          },
          py::arg("frame"), py::arg("reference"), body_acceleration_doc)
      .def(
          "frame_derivatives",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.frame_derivatives");
            FrameDerivatives result;
            self.machine.frame_derivatives(self.frame("frame_derivatives", frame), reference,
                                           result);
            return result;
          },
          py::arg("frame"), py::arg("reference"), body_derivatives_doc)
      .def(
          "placement_error",
          [](Body& self, const NumberOrName& frame, const Eigen::Isometry3d& target) {
            const Busy::Lock lock(self.busy, "RigidBody.placement_error");
            return self.machine.placement_error(self.frame("placement_error", frame), target);
          },
          py::arg("frame"), py::arg("target"), body_error_doc)
      .def(
          "placement_derivatives",
          [](Body& self, const NumberOrName& frame, const Eigen::Isometry3d& target) {
            const Busy::Lock lock(self.busy, "RigidBody.placement_derivatives");
            PlacementDerivatives result;
            self.machine.placement_derivatives(self.frame("placement_derivatives", frame), target,
                                               result);
            return result;
          },
          py::arg("frame"), py::arg("target"), body_placement_derivatives_doc);
}

void bind_whole_robot(BodyClass& of) {
  using B = RigidBody;
  result(of, "mass", &B::mass, "Total mass of the moving bodies [kg].");
  result(of, "com", &B::com, "Centre of mass in the world, shape (3,) [m].");
  result(of, "com_velocity", &B::com_velocity, "Velocity of the centre of mass, shape (3,) [m/s].");
  result(of, "momentum", &B::momentum,
         "Momentum about the origin of the world, shape (6,) [kg m/s, kg m^2/s].");
  result(of, "centroidal_momentum", &B::centroidal_momentum,
         "Momentum about the centre of mass, in world axes, shape (6,) [kg m/s, kg m^2/s].");
  result(of, "kinetic_energy", &B::kinetic_energy,
         "Kinetic energy v^T M v / 2, with armature [J].");
  result(of, "potential_energy", &B::potential_energy,
         "Potential energy of gravity, zero at the origin of the world [J].");
  result(of, "gravity_torque", &B::gravity_torque,
         "Gravity torque b(q, 0), which holds the robot at rest, shape (nv,) [Nm or N].");
  result(of, "passive_torque", &B::passive_torque,
         "Torque of springs and tendons at q, and of damping and smoothed friction at v, shape "
         "(nv,) [Nm or N].");
  result(of, "spring_energy", &B::spring_energy, "Energy in springs of joints and tendons [J].");
  derivative(of, "com_dq", &B::com_dq, "d(com)/dq, shape (3, nv); also d(com_velocity)/dv.");
  derivative(of, "com_velocity_dq", &B::com_velocity_dq, "(3, nv).");
  derivative(of, "momentum_dq", &B::momentum_dq, "(6, nv).");
  derivative(of, "momentum_dv", &B::momentum_dv, "(6, nv).");
  derivative(of, "centroidal_momentum_dq", &B::centroidal_momentum_dq, "(6, nv).");
  derivative(of, "centroidal_momentum_dv", &B::centroidal_momentum_dv,
             "Centroidal momentum matrix, shape (6, nv).");
  derivative(of, "kinetic_energy_dq", &B::kinetic_energy_dq, "(nv,).");
  derivative(of, "kinetic_energy_dv", &B::kinetic_energy_dv, "M v, shape (nv,).");
  derivative(of, "potential_energy_dq", &B::potential_energy_dq,
             "Gradient of the potential energy, which is the gravity torque, shape (nv,).");
  derivative(of, "passive_torque_dq", &B::passive_torque_dq, "(nv, nv).");
  derivative(of, "passive_torque_dv", &B::passive_torque_dv,
             "Derivative of the passive torque with respect to v, shape (nv, nv); diagonal unless "
             "tendons have dampers.");
}

}  // namespace

void bind_rigid_body(py::module_& m) {
  BodyClass of(
      m, "RigidBody",
      "Kinematics and dynamics of a robot without contacts: frames, centre of mass, momentum, "
      "energy, gravity and friction torques, with their derivatives.\n"
      "\n"
      "Linear parts come first. d/dq is the derivative with respect to the right increment q (+) "
      "dq with nv entries. Results are copies at the last state of update(); initially at the "
      "neutral configuration at rest. Only one thread may use an object at a time.");
  of.def(py::init<const Model&, double>(), py::arg("model"), py::arg("slip_velocity") = 0.01,
         "`slip_velocity` is the velocity at which smoothed Coulomb friction reaches 76 % [rad/s "
         "or m/s]. Raises Error unless it is positive.")
      .def_property_readonly(
          "nq", [](const Body& self) { return self.machine.nq(); }, "Number of entries of q.")
      .def_property_readonly(
          "nv", [](const Body& self) { return self.machine.nv(); }, "Number of entries of v.")
      .def("update", &Body::update, py::arg("q"), py::arg("v") = py::none(),
           py::arg("a") = py::none(), body_update_doc)
      .def(
          "set_payload",
          [](Body& self, const std::string& frame, const InertiaSpec& payload) {
            constexpr const char* call = "RigidBody.set_payload";
            const Busy::Lock lock(self.busy, call);
            check_payload(call, payload);
            require(self.machine.set_payload(frame, payload), call);
            self.differentiated = false;
          },
          py::arg("frame"), py::arg("payload"), body_payload_doc)
      .def(
          "update_derivatives",
          [](Body& self) {
            const Busy::Lock lock(self.busy, "RigidBody.update_derivatives");
            const py::gil_scoped_release unlocked;
            self.machine.update_derivatives();
            self.differentiated = true;
          },
          "Computes com_dq and the following properties at the last state.")
      .def("__repr__", [](const Body& self) {
        return "<RigidBody of '" + self.robot + "': nv = " + std::to_string(self.machine.nv()) +
               ", " + std::to_string(self.frames) + " frames>";
      });
  bind_frames(of);
  bind_whole_robot(of);
}

}  // namespace burnish::python

// What a robot's state alone says: frames, centre of mass, momentum, energy.
#include "bind_derivatives.hpp"
#include "machine.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

struct Body {
  Body(const Model& model, double slip_velocity)
      : machine(model, slip_velocity),
        robot(model.name),
        frames(static_cast<int>(model.frames.size())) {}

  /// Number of a frame. One more than there are frames is the world.
  int frame(const char* name, const NumberOrName& of) const {
    if (const auto* text = std::get_if<std::string>(&of)) return machine.frame(*text);
    const int number = std::get<int>(of);
    if (number >= 0 && number <= frames) return number;
    throw Error("RigidBody." + std::string(name) + ": there is no frame " + std::to_string(number) +
                "; the robot has " + std::to_string(frames));
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

/// A property that copies a result.
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

/// The same of update_derivatives().
template <class View>
void derivative(BodyClass& of, const char* name, View (RigidBody::*get)() const, const char* text) {
  of.def_property_readonly(
      name,
      [=](Body& self) {
        const Busy::Lock lock(self.busy, name);
        if (!self.differentiated)
          throw EvaluationError("RigidBody." + std::string(name) +
                                ": a result of update_derivatives(), which was not called since "
                                "the last update()");
        return copied((self.machine.*get)());
      },
      text);
}

void bind_frames(BodyClass& of) {
  of.def(
        "frame", [](const Body& self, const std::string& name) { return self.machine.frame(name); },
        py::arg("name"),
        "Number of a frame of the model, for calls that come often; 'world' is always known. "
        "Raises Error with the nearest known name.")
      .def(
          "placement",
          [](Body& self, const NumberOrName& frame) {
            const Busy::Lock lock(self.busy, "RigidBody.placement");
            return self.machine.placement(self.frame("placement", frame));
          },
          py::arg("frame"), "(4, 4), of a frame (name or number) in the world.")
      .def(
          "velocity",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.velocity");
            return self.machine.velocity(self.frame("velocity", frame), reference);
          },
          py::arg("frame"), py::arg("reference"), "(6,), m/s and rad/s, in the reference.")
      .def(
          "acceleration",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.acceleration");
            return self.machine.acceleration(self.frame("acceleration", frame), reference);
          },
          py::arg("frame"), py::arg("reference"),
          "(6,), time derivative of velocity(): m/s^2 and rad/s^2.")
      .def(
          "frame_derivatives",
          [](Body& self, const NumberOrName& frame, const Reference& reference) {
            const Busy::Lock lock(self.busy, "RigidBody.frame_derivatives");
            FrameDerivatives result;
            self.machine.frame_derivatives(self.frame("frame_derivatives", frame), reference,
                                           result);
            return result;
          },
          py::arg("frame"), py::arg("reference"),
          "Derivatives of velocity() and acceleration(), (6, nv) each.")
      .def(
          "placement_error",
          [](Body& self, const NumberOrName& frame, const Eigen::Isometry3d& target) {
            const Busy::Lock lock(self.busy, "RigidBody.placement_error");
            return self.machine.placement_error(self.frame("placement_error", frame), target);
          },
          py::arg("frame"), py::arg("target"),
          "(6,), SE(3) logarithm of the frame in the target (4, 4): m and rad, target axes.")
      .def(
          "placement_derivatives",
          [](Body& self, const NumberOrName& frame, const Eigen::Isometry3d& target) {
            const Busy::Lock lock(self.busy, "RigidBody.placement_derivatives");
            PlacementDerivatives result;
            self.machine.placement_derivatives(self.frame("placement_derivatives", frame), target,
                                               result);
            return result;
          },
          py::arg("frame"), py::arg("target"),
          "Derivatives of placement() and of its error to the target (4, 4).");
}

void bind_whole_robot(BodyClass& of) {
  using B = RigidBody;
  result(of, "mass", &B::mass, "Of all moving bodies, kg.");
  result(of, "com", &B::com, "(3,), centre of mass, world, m.");
  result(of, "com_velocity", &B::com_velocity, "(3,), m/s.");
  result(of, "momentum", &B::momentum, "(6,), about the world's origin: kg m/s, kg m^2/s.");
  result(of, "centroidal_momentum", &B::centroidal_momentum,
         "(6,), about the centre of mass, world axes.");
  result(of, "kinetic_energy", &B::kinetic_energy, "v^T M v / 2, armature included, J.");
  result(of, "potential_energy", &B::potential_energy,
         "Of gravity, zero at the world's origin, J.");
  result(of, "gravity_torque", &B::gravity_torque,
         "(nv,), holds the robot at rest: b(q, 0), Nm or N.");
  result(of, "passive_torque", &B::passive_torque,
         "(nv,), springs and tendons at q, damping and smoothed friction at v, Nm or N.");
  result(of, "spring_energy", &B::spring_energy, "In springs of joints and tendons, J.");
  derivative(of, "com_dq", &B::com_dq, "(3, nv); d(com_velocity)/dv too.");
  derivative(of, "com_velocity_dq", &B::com_velocity_dq, "(3, nv).");
  derivative(of, "momentum_dq", &B::momentum_dq, "(6, nv).");
  derivative(of, "momentum_dv", &B::momentum_dv, "(6, nv).");
  derivative(of, "centroidal_momentum_dq", &B::centroidal_momentum_dq, "(6, nv).");
  derivative(of, "centroidal_momentum_dv", &B::centroidal_momentum_dv,
             "(6, nv), the centroidal momentum matrix.");
  derivative(of, "kinetic_energy_dq", &B::kinetic_energy_dq, "(nv,).");
  derivative(of, "kinetic_energy_dv", &B::kinetic_energy_dv, "(nv,), M v.");
  derivative(of, "potential_energy_dq", &B::potential_energy_dq, "(nv,), the gravity torque.");
  derivative(of, "passive_torque_dq", &B::passive_torque_dq, "(nv, nv).");
  derivative(of, "passive_torque_dv", &B::passive_torque_dv,
             "(nv, nv), diagonal unless tendons have dampers.");
}

}  // namespace

void bind_rigid_body(py::module_& m) {
  BodyClass of(
      m, "RigidBody",
      "What a robot's state alone says: frames, centre of mass, momentum, energy, gravity and "
      "friction torques, with their derivatives.\n\n"
      "Linear part of motions and momenta first; d/dq is by the right increment q (+) dq of "
      "nv entries. Results are copies, at the last state that update() took, at first the "
      "neutral configuration at rest. One thread at a time.");
  of.def(py::init<const Model&, double>(), py::arg("model"), py::arg("slip_velocity") = 0.01,
         "`slip_velocity` is the rate at which smoothed Coulomb friction reaches 76 %, rad/s or "
         "m/s. Raises Error unless it is positive.")
      .def_property_readonly(
          "nq", [](const Body& self) { return self.machine.nq(); }, "Entries of q.")
      .def_property_readonly(
          "nv", [](const Body& self) { return self.machine.nv(); }, "Entries of v.")
      .def("update", &Body::update, py::arg("q"), py::arg("v") = py::none(),
           py::arg("a") = py::none(),
           "Evaluates the state: q (nq,), v and a (nv,), rad/s or m/s and their rates; without `v` "
           "it is at rest, without `a` the joint accelerations are zero. Raises EvaluationError "
           "for a state that is not "
           "finite or not normalized, Error for wrong sizes; then all results stay as they were.")
      .def(
          "set_payload",
          [](Body& self, const std::string& frame, const InertiaSpec& payload) {
            constexpr const char* call = "RigidBody.set_payload";
            const Busy::Lock lock(self.busy, call);
            check_payload(call, payload);
            require(self.machine.set_payload(frame, payload), call);
            self.differentiated = false;
          },
          py::arg("frame"), py::arg("payload"),
          "What the robot carries at a frame, an InertiaSpec in the frame's axes, in the place of "
          "what that frame's body carried before. Results of the last state are those with it; its "
          "derivatives are gone.")
      .def(
          "update_derivatives",
          [](Body& self) {
            const Busy::Lock lock(self.busy, "RigidBody.update_derivatives");
            const py::gil_scoped_release unlocked;
            self.machine.update_derivatives();
            self.differentiated = true;
          },
          "Fills com_dq and the properties after it, at the last state.")
      .def("__repr__", [](const Body& self) {
        return "<RigidBody of '" + self.robot + "': nv = " + std::to_string(self.machine.nv()) +
               ", " + std::to_string(self.frames) + " frames>";
      });
  bind_frames(of);
  bind_whole_robot(of);
}

}  // namespace burnish::python

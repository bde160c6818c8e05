// Bindings of the contact dynamics of one state, with all derivatives.
#include "bind_derivatives.hpp"
#include "machine.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* dynamics_forward_doc =
    R"(Computes a, lambda_, mass_matrix, bias and jacobian (forward dynamics).

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity [rad/s or m/s].
tau : array_like, shape (nv,)
    Torques [Nm or N].

Returns
-------
Status
    OK or NOT_CONVERGED.

Raises
------
EvaluationError
    If contacts are singular, joints move no mass, or the state is not finite or not normalized.
Error
    If sizes are wrong.)";

constexpr const char* dynamics_inverse_doc =
    R"(Computes tau = M a + b - J^T lambda_ (inverse dynamics).

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity [rad/s or m/s].
a : array_like, shape (nv,)
    Acceleration [rad/s^2 or m/s^2].
lambda_ : array_like, shape (rows,)
    Contact forces [N or Nm].

Returns
-------
Status
    OK or NOT_CONVERGED.

Raises
------
EvaluationError
    If contacts are singular, joints move no mass, or the state is not finite or not normalized.
Error
    If sizes are wrong.)";

constexpr const char* dynamics_acceleration_doc =
    R"(Computes alpha = J a + alpha_0 + kd nu + kp e, the stabilized contact acceleration.

Parameters
----------
q : array_like, shape (nq,)
    Configuration.
v : array_like, shape (nv,)
    Velocity [rad/s or m/s].
a : array_like, shape (nv,)
    Acceleration [rad/s^2 or m/s^2].

Returns
-------
Status
    OK or NOT_CONVERGED.

Raises
------
EvaluationError
    If contacts are singular, joints move no mass, or the state is not finite or not normalized.
Error
    If sizes are wrong.)";

constexpr const char* dynamics_force_doc =
    R"(Returns the force of a contact at the last forward(), or lambda_ of the last inverse().

Parameters
----------
contact : str or int
    Name or index.
reference : Reference or str, optional
    Default: the reference of the contact.

Returns
-------
ContactForce
    Zero for an inactive contact.

Raises
------
EvaluationError
    If the last evaluation was another one.)";

constexpr const char* dynamics_wrench_doc =
    R"(Returns the wrench of a contact, as force() does, as an array.

Parameters
----------
contact : str or int
    Name or index.
reference : Reference or str

Returns
-------
ndarray, shape (6,)
    Force [N], moment [Nm].)";

constexpr const char* dynamics_wrench_derivatives_doc =
    R"(Returns the derivatives of wrench() at the last forward_derivatives().

Parameters
----------
contact : str or int
    Name or index.
reference : Reference or str

Returns
-------
WrenchDerivatives
    Arrays of shape (6, nv).)";

constexpr const char* dynamics_regressor_doc =
    R"(Returns the regressor Y of inertial parameters at the last forward() or inverse().

Parameters
----------
bodies : sequence of int
    Indices of joints.

Returns
-------
ndarray, shape (nv, 10 * bodies)
    With theta, the inertia_parameters() of all bodies: M a + b = Y theta + armature * a.)";

constexpr const char* dynamics_inertia_derivatives_doc =
    R"(Returns derivatives with respect to inertial parameters at the last forward_derivatives().

Parameters
----------
bodies : sequence of int
    Indices of joints.

Returns
-------
tuple of ndarray
    Derivatives of a (nv, 10 * bodies) and lambda_ (rows, 10 * bodies), at constant torques.)";

constexpr const char* dynamics_payload_doc =
    R"(Sets the payload at a frame. Invalidates previous results.

The payload replaces that of the body of the frame.

Parameters
----------
frame : str
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.)";

constexpr const char* dynamics_active_doc =
    R"(Activates or deactivates a contact. Invalidates previous results.

Parameters
----------
contact : str or int
    Name or index.
active : bool)";

constexpr const char* dynamics_rotation_doc =
    R"(Sets the rotation of the reference of a contact. Invalidates previous results.

Parameters
----------
contact : str or int
    Name or index.
rotation : array_like, shape (3, 3))";

constexpr const char* dynamics_surface_doc =
    R"(Sets the surface that the reference of a contact follows. Invalidates previous results.

Parameters
----------
contact : str or int
    Name or index.
surface : Quadric
    Surface, in the axes of the base.)";

constexpr const char* dynamics_friction_doc =
    R"(Sets the friction coefficient of a contact. Invalidates previous results.

Parameters
----------
contact : str or int
    Name or index.
coefficient : float
    Friction coefficient, at least 0.)";

constexpr const char* dynamics_init_doc = R"(Compiles contacts for a model.

Parameters
----------
model : Model
contacts : sequence of ContactSpec
solver : ContactSolver, optional

Raises
------
Error
    If a contact is invalid.)";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

/// Bits for the kinds of evaluation, and for their derivatives.
enum : unsigned { forward = 1, inverse = 2, acceleration = 4, derivatives = 8 };
constexpr unsigned any = forward | inverse | acceleration;

struct Dynamics {
  Dynamics(const Model& model, const std::vector<ContactSpec>& specs, const ContactSolver& solver)
      : machine(model, specs, solver), robot(model.name), nq(model.nq) {
    for (const ContactSpec& contact : machine.contacts().specs()) names.push_back(contact.name);
  }

  /// Runs `evaluate` without the GIL. Throws for a status other than Ok and NotConverged; only
  /// forward dynamics returns NotConverged.
  Status run(unsigned what, const char* name, const auto& evaluate) {
    const Busy::Lock lock(busy, name);
    if ((what & derivatives) == 0) evaluated = 0;
    Status status = Status::Ok;
    {
      const py::gil_scoped_release unlocked;
      status = evaluate(machine);
    }
    if (status == Status::SingularMass || status == Status::SingularContacts)
      throw EvaluationError(std::string(name) + ": " + machine.explanation());
    require(status, name);
    evaluated |= what;
    return status;
  }
  void require_state_sizes(const char* name, const Vector& q, const Vector& v) const {
    require_size(name, "q", q.size(), nq);
    require_size(name, "v", v.size(), machine.nv());
  }
  /// Throws EvaluationError unless `by` contains the bit of the last evaluation. If
  /// `differentiated`, derivatives must have been evaluated too.
  void require_result(const char* name, unsigned by, bool differentiated) const {
    if ((evaluated & by) != 0 && (!differentiated || (evaluated & derivatives) != 0)) return;
    std::string wanted;
    for (const auto& [bit, call] : {std::pair{forward, "forward"}, std::pair{inverse, "inverse"},
                                    std::pair{acceleration, "acceleration"}})
      if ((by & bit) != 0)
        wanted += (wanted.empty() ? "" : " or ") + std::string(call) +
                  (differentiated ? "_derivatives()" : "()");
    throw EvaluationError("ContactDynamics." + std::string(name) + ": this is a result of " +
                          wanted +
                          ", which was not called since the last evaluation or change of contacts");
  }

  ContactDynamics machine;
  std::string robot;
  std::vector<std::string> names;  ///< Names of the contacts
  int nq;
  unsigned evaluated = 0;
  Busy busy;
};

using DynamicsClass = py::class_<Dynamics>;

/// Binds a property that copies a result. `by`: bits of the evaluations that compute this result.
template <class View>
void result(DynamicsClass& of, const char* name, View (ContactDynamics::*view)() const, unsigned by,
            bool differentiated, const char* text) {
  of.def_property_readonly(
      name,
      [=](Dynamics& self) {
        const Busy::Lock lock(self.busy, name);
        self.require_result(name, by, differentiated);
        return copied((self.machine.*view)());
      },
      text);
}

void bind_forward(DynamicsClass& of) {
  of.def(
        "forward",
        [](Dynamics& self, const Vector& q, const Vector& v, const Vector& tau) {
          constexpr const char* name = "ContactDynamics.forward";
          self.require_state_sizes(name, q, v);
          require_size(name, "tau", tau.size(), self.machine.nv());
          return self.run(forward, name, [&](auto& machine) { return machine.forward(q, v, tau); });
        },
        py::arg("q"), py::arg("v"), py::arg("tau"), dynamics_forward_doc)
      .def(
          "forward_derivatives",
          [](Dynamics& self) {
            return self.run(forward | derivatives, "ContactDynamics.forward_derivatives",
                            [](auto& machine) { return machine.forward_derivatives(); });
          },
          "Computes the six derivative blocks of a and lambda_ at the last forward(). Returns the "
          "status of forward(). Raises EvaluationError if the last evaluation was not forward().");
}

void bind_inverse(DynamicsClass& of) {
  of.def(
        "inverse",
        [](Dynamics& self, const Vector& q, const Vector& v, const Vector& a,
           const Vector& lambda) {
          constexpr const char* name = "ContactDynamics.inverse";
          self.require_state_sizes(name, q, v);
          require_size(name, "a", a.size(), self.machine.nv());
          require_size(name, "lambda_", lambda.size(), self.machine.rows());
          return self.run(inverse, name,
                          [&](auto& machine) { return machine.inverse(q, v, a, lambda); });
        },
        py::arg("q"), py::arg("v"), py::arg("a"), py::arg("lambda_"), dynamics_inverse_doc)
      .def(
          "inverse_derivatives",
          [](Dynamics& self) {
            return self.run(inverse | derivatives, "ContactDynamics.inverse_derivatives",
                            [](auto& machine) { return machine.inverse_derivatives(); });
          },
          "Computes dtau_dq and dtau_dv at the last inverse(). dtau/da is mass_matrix, and "
          "dtau/dlambda is -jacobian.T. Raises EvaluationError if the last evaluation was not "
          "inverse().")
      .def(
          "acceleration",
          [](Dynamics& self, const Vector& q, const Vector& v, const Vector& a) {
            constexpr const char* name = "ContactDynamics.acceleration";
            self.require_state_sizes(name, q, v);
            require_size(name, "a", a.size(), self.machine.nv());
            return self.run(acceleration, name,
                            [&](auto& machine) { return machine.acceleration(q, v, a); });
          },
          py::arg("q"), py::arg("v"), py::arg("a"), dynamics_acceleration_doc)
      .def(
          "acceleration_derivatives",
          [](Dynamics& self) {
            return self.run(acceleration | derivatives, "ContactDynamics.acceleration_derivatives",
                            [](auto& machine) { return machine.acceleration_derivatives(); });
          },
          "Computes dalpha_dq and dalpha_dv at the last acceleration(). dalpha/da is jacobian. "
          "Raises EvaluationError if the last evaluation was not acceleration().");
}

void bind_result_derivatives(DynamicsClass& of) {
  using D = ContactDynamics;
  result(of, "da_dq", &D::da_dq, forward, true,
         "da/dq with respect to the right tangent increment of q, shape (nv, nv): result of "
         "forward_derivatives().");
  result(of, "da_dv", &D::da_dv, forward, true,
         "da/dv, shape (nv, nv): result of forward_derivatives().");
  result(of, "da_dtau", &D::da_dtau, forward, true,
         "da/dtau, shape (nv, nv): result of forward_derivatives().");
  result(of, "dlambda_dq", &D::dlambda_dq, forward, true,
         "dlambda/dq, shape (rows, nv): result of forward_derivatives().");
  result(of, "dlambda_dv", &D::dlambda_dv, forward, true,
         "dlambda/dv, shape (rows, nv): result of forward_derivatives().");
  result(of, "dlambda_dtau", &D::dlambda_dtau, forward, true,
         "dlambda/dtau, shape (rows, nv): result of forward_derivatives().");
  result(of, "dtau_dq", &D::dtau_dq, inverse, true,
         "dtau/dq, shape (nv, nv): result of inverse_derivatives().");
  result(of, "dtau_dv", &D::dtau_dv, inverse, true,
         "dtau/dv, shape (nv, nv): result of inverse_derivatives().");
  result(of, "dalpha_dq", &D::dalpha_dq, acceleration, true,
         "dalpha/dq, shape (rows, nv): result of acceleration_derivatives().");
  result(of, "dalpha_dv", &D::dalpha_dv, acceleration, true,
         "dalpha/dv, shape (rows, nv): result of acceleration_derivatives().");
}

void bind_results(DynamicsClass& of) {
  using D = ContactDynamics;
  result(of, "a", &D::a, any, false,
         "Joint accelerations, shape (nv,) [rad/s^2 or m/s^2]: result of forward(), or argument "
         "of inverse() or acceleration().");
  result(of, "lambda_", &D::lambda, forward | inverse, false,
         "Contact forces, shape (rows,) [N or Nm]: result of forward(), or argument of inverse().");
  result(of, "tau", &D::tau, inverse, false,
         "Torques, shape (nv,) [Nm or N]: result of inverse().");
  result(of, "alpha", &D::alpha, acceleration, false,
         "Contact acceleration with its stabilization, shape (rows,) [m/s^2 or rad/s^2]: result "
         "of acceleration().");
  result(of, "bias", &D::bias, any, false,
         "Bias b(q, v) of the last evaluation: Coriolis, centrifugal and gravity torques, shape "
         "(nv,) [Nm or N].");
  result(of, "mass_matrix", &D::mass_matrix, any, false,
         "Mass matrix with armature, shape (nv, nv).");
  result(of, "jacobian", &D::jacobian, any, false,
         "Jacobian of the active contacts, shape (rows, nv).");
  result(of, "contact_velocity", &D::contact_velocity, any, false,
         "Contact velocity nu of the active rows at the last state, shape (rows,) [m/s or rad/s].");
  result(of, "contact_error", &D::contact_error, any, false,
         "Pose error e of the active rows at the last state, shape (rows,) [m or rad].");
  of.def_property_readonly(
        "proximal_iterations",
        [](const Dynamics& self) {
          self.require_result("proximal_iterations", forward, false);
          return self.machine.proximal_iterations();
        },
        "Number of proximal iterations of the last forward().")
      .def_property_readonly(
          "proximal_residual",
          [](const Dynamics& self) {
            self.require_result("proximal_residual", forward, false);
            return self.machine.proximal_residual();
          },
          "Remaining contact acceleration after the proximal iterations [m/s^2].");
  result(of, "unmet", &D::unmet, forward, false,
         "Contact acceleration that no force can achieve at the last forward(), because redundant "
         "rows contradict each other; shape (rows,) [m/s^2 or rad/s^2]. The status is then "
         "NOT_CONVERGED, and lambda_ has the least-squares forces of minimum norm. Zero "
         "otherwise.");
}

void bind_forces(DynamicsClass& of) {
  of.def(
        "force",
        [](Dynamics& self, const NumberOrName& contact, const std::optional<Reference>& reference) {
          constexpr const char* name = "ContactDynamics.force";
          const Busy::Lock lock(self.busy, name);
          const int number = contact_number(name, contact, self.names);
          self.require_result("force", forward | inverse, false);
          return reference ? self.machine.force(number, *reference) : self.machine.force(number);
        },
        py::arg("contact"), py::arg("reference") = py::none(), dynamics_force_doc)
      .def(
          "wrench",
          [](Dynamics& self, const NumberOrName& contact, const Reference& reference) {
            constexpr const char* name = "ContactDynamics.wrench";
            const Busy::Lock lock(self.busy, name);
            const int number = contact_number(name, contact, self.names);
            self.require_result("wrench", forward | inverse, false);
            return self.machine.wrench(number, reference);
          },
          py::arg("contact"), py::arg("reference"), dynamics_wrench_doc)
      .def(
          "wrench_derivatives",
          [](Dynamics& self, const NumberOrName& contact, const Reference& reference) {
            constexpr const char* name = "ContactDynamics.wrench_derivatives";
            const Busy::Lock lock(self.busy, name);
            const int number = contact_number(name, contact, self.names);
            self.require_result("wrench_derivatives", forward, true);
            WrenchDerivatives result;
            self.machine.wrench_derivatives(number, reference, result);
            return result;
          },
          py::arg("contact"), py::arg("reference"), dynamics_wrench_derivatives_doc);
}

/// Binds derivatives with respect to inertial parameters.
void bind_parameters(DynamicsClass& of) {
  of.def(
        "regressor",
        [](Dynamics& self, const std::vector<int>& bodies) {
          const Busy::Lock lock(self.busy, "ContactDynamics.regressor");
          self.require_result("regressor", forward | inverse, false);
          RowMatrix Y;
          require(self.machine.regressor(bodies, Y), "ContactDynamics.regressor");
          return Y;
        },
        py::arg("bodies"), dynamics_regressor_doc)
      .def(
          "inertia_derivatives",
          [](Dynamics& self, const std::vector<int>& bodies) {
            const Busy::Lock lock(self.busy, "ContactDynamics.inertia_derivatives");
            self.require_result("inertia_derivatives", forward, true);
            InertiaDerivatives d;
            require(self.machine.inertia_derivatives(bodies, d),
                    "ContactDynamics.inertia_derivatives");
            return std::pair{d.a, d.lambda};
          },
          py::arg("bodies"), dynamics_inertia_derivatives_doc);
}

void bind_payload(DynamicsClass& of) {
  of.def(
      "set_payload",
      [](Dynamics& self, const std::string& frame, const InertiaSpec& payload) {
        constexpr const char* call = "ContactDynamics.set_payload";
        const Busy::Lock lock(self.busy, call);
        check_payload(call, payload);
        require(self.machine.set_payload(frame, payload), call);
        self.evaluated = 0;
      },
      py::arg("frame"), py::arg("payload"), dynamics_payload_doc);
}

/// Binds changes of contacts: activation, reference, surface, friction.
void bind_contacts(DynamicsClass& of) {
  of.def(
        "set_active",
        [](Dynamics& self, const NumberOrName& contact, bool active) {
          const Busy::Lock lock(self.busy, "ContactDynamics.set_active");
          const int number = contact_number("ContactDynamics.set_active", contact, self.names);
          self.machine.set_active(number, active);
          self.evaluated = 0;
        },
        py::arg("contact"), py::arg("active"), dynamics_active_doc)
      .def(
          "set_reference_rotation",
          [](Dynamics& self, const NumberOrName& contact, const Eigen::Matrix3d& rotation) {
            constexpr const char* call = "ContactDynamics.set_reference_rotation";
            const Busy::Lock lock(self.busy, call);
            const int number = contact_number(call, contact, self.names);
            self.evaluated = 0;
            if (self.machine.set_reference_rotation(number, rotation) != Status::Ok)
              throw Error(
                  std::string(call) +
                  ": rotation is not a rotation matrix; wanted orthonormal rows and determinant 1");
          },
          py::arg("contact"), py::arg("rotation"), dynamics_rotation_doc)
      .def(
          "set_surface",
          [](Dynamics& self, const NumberOrName& contact, const Quadric& surface) {
            constexpr const char* call = "ContactDynamics.set_surface";
            const Busy::Lock lock(self.busy, call);
            const int number = contact_number(call, contact, self.names);
            self.evaluated = 0;
            if (self.machine.set_surface(number, surface) != Status::Ok)
              throw Error(std::string(call) + ": the surface holds a NaN or an infinity");
          },
          py::arg("contact"), py::arg("surface"), dynamics_surface_doc)
      .def(
          "set_friction",
          [](Dynamics& self, const NumberOrName& contact, double coefficient) {
            constexpr const char* call = "ContactDynamics.set_friction";
            const Busy::Lock lock(self.busy, call);
            const int number = contact_number(call, contact, self.names);
            self.evaluated = 0;
            if (self.machine.set_friction(number, coefficient) != Status::Ok)
              throw Error(std::string(call) + ": the friction coefficient is " +
                          std::to_string(coefficient) + "; wanted at least 0");
          },
          py::arg("contact"), py::arg("coefficient"), dynamics_friction_doc)
      .def(
          "is_active",
          [](const Dynamics& self, const NumberOrName& contact) {
            return self.machine.is_active(
                contact_number("ContactDynamics.is_active", contact, self.names));
          },
          py::arg("contact"), "Returns whether a contact (name or index) is active.");
}

}  // namespace

void bind_contact_dynamics(py::module_& m) {
  DynamicsClass of(
      m, "ContactDynamics",
      "Dynamics of a robot in contact, one state at a time, with all derivatives.\n"
      "\n"
      "M a + b = tau + J^T lambda_. Linear parts come first. d/dq is the derivative with respect "
      "to the right increment q (+) dq with nv entries. Rows are those of the active contacts, in "
      "the given order. Results are copies of the last evaluation. Reading a result that the last "
      "evaluation did not compute raises EvaluationError. Only one thread may use an object at a "
      "time.");
  of.def(py::init([](const Model& model, const std::vector<ContactSpec>& contacts,
                     const std::optional<ContactSolver>& solver) {
           return std::make_unique<Dynamics>(model, contacts, solver.value_or(ContactSolver{}));
         }),
         py::arg("model"), py::arg("contacts") = py::tuple(), py::arg("solver") = py::none(),
         dynamics_init_doc)
      .def_property_readonly(
          "contacts", [](const Dynamics& self) { return self.machine.contacts().specs(); },
          "Contacts with their names, in the given order.")
      .def_readonly("nq", &Dynamics::nq, "Number of entries of q.")
      .def_property_readonly(
          "nv", [](const Dynamics& self) { return self.machine.nv(); },
          "Number of entries of v, tau and a.")
      .def_property_readonly(
          "rows", [](const Dynamics& self) { return self.machine.rows(); },
          "Number of rows of the active contacts, and of entries of lambda_ and alpha.")
      .def_property_readonly(
          "row_names", [](const Dynamics& self) { return self.machine.row_names(); },
          "Names of the active rows, such as 'pad/z'.")
      .def(
          "explanation",
          [](Dynamics& self) {
            const Busy::Lock lock(self.busy, "ContactDynamics.explanation");
            self.require_result("explanation", any, false);
            return self.machine.explanation();
          },
          "Returns a sentence with the status of the last evaluation and its cause, such as "
          "contact rows that contradict each other.")
      .def("__repr__", [](const Dynamics& self) {
        std::string text = "<ContactDynamics of '" + self.robot +
                           "': nv = " + std::to_string(self.machine.nv()) + ", rows";
        for (const std::string& row : self.machine.row_names()) text += " " + row;
        return text + (self.machine.rows() == 0 ? " none>" : ">");
      });
  bind_contacts(of);
  bind_payload(of);
  bind_parameters(of);
  bind_forward(of);
  bind_inverse(of);
  bind_results(of);
  bind_result_derivatives(of);
  bind_forces(of);
}

}  // namespace burnish::python

// Contact dynamics of one state, with all derivatives.
#include "bind_derivatives.hpp"
#include "machine.hpp"
#include "specs_model.hpp"

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

/// Evaluations and the derivatives of each: results belong to the last ones made.
enum : unsigned { forward = 1, inverse = 2, acceleration = 4, derivatives = 8 };
constexpr unsigned any = forward | inverse | acceleration;

struct Dynamics {
  Dynamics(const Model& model, const std::vector<ContactSpec>& specs, const ContactSolver& solver)
      : machine(model, specs, solver), robot(model.name), nq(model.nq) {
    for (const ContactSpec& contact : machine.contacts().specs()) names.push_back(contact.name);
  }

  /// Runs `evaluate` with the interpreter's lock released. Throws for all but Ok and NotConverged,
  /// which forward dynamics alone may answer.
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
  /// Throws EvaluationError unless the last evaluation was one of `by`, differentiated if
  /// `differentiated`.
  void require_result(const char* name, unsigned by, bool differentiated) const {
    if ((evaluated & by) != 0 && (!differentiated || (evaluated & derivatives) != 0)) return;
    std::string wanted;
    for (const auto& [bit, call] : {std::pair{forward, "forward"}, std::pair{inverse, "inverse"},
                                    std::pair{acceleration, "acceleration"}})
      if ((by & bit) != 0)
        wanted += (wanted.empty() ? "" : " or ") + std::string(call) +
                  (differentiated ? "_derivatives()" : "()");
    throw EvaluationError("ContactDynamics." + std::string(name) + ": a result of " + wanted +
                          ", which was not called since the last evaluation or change of contacts");
  }

  ContactDynamics machine;
  std::string robot;
  std::vector<std::string> names;  ///< of the contacts
  int nq;
  unsigned evaluated = 0;
  Busy busy;
};

using DynamicsClass = py::class_<Dynamics>;

/// A property that copies a result of the calls `by`.
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
        py::arg("q"), py::arg("v"), py::arg("tau"),
        "Fills a, lambda_, mass_matrix, bias, jacobian. q: (nq,), v: (nv,), tau: (nv,), Nm or N. "
        "Returns OK or NOT_CONVERGED; raises EvaluationError for singular contacts and joints that "
        "move no mass, which it names, and for a state that is not finite or not normalized, Error "
        "for wrong sizes.")
      .def(
          "forward_derivatives",
          [](Dynamics& self) {
            return self.run(forward | derivatives, "ContactDynamics.forward_derivatives",
                            [](auto& machine) { return machine.forward_derivatives(); });
          },
          "Fills the six derivative blocks of a and lambda_ at the last forward(). Returns what "
          "that returned; raises EvaluationError if another evaluation came between.");
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
        py::arg("q"), py::arg("v"), py::arg("a"), py::arg("lambda_"),
        "Fills tau = M a + b - J^T lambda_. q: (nq,), v: (nv,), a: (nv,), lambda_: (rows,), N or "
        "Nm. Returns and raises as forward().")
      .def(
          "inverse_derivatives",
          [](Dynamics& self) {
            return self.run(inverse | derivatives, "ContactDynamics.inverse_derivatives",
                            [](auto& machine) { return machine.inverse_derivatives(); });
          },
          "Fills dtau_dq and dtau_dv at the last inverse(); dtau/da is mass_matrix, dtau/dlambda "
          "is -jacobian.T. Returns as forward_derivatives().")
      .def(
          "acceleration",
          [](Dynamics& self, const Vector& q, const Vector& v, const Vector& a) {
            constexpr const char* name = "ContactDynamics.acceleration";
            self.require_state_sizes(name, q, v);
            require_size(name, "a", a.size(), self.machine.nv());
            return self.run(acceleration, name,
                            [&](auto& machine) { return machine.acceleration(q, v, a); });
          },
          py::arg("q"), py::arg("v"), py::arg("a"),
          "Fills alpha, the contact acceleration J a + alpha_0 plus kd nu + kp e. q: (nq,), v: "
          "(nv,), a: (nv,). Returns and raises as forward().")
      .def(
          "acceleration_derivatives",
          [](Dynamics& self) {
            return self.run(acceleration | derivatives, "ContactDynamics.acceleration_derivatives",
                            [](auto& machine) { return machine.acceleration_derivatives(); });
          },
          "Fills dalpha_dq and dalpha_dv at the last acceleration(); dalpha/da is jacobian. "
          "Returns "
          "as forward_derivatives().");
}

void bind_results(DynamicsClass& of) {
  using D = ContactDynamics;
  result(of, "a", &D::a, any, false,
         "(nv,), rad/s^2 or m/s^2: of forward(), or as given to inverse() or acceleration().");
  result(of, "lambda_", &D::lambda, forward | inverse, false,
         "(rows,), N or Nm: of forward(), or as given to inverse().");
  result(of, "tau", &D::tau, inverse, false, "(nv,), Nm or N: of inverse().");
  result(of, "alpha", &D::alpha, acceleration, false,
         "(rows,), m/s^2 or rad/s^2: of acceleration().");
  result(of, "bias", &D::bias, any, false, "(nv,), b(q, v) of the last evaluation, Nm or N.");
  result(of, "mass_matrix", &D::mass_matrix, any, false, "(nv, nv), armature included.");
  result(of, "jacobian", &D::jacobian, any, false, "(rows, nv), of the active contacts.");
  result(of, "da_dq", &D::da_dq, forward, true,
         "(nv, nv), by the right tangent increment of q; of forward_derivatives().");
  result(of, "da_dv", &D::da_dv, forward, true, "(nv, nv), of forward_derivatives().");
  result(of, "da_dtau", &D::da_dtau, forward, true, "(nv, nv), of forward_derivatives().");
  result(of, "dlambda_dq", &D::dlambda_dq, forward, true, "(rows, nv), of forward_derivatives().");
  result(of, "dlambda_dv", &D::dlambda_dv, forward, true, "(rows, nv), of forward_derivatives().");
  result(of, "dlambda_dtau", &D::dlambda_dtau, forward, true,
         "(rows, nv), of forward_derivatives().");
  result(of, "dtau_dq", &D::dtau_dq, inverse, true, "(nv, nv), of inverse_derivatives().");
  result(of, "dtau_dv", &D::dtau_dv, inverse, true, "(nv, nv), of inverse_derivatives().");
  result(of, "dalpha_dq", &D::dalpha_dq, acceleration, true,
         "(rows, nv), of acceleration_derivatives().");
  result(of, "dalpha_dv", &D::dalpha_dv, acceleration, true,
         "(rows, nv), of acceleration_derivatives().");
  result(of, "contact_velocity", &D::contact_velocity, any, false,
         "(rows,), nu of the active rows at the last state, m/s or rad/s.");
  result(of, "contact_error", &D::contact_error, any, false,
         "(rows,), pose error e of the active rows at the last state, m or rad.");
  of.def_property_readonly(
        "proximal_iterations",
        [](const Dynamics& self) {
          self.require_result("proximal_iterations", forward, false);
          return self.machine.proximal_iterations();
        },
        "Proximal iterations of the last forward().")
      .def_property_readonly(
          "proximal_residual",
          [](const Dynamics& self) {
            self.require_result("proximal_residual", forward, false);
            return self.machine.proximal_residual();
          },
          "Contact acceleration that the proximal iterations left, m/s^2.");
  result(of, "unmet", &D::unmet, forward, false,
         "(rows,), m/s^2 or rad/s^2: contact acceleration that no force can meet at the last "
         "forward(), where redundant rows contradict each other. The status is then "
         "NOT_CONVERGED, lambda_ the least-squares forces, of least norm. Zeros otherwise.");
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
        py::arg("contact"), py::arg("reference") = py::none(),
        "The force of a contact (name or number) at the last forward(), or of the lambda_ given to "
        "the last inverse(), in a reference, by default the contact's own; zero for one that is "
        "not active.")
      .def(
          "wrench",
          [](Dynamics& self, const NumberOrName& contact, const Reference& reference) {
            constexpr const char* name = "ContactDynamics.wrench";
            const Busy::Lock lock(self.busy, name);
            const int number = contact_number(name, contact, self.names);
            self.require_result("wrench", forward | inverse, false);
            return self.machine.wrench(number, reference);
          },
          py::arg("contact"), py::arg("reference"),
          "The same as numbers (6,) in any reference: force (N), then moment (Nm).")
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
          py::arg("contact"), py::arg("reference"),
          "Derivatives of wrench(), (6, nv) each, at the last forward_derivatives().");
}

/// Derivatives by mass distributions.
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
        py::arg("bodies"),
        "(nv, 10 per body) at the last forward() or inverse(): with the inertia_parameters() theta "
        "of all bodies (numbers of the model's joints), M a + b = Y theta + armature * a.")
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
          py::arg("bodies"),
          "Derivatives of a (nv, 10 per body) and lambda_ (rows, 10 per body) by those parameters, "
          "torques held, at the last forward_derivatives().");
}

/// What the robot carries.
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
      py::arg("frame"), py::arg("payload"),
      "What the robot carries at a frame from now on, an InertiaSpec in the frame's axes, in "
      "the place of what that frame's body carried before. Results before it are gone.");
}

/// Which contacts hold, and how.
void bind_contacts(DynamicsClass& of) {
  of.def(
        "set_active",
        [](Dynamics& self, const NumberOrName& contact, bool active) {
          const Busy::Lock lock(self.busy, "ContactDynamics.set_active");
          const int number = contact_number("ContactDynamics.set_active", contact, self.names);
          self.machine.set_active(number, active);
          self.evaluated = 0;
        },
        py::arg("contact"), py::arg("active"),
        "Makes or breaks a contact (name or number). Results before it are gone.")
      .def(
          "set_reference_rotation",
          [](Dynamics& self, const NumberOrName& contact, const Eigen::Matrix3d& rotation) {
            constexpr const char* call = "ContactDynamics.set_reference_rotation";
            const Busy::Lock lock(self.busy, call);
            const int number = contact_number(call, contact, self.names);
            self.evaluated = 0;
            if (self.machine.set_reference_rotation(number, rotation) != Status::Ok)
              throw Error(std::string(call) + ": this is not a rotation matrix");
          },
          py::arg("contact"), py::arg("rotation"),
          "Another rotation (3, 3) in the place of that of a contact's reference (name or number), "
          "for states evaluated from then on. Results before it are gone.")
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
          py::arg("contact"), py::arg("surface"),
          "Another Quadric in the place of the one that a contact's reference follows (name or "
          "number; Reference.on), for states evaluated from then on. Results before it are gone.")
      .def(
          "set_friction",
          [](Dynamics& self, const NumberOrName& contact, double coefficient) {
            constexpr const char* call = "ContactDynamics.set_friction";
            const Busy::Lock lock(self.busy, call);
            const int number = contact_number(call, contact, self.names);
            self.evaluated = 0;
            if (self.machine.set_friction(number, coefficient) != Status::Ok)
              throw Error(std::string(call) + ": the coefficient is " +
                          std::to_string(coefficient) + "; wanted at least 0");
          },
          py::arg("contact"), py::arg("coefficient"),
          "Another coefficient of the friction of a contact (name or number), for states evaluated "
          "from then on. Results before it are gone.")
      .def(
          "is_active",
          [](const Dynamics& self, const NumberOrName& contact) {
            return self.machine.is_active(
                contact_number("ContactDynamics.is_active", contact, self.names));
          },
          py::arg("contact"), "Whether a contact (name or number) is made.");
}

}  // namespace

void bind_contact_dynamics(py::module_& m) {
  DynamicsClass of(
      m, "ContactDynamics",
      "Dynamics of a robot in contact, one state at a time, with all derivatives.\n\n"
      "M a + b = tau + J^T lambda_; linear parts first; d/dq is by the right increment "
      "q (+) dq of nv entries; rows are those of the active contacts, in the order given. "
      "Results are copies. They belong to the last evaluation: others are refused with "
      "EvaluationError. One thread at a time.");
  of.def(py::init([](const Model& model, const std::vector<ContactSpec>& contacts,
                     const std::optional<ContactSolver>& solver) {
           return std::make_unique<Dynamics>(model, contacts, solver.value_or(ContactSolver{}));
         }),
         py::arg("model"), py::arg("contacts") = py::tuple(), py::arg("solver") = py::none(),
         "Compiles the contacts against the model. Raises Error with one sentence.")
      .def_property_readonly(
          "contacts", [](const Dynamics& self) { return self.machine.contacts().specs(); },
          "The contacts, in the order given, all named.")
      .def_readonly("nq", &Dynamics::nq, "Entries of q.")
      .def_property_readonly(
          "nv", [](const Dynamics& self) { return self.machine.nv(); }, "Entries of v, tau and a.")
      .def_property_readonly(
          "rows", [](const Dynamics& self) { return self.machine.rows(); },
          "Rows of the active contacts: entries of lambda_ and alpha.")
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
          "The status of the last evaluation in one sentence that names what is to blame, such as "
          "the contact rows that contradict each other.")
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
  bind_forces(of);
}

}  // namespace burnish::python

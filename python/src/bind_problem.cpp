// Bindings of Problem: sizes, names, knots, targets, states, and evaluations of one knot.
#include "bind_derivatives.hpp"
#include "bind_ocp.hpp"
#include "specs_model.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

void check_size(const char* call, const char* argument, Eigen::Index came, int wanted_size) {
  if (came != wanted_size)
    throw Error(std::string(call) + ": " + argument + " has " + std::to_string(came) +
                " entries; wanted " + std::to_string(wanted_size));
}

namespace {

// Docstrings.

constexpr const char* problem_surface_doc =
    R"(Sets the surface that the reference of a contact follows at a knot.

It applies until the knot is set or advanced. Stages without the contact ignore it.

Parameters
----------
knot : int
contact : str or int
    Name or index.
surface : Quadric
    Surface, in the axes of the base.)";

constexpr const char* problem_term_surface_doc =
    R"(Sets the surface that the reference of a cost term follows at a knot.

It applies until the knot is set or advanced.

Parameters
----------
knot : int
term : str or int
    Name or index of the cost term.
surface : Quadric
    Surface, in the axes of the base.)";

constexpr const char* problem_friction_doc =
    R"(Sets the friction coefficient of a contact at a knot.

It applies until the knot is set or advanced.

Parameters
----------
knot : int
contact : str or int
    Name or index.
coefficient : float
    Friction coefficient, at least 0.)";

constexpr const char* problem_initial_state_doc = R"(Sets the initial state.

Targets that are the initial state of the specification do not change.

Parameters
----------
x : array_like, shape (nx,)
    State.

Raises
------
EvaluationError
    If the state has a NaN or a quaternion that is not normalized; nothing changes.)";

constexpr const char* problem_set_knot_doc =
    R"(Sets the stage and the time of a knot, and evaluates its signals at this time.

Parameters
----------
knot : int
    The terminal knot keeps its stage.
stage : str or int
    Name or index.
time : float
    Time [s].)";

constexpr const char* problem_set_step_doc =
    R"(Sets the length of the step of a knot, independent of its stage.

Times of later knots do not change; set them with set_knot().

Parameters
----------
knot : int
step : float
    Length of the step [s].

Raises
------
Error
    If the knot is an impact or the terminal knot, or the step is not positive.)";

constexpr const char* problem_advance_doc =
    R"(Removes knot 0, shifts the other knots, and appends a knot.

The new knot has the step length of the previous last knot if set_step() has set it.

Parameters
----------
stage : str or int
    Name or index.)";

constexpr const char* problem_set_target_doc = R"(Sets the target of a cost term at a knot.

It applies until the knot is set or advanced.

Parameters
----------
knot : int
term : str or int
    Name or index of the cost term.
target : array_like
    Target; the residual documents its entries.)";

constexpr const char* problem_payload_doc = R"(Sets the payload at a frame for all knots.

The payload replaces that of the body of the frame.

Parameters
----------
frame : str
payload : InertiaSpec
    Inertia of the payload, in the axes of the frame.)";

constexpr const char* problem_torque_doc =
    R"(Sets a constant torque on the joints in addition to the model; zero by default.

Parameters
----------
torque : array_like, shape (nv,)
    Torque [Nm or N].)";

constexpr const char* problem_quasi_static_doc =
    R"(Computes controls of minimum norm, and forces, that hold a state at rest.

Parameters
----------
stage : str or int
    Name or index.
x : array_like, shape (nx,)
    State.
force : array_like, shape (rows,), optional
    Prescribed contact forces; only the controls are then free.

Returns
-------
QuasiStatic)";

constexpr const char* problem_integrate_doc = R"(Returns x (+) dx.

Parameters
----------
x : array_like, shape (nx,) or (n, nx)
    State, or one per row.
dx : array_like, shape (ndx,) or (n, ndx)
    Tangent vector, or one per row.

Returns
-------
ndarray, shape (nx,) or (n, nx))";

constexpr const char* problem_difference_doc = R"(Returns the dx with x0 (+) dx = x1.

Parameters
----------
x0, x1 : array_like, shape (nx,) or (n, nx)
    States, or one per row.

Returns
-------
ndarray, shape (ndx,) or (n, ndx))";

using Vector = Eigen::Ref<const Eigen::VectorXd>;

int stage_index(const Problem& problem, const char* call, const Name& stage) {
  if (const auto* name = std::get_if<std::string>(&stage)) return problem.stage_index(*name);
  const int stages = static_cast<int>(problem.stage_names().size());
  const int index = std::get<int>(stage);
  if (index < 0 || index >= stages)
    throw Error(std::string(call) + ": stage " + std::to_string(index) +
                " does not exist; wanted 0 to " + std::to_string(stages - 1));
  return index;
}

/// Returns a copy of the limits of constraint rows; empty without rows.
Eigen::VectorXd limits_of(const double* limits, int rows) {
  if (rows == 0) return {};
  return Eigen::Map<const Eigen::VectorXd>(limits, rows);
}

int term_index(const Problem& problem, const char* call, int knot, const Name& term) {
  check_knot(call, knot, problem.knots());
  if (const auto* name = std::get_if<std::string>(&term))
    return problem.term_index(problem.stage_of(knot), *name);
  const int terms = problem.terms(knot);
  const int index = std::get<int>(term);
  if (index < 0 || index >= terms)
    throw Error(std::string(call) + ": term " + std::to_string(index) + " does not exist; " +
                problem.knot_name(knot) + " has " + std::to_string(terms) + " terms");
  return index;
}

/// Returns the control `u` of a knot, or zeros for a knot without controls.
Eigen::VectorXd control_at(const Problem& problem, const char* call, int knot, const Vector& x,
                           const std::optional<Eigen::VectorXd>& u) {
  check_knot(call, knot, problem.knots());
  check_size(call, "x", x.size(), problem.layout().nx());
  if (problem.controls(knot) == 0) return Eigen::VectorXd::Zero(problem.max_controls());
  if (!u)
    throw Error(std::string(call) + ": u is missing; wanted " +
                std::to_string(problem.controls(knot)) + " entries");
  check_size(call, "u", u->size(), problem.controls(knot));
  return *u;
}

/// Numbers of entries in one row of each array of by_rows().
struct RowSizes {
  int a, b, result;
};

/// Calls f(a, b, result) for two vectors, or for each pair of rows of two arrays.
template <class Function>
py::array_t<double> by_rows(const char* call, const Numbers& a, const Numbers& b,
                            const RowSizes& sizes, Function&& f) {
  const bool rows = a.ndim() == 2 && b.ndim() == 2 && a.shape(0) == b.shape(0);
  if (!rows && (a.ndim() != 1 || b.ndim() != 1))
    throw Error(
        std::string(call) +
        ": the arrays do not match; wanted two vectors, or two arrays with equal numbers of rows");
  check_size(call, "a row of the first array", a.shape(a.ndim() - 1), sizes.a);
  check_size(call, "a row of the second array", b.shape(b.ndim() - 1), sizes.b);
  const py::ssize_t count = rows ? a.shape(0) : 1;
  py::array_t<double> result(rows ? std::vector<py::ssize_t>{count, sizes.result}
                                  : std::vector<py::ssize_t>{sizes.result});
  for (py::ssize_t i = 0; i < count; ++i)
    f(a.data() + i * sizes.a, b.data() + i * sizes.b, result.mutable_data() + i * sizes.result);
  return result;
}

std::optional<Eigen::VectorXd> bound_at(const char* call, const Problem& problem, int knot,
                                        const double* (Problem::*bound)(int) const) {
  check_knot(call, knot, problem.knots());
  const double* values = (problem.*bound)(knot);
  if (values == nullptr) return std::nullopt;
  return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values, problem.controls(knot)));
}

std::string shown(const ProblemMachine& self) {
  const Problem& problem = self.problem;
  std::string stages;
  for (const std::string& name : problem.stage_names())
    stages += (stages.empty() ? "" : ", ") + name;
  return "<Problem of '" + problem.model().name + "': " + std::to_string(problem.knots()) +
         " knots, nx = " + std::to_string(problem.layout().nx()) +
         ", nu = " + std::to_string(problem.max_controls()) + ", stages " + stages + ">";
}

void bind_what_it_is(ProblemClass& c) {
  c.def(py::init([](const ProblemSpec& spec) { return std::make_unique<ProblemMachine>(spec); }),
        py::arg("spec"), py::call_guard<py::gil_scoped_release>(),
        "Compiles a specification. Raises Error with the stage and the term for an invalid "
        "specification.")
      .def_property_readonly(
          "spec", [](const ProblemMachine& self) { return self.problem.spec(); },
          "Specification, a copy.")
      .def_property_readonly(
          "model", [](const ProblemMachine& self) -> const Model& { return self.problem.model(); },
          py::return_value_policy::reference_internal, "Model of the robot.")
      .def_property_readonly(
          "layout", [](const ProblemMachine& self) { return self.problem.layout(); },
          "StateLayout with the first columns of the parts of z = (du, dq, dv, dtau).")
      .def_property_readonly(
          "knots", [](const ProblemMachine& self) { return self.problem.knots(); },
          "Number N of knots with a step; there are N + 1 states, the last one terminal.")
      .def_property_readonly(
          "nx", [](const ProblemMachine& self) { return self.problem.layout().nx(); },
          "Number of entries of a state x = (q, v), or x = (q, v, tau) with a torque model.")
      .def_property_readonly(
          "ndx", [](const ProblemMachine& self) { return self.problem.layout().ndx(); },
          "Number of entries of a tangent vector dx of a state.")
      .def_property_readonly(
          "max_controls", [](const ProblemMachine& self) { return self.problem.max_controls(); },
          "Number of columns of us. A knot has this number of controls, or none.")
      .def_property_readonly(
          "stage_names", [](const ProblemMachine& self) { return self.problem.stage_names(); },
          "Names of the stages, the last one 'terminal'.")
      .def_property_readonly(
          "state_names", [](const ProblemMachine& self) { return self.problem.state_names(); },
          "Names of the entries of dx.")
      .def_property_readonly(
          "control_names", [](const ProblemMachine& self) { return self.problem.control_names(); },
          "Names of the controls.")
      .def_property_readonly(
          "input_names", [](const ProblemMachine& self) { return self.problem.input_names(); },
          "Names of the inputs, in the order of ProblemSpec.inputs.")
      .def(
          "stage_index",
          [](const ProblemMachine& self, const std::string& name) {
            return self.problem.stage_index(name);
          },
          py::arg("name"),
          "Returns the index of a stage. Raises Error with the nearest name for an unknown stage.")
      .def(
          "term_index",
          [](const ProblemMachine& self, const Name& stage, const std::string& name) {
            return self.problem.term_index(stage_index(self.problem, "Problem.term_index", stage),
                                           name);
          },
          py::arg("stage"), py::arg("name"),
          "Returns the index of a cost term in a stage. Raises Error with the nearest name for an "
          "unknown term.")
      .def("__repr__", &shown);
}

/// Binds a function that returns get(problem, knot).
template <class Get>
void of_knot(ProblemClass& c, const char* name, Get get, const char* text) {
  c.def(
      name,
      [get, call = std::string("Problem.") + name](const ProblemMachine& self, int knot) {
        check_knot(call.c_str(), knot, self.problem.knots());
        return get(self.problem, knot);
      },
      py::arg("knot"), text);
}

void bind_knots(ProblemClass& c) {
  of_knot(
      c, "stage_of", [](const Problem& p, int k) { return p.stage_of(k); },
      "Returns the index of the stage of a knot.");
  of_knot(
      c, "time_of", [](const Problem& p, int k) { return p.time_of(k); },
      "Returns the time of a knot [s].");
  of_knot(
      c, "step_of", [](const Problem& p, int k) { return p.step_of(k); },
      "Returns the length of the step of a knot [s]; 0 for impacts and the terminal knot.");
  of_knot(
      c, "controls", [](const Problem& p, int k) { return p.controls(k); },
      "Returns the number of controls of a knot; 0 for impacts and the terminal knot.");
  of_knot(
      c, "term_names", [](const Problem& p, int k) { return p.term_names(k); },
      "Returns the names of the cost terms of a knot.");
  of_knot(
      c, "row_names", [](const Problem& p, int k) { return p.row_names(k); },
      "Returns the names of the constraint rows of a knot, such as 'force/z'.");
  of_knot(
      c, "row_lower", [](const Problem& p, int k) { return limits_of(p.row_lower(k), p.rows(k)); },
      "Returns the lower limits of the constraint rows of a knot, shape (rows,); infinite without "
      "a limit.");
  of_knot(
      c, "row_upper", [](const Problem& p, int k) { return limits_of(p.row_upper(k), p.rows(k)); },
      "Returns the upper limits of the constraint rows of a knot, shape (rows,); infinite without "
      "a limit.");
  of_knot(
      c, "force_names", [](const Problem& p, int k) { return p.force_names(k); },
      "Returns the names of the entries of forces(), such as 'tool/z'.");
  of_knot(
      c, "knot_name", [](const Problem& p, int k) { return p.knot_name(k); },
      "Returns a text such as 'press, knot 12'.");
  of_knot(
      c, "control_lower",
      [](const Problem& p, int k) {
        return bound_at("Problem.control_lower", p, k, &Problem::control_lower);
      },
      "Bounds of the controls of a knot, (nu,), Nm (N), or None.");
  of_knot(
      c, "control_upper",
      [](const Problem& p, int k) {
        return bound_at("Problem.control_upper", p, k, &Problem::control_upper);
      },
      "Bounds of the controls of a knot, (nu,), Nm (N), or None.");
}

std::vector<std::string> contact_names(const Problem& problem) {
  std::vector<std::string> names;
  for (const ContactSpec& of : problem.spec().contacts)
    names.push_back(of.name.empty() ? of.tool : of.name);
  return names;
}

void bind_contacts_of_knots(ProblemClass& c) {
  c.def(
      "set_surface",
      [](ProblemMachine& self, int knot, const Name& contact, const Quadric& surface) {
        constexpr const char* call = "Problem.set_surface";
        const Busy::Lock lock(self.busy, call);
        surface.check(call);
        const int number = contact_number(call, contact, contact_names(self.problem));
        require(self.problem.set_surface(knot, number, surface), call);
      },
      py::arg("knot"), py::arg("contact"), py::arg("surface"), problem_surface_doc);
  c.def(
      "set_term_surface",
      [](ProblemMachine& self, int knot, const Name& term, const Quadric& surface) {
        constexpr const char* call = "Problem.set_term_surface";
        const Busy::Lock lock(self.busy, call);
        surface.check(call);
        require(self.problem.set_term_surface(knot, term_index(self.problem, call, knot, term),
                                              surface),
                call);
      },
      py::arg("knot"), py::arg("term"), py::arg("surface"), problem_term_surface_doc);
  c.def(
      "set_friction",
      [](ProblemMachine& self, int knot, const Name& contact, double coefficient) {
        constexpr const char* call = "Problem.set_friction";
        const Busy::Lock lock(self.busy, call);
        const int number = contact_number(call, contact, contact_names(self.problem));
        require(self.problem.set_friction(knot, number, coefficient), call);
      },
      py::arg("knot"), py::arg("contact"), py::arg("coefficient"), problem_friction_doc);
}

void bind_setters(ProblemClass& c) {
  c.def_property_readonly(
       "initial_state",
       [](const ProblemMachine& self) {
         return copied(VectorView(self.problem.initial_state(), self.problem.layout().nx()));
       },
       "Initial state, shape (nx,), a copy.")
      .def(
          "set_initial_state",
          [](ProblemMachine& self, const Vector& x) {
            constexpr const char* call = "Problem.set_initial_state";
            const Busy::Lock lock(self.busy, call);
            check_size(call, "x", x.size(), self.problem.layout().nx());
            require(self.problem.set_initial_state(x), call);
          },
          py::arg("x"), problem_initial_state_doc)
      .def(
          "set_knot",
          [](ProblemMachine& self, int knot, const Name& stage, double time) {
            const Busy::Lock lock(self.busy, "Problem.set_knot");
            self.problem.set_knot(knot, stage_index(self.problem, "Problem.set_knot", stage), time);
          },
          py::arg("knot"), py::arg("stage"), py::arg("time"), problem_set_knot_doc)
      .def(
          "set_step",
          [](ProblemMachine& self, int knot, double step) {
            const Busy::Lock lock(self.busy, "Problem.set_step");
            self.problem.set_step(knot, step);
          },
          py::arg("knot"), py::arg("step"), problem_set_step_doc)
      .def(
          "advance",
          [](ProblemMachine& self, const Name& stage) {
            const Busy::Lock lock(self.busy, "Problem.advance");
            self.problem.advance(stage_index(self.problem, "Problem.advance", stage));
          },
          py::arg("stage"), problem_advance_doc)
      .def(
          "set_target",
          [](ProblemMachine& self, int knot, const Name& term, const Vector& target) {
            constexpr const char* call = "Problem.set_target";
            const Busy::Lock lock(self.busy, call);
            require(
                self.problem.set_target(knot, term_index(self.problem, call, knot, term), target),
                call);
          },
          py::arg("knot"), py::arg("term"), py::arg("target"), problem_set_target_doc);
}

/// Binds payloads and additional joint torques.
void bind_loads(ProblemClass& c) {
  c.def(
       "set_payload",
       [](ProblemMachine& self, const std::string& frame, const InertiaSpec& payload) {
         constexpr const char* call = "Problem.set_payload";
         const Busy::Lock lock(self.busy, call);
         check_payload(call, payload);
         require(self.problem.set_payload(frame, payload), call);
       },
       py::arg("frame"), py::arg("payload"), problem_payload_doc)
      .def(
          "set_torque_bias",
          [](ProblemMachine& self, const Vector& torque) {
            constexpr const char* call = "Problem.set_torque_bias";
            const Busy::Lock lock(self.busy, call);
            check_size(call, "torque", torque.size(), self.problem.layout().nv);
            require(self.problem.set_torque_bias(torque), call);
          },
          py::arg("torque"), problem_torque_doc);
}

/// Binds an evaluation of one knot at (x, u).
template <class Get>
void at_knot(ProblemClass& c, const char* name, Get get, const char* text) {
  c.def(
      name,
      [get, call = std::string("Problem.") + name](ProblemMachine& self, int knot, const Vector& x,
                                                   const std::optional<Eigen::VectorXd>& u) {
        const Busy::Lock lock(self.busy, call.c_str());
        const Eigen::VectorXd control = control_at(self.problem, call.c_str(), knot, x, u);
        const py::gil_scoped_release release;
        return get(self.problem, knot, x, control);
      },
      py::arg("knot"), py::arg("x"), py::arg("u") = py::none(), text);
}
template <class Get>
void at_term(ProblemClass& c, const char* name, Get get, const char* text) {
  c.def(
      name,
      [get, call = std::string("Problem.") + name](ProblemMachine& self, int knot, const Name& term,
                                                   const Vector& x,
                                                   const std::optional<Eigen::VectorXd>& u) {
        const Busy::Lock lock(self.busy, call.c_str());
        const Eigen::VectorXd control = control_at(self.problem, call.c_str(), knot, x, u);
        const int index = term_index(self.problem, call.c_str(), knot, term);
        const py::gil_scoped_release release;
        return get(self.problem, knot, index, x, control);
      },
      py::arg("knot"), py::arg("term"), py::arg("x"), py::arg("u") = py::none(), text);
}

void bind_terms(ProblemClass& c) {
  at_term(
      c, "residual",
      [](Problem& p, int knot, int term, const Vector& x, const Eigen::VectorXd& u) {
        return p.residual(knot, term, x, u);
      },
      "Returns the residual r (rows,) of a cost term (index or name) of a knot at x (nx,) and u "
      "(nu,).");
  at_term(
      c, "residual_derivative",
      [](Problem& p, int knot, int term, const Vector& x, const Eigen::VectorXd& u) {
        return p.residual_derivative(knot, term, x, u);
      },
      "Returns dr/dz (rows, nz) of a cost term of a knot, with z = (u, dq, dv, dtau).");
}

void bind_values_at_knots(ProblemClass& c) {
  at_knot(
      c, "forces",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.forces(knot, x, u);
      },
      "Returns the contact forces of a knot, rows of the contacts of its stage [N, Nm]; empty if "
      "the knot has none.");
  at_knot(
      c, "acceleration",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.acceleration(knot, x, u);
      },
      "Returns the joint accelerations of a knot, shape (nv,) [rad/s^2 or m/s^2]; empty for "
      "impacts and the terminal knot.");
  at_knot(
      c, "term_costs",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.term_costs(knot, x.data(), u.data());
      },
      "Returns the costs of the terms of a knot, in the order of term_names().");
  at_knot(
      c, "row_values",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.row_values(knot, x.data(), u.data());
      },
      "Returns the values of the constraint rows of a knot, in the order of row_names().");
  at_knot(
      c, "roll",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        Eigen::VectorXd next(p.layout().nx());
        const KnotValue value = p.roll(0, knot, x.data(), u.data(), next.data());
        require(value.status, "Problem.roll");
        return std::pair(knot < p.knots() ? std::optional(next) : std::nullopt, value.cost);
      },
      "Returns the next state (nx,), None for the terminal knot, and the cost of a knot. Raises "
      "EvaluationError if the knot cannot be evaluated.");
}

void bind_statics(ProblemClass& c) {
  c.def(
       "quasi_static",
       [](ProblemMachine& self, const Name& stage, const Vector& x,
          const std::optional<Eigen::VectorXd>& force) {
         constexpr const char* call = "Problem.quasi_static";
         const Busy::Lock lock(self.busy, call);
         const int index = stage_index(self.problem, call, stage);
         const py::gil_scoped_release release;
         return self.problem.quasi_static(index, x, force.value_or(Eigen::VectorXd()));
       },
       py::arg("stage"), py::arg("x"), py::arg("force") = py::none(), problem_quasi_static_doc)
      .def(
          "prepare",
          [](ProblemMachine& self, int workers) {
            const Busy::Lock lock(self.busy, "Problem.prepare");
            self.problem.prepare(workers);
          },
          py::arg("workers"),
          "Allocates memory for a number of threads, before the first call with this number.");
}

void bind_arithmetic(ProblemClass& c) {
  c.def(
       "integrate",
       [](const ProblemMachine& self, const Numbers& x, const Numbers& dx) {
         const StateLayout& l = self.problem.layout();
         return by_rows("Problem.integrate", x, dx, {.a = l.nx(), .b = l.ndx(), .result = l.nx()},
                        [&](const double* a, const double* b, double* out) {
                          self.problem.integrate(a, b, out);
                        });
       },
       py::arg("x"), py::arg("dx"), problem_integrate_doc)
      .def(
          "difference",
          [](const ProblemMachine& self, const Numbers& x0, const Numbers& x1) {
            const StateLayout& l = self.problem.layout();
            return by_rows("Problem.difference", x0, x1,
                           {.a = l.nx(), .b = l.nx(), .result = l.ndx()},
                           [&](const double* a, const double* b, double* out) {
                             self.problem.difference(a, b, out);
                           });
          },
          py::arg("x0"), py::arg("x1"), problem_difference_doc);
}

}  // namespace

void bind_problem(py::module_& m) {
  ProblemClass problem(m, "Problem",
                       "Compiled optimal control problem of a robot in contact, for a solver. "
                       "Only one thread may use it at a time.");
  bind_what_it_is(problem);
  bind_knots(problem);
  bind_setters(problem);
  bind_loads(problem);
  bind_inputs(problem);
  bind_contacts_of_knots(problem);
  bind_terms(problem);
  bind_values_at_knots(problem);
  bind_statics(problem);
  bind_arithmetic(problem);
  bind_trajectory(problem);
}

}  // namespace burnish::python

// Problem: what it is, its knots, targets and states, evaluations of one knot.
#include "bind_derivatives.hpp"
#include "bind_ocp.hpp"
#include "specs_model.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

using Vector = Eigen::Ref<const Eigen::VectorXd>;
using Name = std::variant<int, std::string>;

void check_size(const char* call, const char* argument, Eigen::Index came, int wanted_size) {
  if (came != wanted_size)
    throw Error(std::string(call) + ": " + argument + " has " + std::to_string(came) +
                " entries; wanted " + std::to_string(wanted_size));
}

int stage_index(const Problem& problem, const char* call, const Name& stage) {
  if (const auto* name = std::get_if<std::string>(&stage)) return problem.stage_index(*name);
  const int stages = static_cast<int>(problem.stage_names().size());
  const int index = std::get<int>(stage);
  if (index < 0 || index >= stages)
    throw Error(std::string(call) + ": stage " + std::to_string(index) + "; wanted 0 to " +
                std::to_string(stages - 1));
  return index;
}

/// Empty where there are no rows, which have no limits to read.
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
    throw Error(std::string(call) + ": term " + std::to_string(index) + "; " +
                problem.knot_name(knot) + " has " + std::to_string(terms));
  return index;
}

/// The control of a knot: what came, or none where the knot has none.
Eigen::VectorXd control_at(const Problem& problem, const char* call, int knot, const Vector& x,
                           const std::optional<Eigen::VectorXd>& u) {
  check_knot(call, knot, problem.knots());
  check_size(call, "x", x.size(), problem.layout().nx());
  if (problem.controls(knot) == 0) return Eigen::VectorXd::Zero(problem.max_controls());
  if (!u)
    throw Error(std::string(call) + ": u is missing; wanted are " +
                std::to_string(problem.controls(knot)) + " entries");
  check_size(call, "u", u->size(), problem.controls(knot));
  return *u;
}

/// f(row of a, row of b, row of the result) for one state or for rows of states.
template <class Function>
py::array_t<double> by_rows(const char* call, const Numbers& a, int a_size, const Numbers& b,
                            int b_size, int size, Function&& f) {
  const bool rows = a.ndim() == 2 && b.ndim() == 2 && a.shape(0) == b.shape(0);
  if (!rows && (a.ndim() != 1 || b.ndim() != 1))
    throw Error(std::string(call) +
                ": wanted are two vectors, or two arrays with the same number of rows");
  check_size(call, "a row of the first", a.shape(a.ndim() - 1), a_size);
  check_size(call, "a row of the second", b.shape(b.ndim() - 1), b_size);
  const py::ssize_t count = rows ? a.shape(0) : 1;
  py::array_t<double> result(rows ? std::vector<py::ssize_t>{count, size}
                                  : std::vector<py::ssize_t>{size});
  for (py::ssize_t i = 0; i < count; ++i)
    f(a.data() + i * a_size, b.data() + i * b_size, result.mutable_data() + i * size);
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
        "Compiles the specification. Raises Error with one sentence that names the stage and the "
        "term.")
      .def_property_readonly(
          "spec", [](const ProblemMachine& self) { return self.problem.spec(); },
          "What it was made from, a copy.")
      .def_property_readonly(
          "model", [](const ProblemMachine& self) -> const Model& { return self.problem.model(); },
          py::return_value_policy::reference_internal, "The robot.")
      .def_property_readonly(
          "layout", [](const ProblemMachine& self) { return self.problem.layout(); },
          "Where the parts of z = (du, dq, dv, dtau) start: a StateLayout.")
      .def_property_readonly(
          "knots", [](const ProblemMachine& self) { return self.problem.knots(); },
          "N; there are N + 1 states, the last one terminal.")
      .def_property_readonly(
          "nx", [](const ProblemMachine& self) { return self.problem.layout().nx(); },
          "Entries of a state x = (q, v), or (q, v, tau) with a torque model.")
      .def_property_readonly(
          "ndx", [](const ProblemMachine& self) { return self.problem.layout().ndx(); },
          "Entries of a tangent dx of a state.")
      .def_property_readonly(
          "max_controls", [](const ProblemMachine& self) { return self.problem.max_controls(); },
          "Columns of us; knots have this many controls, or none.")
      .def_property_readonly(
          "stage_names", [](const ProblemMachine& self) { return self.problem.stage_names(); },
          "Names of the stages, the last one 'terminal'.")
      .def_property_readonly(
          "state_names", [](const ProblemMachine& self) { return self.problem.state_names(); },
          "Names of the entries of dx.")
      .def_property_readonly(
          "control_names", [](const ProblemMachine& self) { return self.problem.control_names(); },
          "Names of the controls.")
      .def(
          "stage_index",
          [](const ProblemMachine& self, const std::string& name) {
            return self.problem.stage_index(name);
          },
          py::arg("name"), "Index of a stage. Raises Error with the nearest known name.")
      .def(
          "term_index",
          [](const ProblemMachine& self, const Name& stage, const std::string& name) {
            return self.problem.term_index(stage_index(self.problem, "Problem.term_index", stage),
                                           name);
          },
          py::arg("stage"), py::arg("name"),
          "Index of a cost term in a stage. Raises Error with the nearest known name.")
      .def("__repr__", &shown);
}

/// A property of each knot.
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
      "Index of the stage of a knot.");
  of_knot(
      c, "time_of", [](const Problem& p, int k) { return p.time_of(k); }, "Of a knot, s.");
  of_knot(
      c, "step_of", [](const Problem& p, int k) { return p.step_of(k); },
      "Of a knot, s; 0 at impacts and at the end.");
  of_knot(
      c, "controls", [](const Problem& p, int k) { return p.controls(k); },
      "Controls of a knot; 0 at impacts and at the end.");
  of_knot(
      c, "term_names", [](const Problem& p, int k) { return p.term_names(k); },
      "Names of the cost terms of a knot.");
  of_knot(
      c, "row_names", [](const Problem& p, int k) { return p.row_names(k); },
      "Names of the rows of a knot's constraints, such as 'force/z'.");
  of_knot(
      c, "row_lower", [](const Problem& p, int k) { return limits_of(p.row_lower(k), p.rows(k)); },
      "Lower limits of the rows of a knot, (rows,); infinite where there is none.");
  of_knot(
      c, "row_upper", [](const Problem& p, int k) { return limits_of(p.row_upper(k), p.rows(k)); },
      "Upper limits likewise.");
  of_knot(
      c, "force_names", [](const Problem& p, int k) { return p.force_names(k); },
      "Names of the entries of forces(), such as 'tool/z'.");
  of_knot(
      c, "knot_name", [](const Problem& p, int k) { return p.knot_name(k); },
      "Such as 'press, knot 12'.");
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
        const int number = contact_number(call, contact, contact_names(self.problem));
        require(self.problem.set_surface(knot, number, surface), call);
      },
      py::arg("knot"), py::arg("contact"), py::arg("surface"),
      "Gives a knot another Quadric, in the axes of the base, in the place of the one that the "
      "reference of a contact (index or name) follows (Reference.on), until the knot is set or "
      "advanced again; a stage that does not hold the contact passes it over.");
  c.def(
      "set_term_surface",
      [](ProblemMachine& self, int knot, const Name& term, const Quadric& surface) {
        constexpr const char* call = "Problem.set_term_surface";
        const Busy::Lock lock(self.busy, call);
        require(self.problem.set_term_surface(knot, term_index(self.problem, call, knot, term),
                                              surface),
                call);
      },
      py::arg("knot"), py::arg("term"), py::arg("surface"),
      "The same of the surface that the reference of one term (index or name) follows.");
  c.def(
      "set_friction",
      [](ProblemMachine& self, int knot, const Name& contact, double coefficient) {
        constexpr const char* call = "Problem.set_friction";
        const Busy::Lock lock(self.busy, call);
        const int number = contact_number(call, contact, contact_names(self.problem));
        require(self.problem.set_friction(knot, number, coefficient), call);
      },
      py::arg("knot"), py::arg("contact"), py::arg("coefficient"),
      "Gives a knot another coefficient of the friction of a contact (index or name), likewise.");
}

void bind_setters(ProblemClass& c) {
  c.def_property_readonly(
       "initial_state",
       [](const ProblemMachine& self) {
         return copied(VectorView(self.problem.initial_state(), self.problem.layout().nx()));
       },
       "(nx,), a copy.")
      .def(
          "set_initial_state",
          [](ProblemMachine& self, const Vector& x) {
            constexpr const char* call = "Problem.set_initial_state";
            const Busy::Lock lock(self.busy, call);
            check_size(call, "x", x.size(), self.problem.layout().nx());
            require(self.problem.set_initial_state(x), call);
          },
          py::arg("x"),
          "x: (nx,). Raises EvaluationError for a NaN or a quaternion that is not of unit length; "
          "nothing is changed then. Targets that are the specification's initial state stay that.")
      .def(
          "set_knot",
          [](ProblemMachine& self, int knot, const Name& stage, double time) {
            const Busy::Lock lock(self.busy, "Problem.set_knot");
            self.problem.set_knot(knot, stage_index(self.problem, "Problem.set_knot", stage), time);
          },
          py::arg("knot"), py::arg("stage"), py::arg("time"),
          "Gives a knot another stage (index or name) and time (s); signals are asked for their "
          "values there. The terminal knot keeps its stage.")
      .def(
          "set_step",
          [](ProblemMachine& self, int knot, double step) {
            const Busy::Lock lock(self.busy, "Problem.set_step");
            self.problem.set_step(knot, step);
          },
          py::arg("knot"), py::arg("step"),
          "Gives a knot a step of its own (s), whatever its stage, from then on. Times stay: "
          "set_knot() gives them to the knots that are now earlier or later. Raises Error for a "
          "knot where no time passes, and for a step that is not positive.")
      .def(
          "advance",
          [](ProblemMachine& self, const Name& stage) {
            const Busy::Lock lock(self.busy, "Problem.advance");
            self.problem.advance(stage_index(self.problem, "Problem.advance", stage));
          },
          py::arg("stage"),
          "Drops knot 0, moves the others one forward and appends one of this stage (index or "
          "name) "
          "at the time after the last one, as long as that was if it has a step of its own; the "
          "terminal knot follows.")
      .def(
          "set_target",
          [](ProblemMachine& self, int knot, const Name& term, const Vector& target) {
            constexpr const char* call = "Problem.set_target";
            const Busy::Lock lock(self.busy, call);
            require(
                self.problem.set_target(knot, term_index(self.problem, call, knot, term), target),
                call);
          },
          py::arg("knot"), py::arg("term"), py::arg("target"),
          "Writes the target of one term (index or name) at one knot until the knot is set or "
          "advanced again: entries as the residual says.");
}

/// What the robot carries, and what it does not know of its joints.
void bind_loads(ProblemClass& c) {
  c.def(
       "set_payload",
       [](ProblemMachine& self, const std::string& frame, const InertiaSpec& payload) {
         constexpr const char* call = "Problem.set_payload";
         const Busy::Lock lock(self.busy, call);
         check_payload(call, payload);
         require(self.problem.set_payload(frame, payload), call);
       },
       py::arg("frame"), py::arg("payload"),
       "What the robot carries at a frame from now on, at all knots: an InertiaSpec in the "
       "frame's axes, in the place of what that frame's body carried before.")
      .def(
          "set_torque_bias",
          [](ProblemMachine& self, const Vector& torque) {
            constexpr const char* call = "Problem.set_torque_bias";
            const Busy::Lock lock(self.busy, call);
            check_size(call, "torque", torque.size(), self.problem.layout().nv);
            require(self.problem.set_torque_bias(torque), call);
          },
          py::arg("torque"),
          "(nv,), Nm (N): a constant torque on the joints that the model does not know of, zero at "
          "first.");
}

/// Something of one knot at (x, u).
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
      "r (rows,) of one term (index or name) of a knot at x (nx,), u (nu,).");
  at_term(
      c, "residual_derivative",
      [](Problem& p, int knot, int term, const Vector& x, const Eigen::VectorXd& u) {
        return p.residual_derivative(knot, term, x, u);
      },
      "dr/dz (rows, nz) of one term of a knot, z = (u, dq, dv, dtau).");
}

void bind_values_at_knots(ProblemClass& c) {
  at_knot(
      c, "forces",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.forces(knot, x, u);
      },
      "Contact forces of a knot: rows of its stage's contacts, N and Nm; empty where nothing "
      "solves for them.");
  at_knot(
      c, "acceleration",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.acceleration(knot, x, u);
      },
      "(nv,), rad/s^2 (m/s^2); empty where nothing solves for it.");
  at_knot(
      c, "term_costs",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.term_costs(knot, x.data(), u.data());
      },
      "Cost of each term of a knot, in the order of term_names.");
  at_knot(
      c, "row_values",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        return p.row_values(knot, x.data(), u.data());
      },
      "Value of each row of a knot's constraints, in the order of row_names.");
  at_knot(
      c, "roll",
      [](Problem& p, int knot, const Vector& x, const Eigen::VectorXd& u) {
        Eigen::VectorXd next(p.layout().nx());
        const KnotValue value = p.roll(0, knot, x.data(), u.data(), next.data());
        require(value.status, "Problem.roll");
        return std::pair(knot < p.knots() ? std::optional(next) : std::nullopt, value.cost);
      },
      "The next state (nx,), None at the end, and the cost of a knot. Raises EvaluationError where "
      "it cannot be evaluated.");
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
       py::arg("stage"), py::arg("x"), py::arg("force") = py::none(),
       "The control of least norm that with the contacts of a stage (index or name) holds x (nx,) "
       "at rest, with the forces: a QuasiStatic. `force` (rows of the contacts), when given, "
       "prescribes them, and only the control is free.")
      .def(
          "prepare",
          [](ProblemMachine& self, int workers) {
            const Busy::Lock lock(self.busy, "Problem.prepare");
            self.problem.prepare(workers);
          },
          py::arg("workers"),
          "Makes room for this many threads, before the first call that has them.");
}

void bind_arithmetic(ProblemClass& c) {
  c.def(
       "integrate",
       [](const ProblemMachine& self, const Numbers& x, const Numbers& dx) {
         const StateLayout& l = self.problem.layout();
         return by_rows("Problem.integrate", x, l.nx(), dx, l.ndx(), l.nx(),
                        [&](const double* a, const double* b, double* out) {
                          self.problem.integrate(a, b, out);
                        });
       },
       py::arg("x"), py::arg("dx"), "x (+) dx: (nx,) and (ndx,), or rows of them.")
      .def(
          "difference",
          [](const ProblemMachine& self, const Numbers& x0, const Numbers& x1) {
            const StateLayout& l = self.problem.layout();
            return by_rows("Problem.difference", x0, l.nx(), x1, l.nx(), l.ndx(),
                           [&](const double* a, const double* b, double* out) {
                             self.problem.difference(a, b, out);
                           });
          },
          py::arg("x0"), py::arg("x1"), "The dx with x0 (+) dx = x1: (ndx,), or rows of them.");
}

}  // namespace

void bind_problem(py::module_& m) {
  ProblemClass problem(m, "Problem",
                       "An optimal control problem of a robot in contact, compiled: what a solver "
                       "solves. One thread "
                       "at a time.");
  bind_what_it_is(problem);
  bind_knots(problem);
  bind_setters(problem);
  bind_loads(problem);
  bind_contacts_of_knots(problem);
  bind_terms(problem);
  bind_values_at_knots(problem);
  bind_statics(problem);
  bind_arithmetic(problem);
  bind_trajectory(problem);
}

}  // namespace burnish::python

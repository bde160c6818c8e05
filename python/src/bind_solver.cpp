// Bindings of the DDP solver.
#include "arrays.hpp"
#include "bind.hpp"
#include "machine_solver.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* solver_init_doc = R"(Makes a solver for a problem.

The initial guess is the initial state at all knots, and zero controls.

Parameters
----------
problem : Problem
options : DdpOptions, optional

Raises
------
Error
    If an option is out of range.)";

constexpr const char* solver_options_doc = R"(Sets the options.

Parameters
----------
options : DdpOptions

Raises
------
Error
    If an option is out of range; nothing changes.)";

constexpr const char* solver_guess_doc =
    R"(Sets the start of the next solve. By default, a solve starts where the previous one ended.

Parameters
----------
xs : array_like, shape (N + 1, nx)
    States.
us : array_like, shape (N, max_controls)
    Controls.)";

constexpr const char* solver_time_budget_doc = R"(Sets the time limit of a solve.

Parameters
----------
seconds : float
    Time limit [s]; a NaN or a negative number means 0.)";

constexpr const char* solver_iterations_doc = R"(Sets the largest number of iterations.

Parameters
----------
iterations : int
    At most the number of the options.)";

constexpr const char* solver_limit_budget_doc =
    R"(Sets LimitOptions.max_factorizations and max_sweeps.

Parameters
----------
max_factorizations : int
    At least 1.
max_sweeps : int
    At least 0.)";

/// Locks the solver and its problem, which the solver reads.
class BothLocked {
 public:
  BothLocked(SolverMachine& self, const char* call)
      : solver_(self.busy, call), problem_(self.problem.busy, call) {}

 private:
  Busy::Lock solver_, problem_;
};

using SolverClass = py::class_<SolverMachine>;

void bind_setting_up(SolverClass& c) {
  c.def(py::init([](ProblemMachine& problem, const std::optional<DdpOptions>& options) {
          const Busy::Lock lock(problem.busy, "DdpSolver");
          return std::make_unique<SolverMachine>(problem, options.value_or(DdpOptions{}));
        }),
        py::arg("problem"), py::arg("options") = py::none(), py::keep_alive<1, 2>(),
        solver_init_doc)
      .def_property_readonly(
          "options",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.options");
            DdpOptions options = self.solver.options();
            options.callback = self.callback;
            return options;
          },
          "Options of the solver, a copy.")
      .def(
          "set_options",
          [](SolverMachine& self, const DdpOptions& options) {
            const BothLocked lock(self, "DdpSolver.set_options");
            self.solver.set_options(self.watched(options));
            self.callback = options.callback;
          },
          py::arg("options"), solver_options_doc)
      .def(
          "set_guess",
          [](SolverMachine& self, const Eigen::Ref<const RowMatrix>& xs,
             const Eigen::Ref<const RowMatrix>& us) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_guess");
            self.solver.set_guess(xs, us);
          },
          py::arg("xs"), py::arg("us"), solver_guess_doc);
}

/// Binds the functions that set time and iteration limits of a solve, and its initial multipliers.
void bind_budgets(SolverClass& c) {
  c.def(
       "set_time_budget",
       [](SolverMachine& self, double seconds) {
         const Busy::Lock lock(self.busy, "DdpSolver.set_time_budget");
         self.solver.set_time_budget(seconds);
       },
       py::arg("seconds"), solver_time_budget_doc)
      .def(
          "set_max_iterations",
          [](SolverMachine& self, int iterations) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_max_iterations");
            self.solver.set_max_iterations(iterations);
          },
          py::arg("iterations"), solver_iterations_doc)
      .def(
          "set_limit_budget",
          [](SolverMachine& self, int max_factorizations, int max_sweeps) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_limit_budget");
            self.solver.set_limit_budget(max_factorizations, max_sweeps);
          },
          py::arg("max_factorizations"), py::arg("max_sweeps"), solver_limit_budget_doc)
      .def(
          "forget_limits",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.forget_limits");
            self.solver.forget_limits();
          },
          "Deletes the multipliers, so that the next solve starts as with a new solver.")
      .def(
          "shift_limits",
          [](SolverMachine& self, int knots) {
            const Busy::Lock lock(self.busy, "DdpSolver.shift_limits");
            self.solver.shift_limits(knots);
          },
          py::arg("knots"),
          "Shifts the multipliers of the last solve by a number of knots, as for a horizon that "
          "has moved by this number.")
      .def(
          "shift_limits",
          [](SolverMachine& self, const std::vector<int>& sources) {
            const Busy::Lock lock(self.busy, "DdpSolver.shift_limits");
            self.solver.shift_limits(sources);
          },
          py::arg("sources"),
          "Shifts the multipliers of the last solve for knots of different lengths: knot k gets "
          "those of knot sources[k]. Entries must not decrease, and sources[k] must be at least "
          "k.");
}

void bind_solving(SolverClass& c) {
  c.def(
       "solve",
       [](SolverMachine& self) {
         const BothLocked lock(self, "DdpSolver.solve");
         self.watch.begin();
         const py::gil_scoped_release release;
         return self.solver.solve();
       },
       "Solves the problem, and returns a DdpSummary. Other Python threads can run meanwhile. "
       "Ctrl-C interrupts the solve between two iterations. Exceptions of callbacks and residuals "
       "are raised here; the trajectory is then the last one that was evaluated.")
      .def_property_readonly(
          "summary",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.summary");
            return self.solver.summary();
          },
          "DdpSummary of the last solve.")
      .def(
          "text",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.text");
            return self.solver.text();
          },
          "Returns a sentence with the reason why the last solve stopped, with the names of the "
          "problem.")
      .def(
          "cost_report",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.cost_report");
            const py::gil_scoped_release release;
            return self.solver.cost_report();
          },
          "Returns a CostReport: costs of the present trajectory by term and by knot.")
      .def(
          "optimality_error",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.optimality_error");
            const py::gil_scoped_release release;
            return self.solver.optimality_error();
          },
          "Returns the largest entry of the gradient of the Lagrangian with respect to the "
          "controls at the present trajectory [cost per unit of control]. Entries that an active "
          "bound cancels do not count. Infinite if a knot cannot be evaluated.");
}

/// Binds a result of the last solve.
template <class Get>
void of_solve(SolverClass& c, const char* name, Get get, const char* text) {
  c.def_property_readonly(
      name,
      [get, call = std::string("DdpSolver.") + name](SolverMachine& self) {
        const Busy::Lock lock(self.busy, call.c_str());
        return get(self.solver);
      },
      text);
}
/// Binds a function that returns a result of the last solve at a knot. `after`: 1 if the terminal
/// knot has such a result too, else 0.
template <class Get>
void of_knot(SolverClass& c, const char* name, int after, Get get, const char* text) {
  c.def(
      name,
      [get, after, call = std::string("DdpSolver.") + name](SolverMachine& self, int knot) {
        const Busy::Lock lock(self.busy, call.c_str());
        check_knot(call.c_str(), knot, self.problem.problem.knots() - 1 + after);
        return get(self.solver, knot);
      },
      py::arg("knot"), text);
}

void bind_results(SolverClass& c) {
  of_solve(
      c, "xs", [](const DdpSolver& s) { return copied(s.xs()); },
      "States of the trajectory, shape (N + 1, nx), a copy.");
  of_solve(
      c, "us", [](const DdpSolver& s) { return copied(s.us()); },
      "Controls of the trajectory, shape (N, max_controls), a copy. Entries beyond the number of "
      "controls of a knot are meaningless.");
  of_knot(
      c, "feedforward", 0, [](const DdpSolver& s, int k) { return copied(s.feedforward(k)); },
      "Returns the feedforward (nu,) of the policy u = u_k + feedforward + gain (x (-) x_k) about "
      "the last expanded iterate; zero after convergence.");
  of_knot(
      c, "gain", 0, [](const DdpSolver& s, int k) { return RowMatrix(s.gain(k)); },
      "Returns the gain (nu, ndx) of the policy (see feedforward()).");
  of_knot(
      c, "multipliers", 1, [](const DdpSolver& s, int k) { return copied(s.multipliers(k)); },
      "Returns the multipliers (rows,) of the constraint rows of a knot, 0 to N: decrease of the "
      "cost per unit by which the limit is relaxed. Positive for an active upper limit.");
  of_knot(
      c, "value_gradient", 1, [](const DdpSolver& s, int k) { return copied(s.value_gradient(k)); },
      "Returns the gradient (ndx,) of the value function at a knot, 0 to N, about the last "
      "expanded iterate.");
  of_knot(
      c, "value_hessian", 1,
      [](const DdpSolver& s, int k) { return RowMatrix(s.value_hessian(k)); },
      "Returns the Hessian (ndx, ndx) of the value function at a knot, 0 to N, about the last "
      "expanded iterate.");
  of_knot(
      c, "named_gain", 0, [](const DdpSolver& s, int k) { return s.named_gain(k); },
      "Returns gain() as a NamedMatrix, with the names of controls and of entries of dx.");
  of_knot(
      c, "named_value_hessian", 1,
      [](const DdpSolver& s, int k) { return s.named_value_hessian(k); },
      "Returns value_hessian() as a NamedMatrix, with the names of entries of dx.");
}

}  // namespace

void bind_solver(py::module_& m) {
  SolverClass solver(m, "DdpSolver",
                     "Solver of a Problem. It keeps a reference to the problem, which nothing "
                     "else may use during a solve. Between solves, targets, times and the initial "
                     "state of the problem may change. Results are equal, bit by bit, for any "
                     "number of threads.");
  bind_setting_up(solver);
  bind_budgets(solver);
  bind_solving(solver);
  bind_results(solver);
  solver.def_property_readonly(
      "problem", [](const SolverMachine& self) -> ProblemMachine& { return self.problem; },
      py::return_value_policy::reference_internal, "Problem of the solver.");
  solver.def("__repr__", [](const SolverMachine& self) {
    return "<DdpSolver of '" + self.problem.problem.model().name +
           "': " + std::to_string(self.problem.problem.knots()) + " knots>";
  });
  m.def(
      "check_ddp_options", [](const DdpOptions& options) { options.check(); }, py::arg("options"));
  m.def(
      "summary_text",
      [](const DdpSummary& summary, const ProblemMachine& problem) {
        return summary.text(problem.problem);
      },
      py::arg("summary"), py::arg("problem"));
  m.def("cost_report_text", &CostReport::text, py::arg("report"));
}

}  // namespace burnish::python

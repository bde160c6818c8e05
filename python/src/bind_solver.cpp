// Differential dynamic programming.
#include "arrays.hpp"
#include "bind.hpp"
#include "machine_solver.hpp"
#include "specs_ocp.hpp"

namespace burnish::python {

namespace {

/// Both are in use: the solver reads the problem.
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
        "Allocates everything; the guess is the initial state at every knot and zero controls. "
        "Raises Error for options out of range.")
      .def_property_readonly(
          "options",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.options");
            DdpOptions options = self.solver.options();
            options.callback = self.callback;
            return options;
          },
          "How it works: a DdpOptions, a copy.")
      .def(
          "set_options",
          [](SolverMachine& self, const DdpOptions& options) {
            const BothLocked lock(self, "DdpSolver.set_options");
            self.solver.set_options(self.watched(options));
            self.callback = options.callback;
          },
          py::arg("options"), "Raises Error as the constructor does, and changes nothing then.")
      .def(
          "set_guess",
          [](SolverMachine& self, const Eigen::Ref<const RowMatrix>& xs,
             const Eigen::Ref<const RowMatrix>& us) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_guess");
            self.solver.set_guess(xs, us);
          },
          py::arg("xs"), py::arg("us"),
          "Where the next solve starts: xs (N + 1, nx), us (N, max_controls). Without a call it "
          "starts where the last one ended.");
}

/// What a solve may take, and what it starts from.
void bind_budgets(SolverClass& c) {
  c.def(
       "set_time_budget",
       [](SolverMachine& self, double seconds) {
         const Busy::Lock lock(self.busy, "DdpSolver.set_time_budget");
         self.solver.set_time_budget(seconds);
       },
       py::arg("seconds"), "Anything but a number >= 0 means no time at all.")
      .def(
          "set_max_iterations",
          [](SolverMachine& self, int iterations) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_max_iterations");
            self.solver.set_max_iterations(iterations);
          },
          py::arg("iterations"),
          "At most what the options said when the solver was made or given options.")
      .def(
          "set_limit_budget",
          [](SolverMachine& self, int max_factors, int max_sweeps) {
            const Busy::Lock lock(self.busy, "DdpSolver.set_limit_budget");
            self.solver.set_limit_budget(max_factors, max_sweeps);
          },
          py::arg("max_factors"), py::arg("max_sweeps"),
          "LimitOptions.max_factors and max_sweeps, at least 1 and 0.")
      .def(
          "forget_limits",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.forget_limits");
            self.solver.forget_limits();
          },
          "The next solve starts without the multipliers of the last one, as a solver does that is "
          "new.")
      .def(
          "shift_limits",
          [](SolverMachine& self, int knots) {
            const Busy::Lock lock(self.busy, "DdpSolver.shift_limits");
            self.solver.shift_limits(knots);
          },
          py::arg("knots"),
          "The next solve starts with the multipliers of the last one that many knots later, as a "
          "horizon does that has moved on by so much.")
      .def(
          "shift_limits",
          [](SolverMachine& self, const std::vector<int>& sources) {
            const Busy::Lock lock(self.busy, "DdpSolver.shift_limits");
            self.solver.shift_limits(sources);
          },
          py::arg("sources"),
          "The same where knots are of different lengths: knot k with those of knot sources[k], as "
          "far as there are entries. They are not to fall, nor to be before k.");
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
       "Iterates until one of StopReason and returns a DdpSummary. Other threads of Python go on "
       "meanwhile; Ctrl-C ends it between two iterations, and what a callback or a residual raises "
       "arrives here. The trajectory is then the last one that was evaluated.")
      .def_property_readonly(
          "summary",
          [](SolverMachine& self) {
            const Busy::Lock lock(self.busy, "DdpSolver.summary");
            return self.solver.summary();
          },
          "Of the last solve: a DdpSummary.")
      .def(
          "text",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.text");
            return self.solver.text();
          },
          "One sentence that says why the last solve stopped, with the problem's names.")
      .def(
          "cost_report",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.cost_report");
            const py::gil_scoped_release release;
            return self.solver.cost_report();
          },
          "Cost of the present trajectory by term and by knot: a CostReport.")
      .def(
          "optimality_error",
          [](SolverMachine& self) {
            const BothLocked lock(self, "DdpSolver.optimality_error");
            const py::gil_scoped_release release;
            return self.solver.optimality_error();
          },
          "Largest entry of the gradient of the Lagrangian by the controls at the present "
          "trajectory; entries that push against a bound do not count. Infinite where a knot "
          "cannot "
          "be evaluated. Cost per unit of control.");
}

/// A result of the last solve.
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
/// A result of the last solve at a knot; `after` is 1 where the terminal one has it too, or else 0.
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
      c, "xs", [](const DdpSolver& s) { return copied(s.xs()); }, "States (N + 1, nx), a copy.");
  of_solve(
      c, "us", [](const DdpSolver& s) { return copied(s.us()); },
      "Controls (N, max_controls), a copy; entries past a knot's own mean nothing.");
  of_knot(
      c, "feedforward", 0, [](const DdpSolver& s, int k) { return copied(s.feedforward(k)); },
      "(nu,) of the policy u = u_k + feedforward + gain (x (-) x_k) about the iterate that was "
      "expanded last; zero after convergence.");
  of_knot(
      c, "gain", 0, [](const DdpSolver& s, int k) { return RowMatrix(s.gain(k)); },
      "(nu, ndx) of the same policy.");
  of_knot(
      c, "multipliers", 1, [](const DdpSolver& s, int k) { return copied(s.multipliers(k)); },
      "(rows,) of the rows with limits: the cost that a limit's being one unit further out would "
      "save, above zero where the upper one pushes; knots 0 to N.");
  of_knot(
      c, "value_gradient", 1, [](const DdpSolver& s, int k) { return copied(s.value_gradient(k)); },
      "(ndx,), of the value function about the same iterate; knots 0 to N.");
  of_knot(
      c, "value_hessian", 1,
      [](const DdpSolver& s, int k) { return RowMatrix(s.value_hessian(k)); },
      "(ndx, ndx), of the value function about the same iterate; knots 0 to N.");
  of_knot(
      c, "named_gain", 0, [](const DdpSolver& s, int k) { return s.named_gain(k); },
      "gain() with the names of controls and of entries of dx: a NamedMatrix.");
  of_knot(
      c, "named_value_hessian", 1,
      [](const DdpSolver& s, int k) { return s.named_value_hessian(k); },
      "value_hessian() with the names of entries of dx: a NamedMatrix.");
}

}  // namespace

void bind_solver(py::module_& m) {
  SolverClass solver(m, "DdpSolver",
                     "Solves a Problem, which it keeps and which nothing else may use during a "
                     "solve. Between solves the problem may change targets, times and the initial "
                     "state. Results have the same bits for any number of threads.");
  bind_setting_up(solver);
  bind_budgets(solver);
  bind_solving(solver);
  bind_results(solver);
  solver.def_property_readonly(
      "problem", [](const SolverMachine& self) -> ProblemMachine& { return self.problem; },
      py::return_value_policy::reference_internal, "What it solves.");
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

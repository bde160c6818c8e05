// Python object of a DdpSolver.
#pragma once

#include "machine_ocp.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

/// Solver with its lock. Python keeps the problem of the solver alive.
struct SolverMachine {
  SolverMachine(ProblemMachine& machine, const DdpOptions& options)
      : problem(machine), callback(options.callback), solver(machine.problem, watched(options)) {}

  /// Returns options with a callback that checks for signals before it calls the callback of the
  /// user.
  DdpOptions watched(DdpOptions options) {
    options.callback = [this, user = options.callback](const DdpProgress& progress) {
      watch.look();
      return !user || user(progress);
    };
    return options;
  }

  ProblemMachine& problem;
  Busy busy;
  SignalWatch watch;
  DdpCallback callback;  ///< Callback of the user
  DdpSolver solver;
};

}  // namespace burnish::python

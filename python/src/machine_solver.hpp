// A DdpSolver as Python holds it.
#pragma once

#include "machine_ocp.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

/// Python keeps the problem alive.
struct SolverMachine {
  SolverMachine(ProblemMachine& machine, const DdpOptions& options)
      : problem(machine), callback(options.callback), solver(machine.problem, watched(options)) {}

  /// The same with a callback that looks for Ctrl-C before it asks the user's.
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
  DdpCallback callback;  ///< the user's
  DdpSolver solver;
};

}  // namespace burnish::python

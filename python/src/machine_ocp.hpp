// Python object of a Problem.
#pragma once

#include <memory>

#include "base/thread_pool.hpp"
#include "burnish/ocp/problem.hpp"
#include "machine.hpp"

namespace burnish::python {

/// Problem with its lock, which solvers hold during a solve.
struct ProblemMachine {
  explicit ProblemMachine(const ProblemSpec& spec) : problem(spec) {}

  Problem problem;
  Busy busy;
  std::unique_ptr<ThreadPool> pool;  ///< Threads for evaluations; created on first use
};

/// Throws Error unless 0 <= knot <= last.
inline void check_knot(const char* call, int knot, int last) {
  if (knot < 0 || knot > last)
    throw Error(std::string(call) + ": knot " + std::to_string(knot) +
                " does not exist; wanted 0 to " + std::to_string(last));
}

}  // namespace burnish::python

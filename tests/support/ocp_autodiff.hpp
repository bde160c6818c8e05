// Residuals and steps of a problem by automatic differentiation through the kernels of values.
#pragma once

#include "ocp/compiled_problem.hpp"

namespace burnish::test {

/// A knot: its stage, state (nx), control (nu), the stage's targets as the kernels read them, and
/// its own step in s, if it has one.
struct OcpPoint {
  int stage;
  Eigen::VectorXd x, u;
  std::vector<double> targets;
  double step = 0.0;
};

/// Targets of a stage at a time.
std::vector<double> targets_of(const ocp::CompiledProblem& problem, int stage, double time);

/// d(residual of a term)/dz, rows x nz. Not for residuals of a user's own.
Eigen::MatrixXd residual_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at,
                                     int term);
/// d(next state)/dz, ndx x nz, of a step written down once more, of either integrator.
Eigen::MatrixXd step_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at);

}  // namespace burnish::test

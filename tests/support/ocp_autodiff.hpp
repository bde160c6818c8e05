// Derivatives of residuals and steps of a problem by automatic differentiation through the kernels.
#pragma once

#include "ocp/compiled_problem.hpp"

namespace burnish::test {

/// Knot: its stage, state (nx), control (nu), the targets of the stage in the kernels' layout, and
/// the step [s] (0: the stage's step).
struct OcpPoint {
  int stage;
  Eigen::VectorXd x, u;
  std::vector<double> targets;
  double step = 0.0;
};

/// Targets of a stage at a time.
std::vector<double> targets_of(const ocp::CompiledProblem& problem, int stage, double time);

/// d(residual of a term)/dz, rows x nz. Not for user-defined residuals.
Eigen::MatrixXd residual_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at,
                                     int term);
/// d(next state)/dz, ndx x nz, of an independent implementation of both integrators.
Eigen::MatrixXd step_by_autodiff(const ocp::CompiledProblem& problem, const OcpPoint& at);

}  // namespace burnish::test

// Differential dynamic programming with multiple shooting: Gauss-Newton Hessians, starts that need
// not be feasible, bounds on controls. The direction comes from the Riccati recursion; it becomes
// an iterate by a rollout with feedback, as in Mastalli et al., "Crocoddyl" (2020) and "A
// feasibility-driven approach to control-limited DDP" (2022), or by moving all states and controls
// along it; see StepUpdate.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"
#include "burnish/solver/options.hpp"
#include "burnish/solver/shooting_problem.hpp"
#include "burnish/solver/summary.hpp"

namespace burnish {

/// A matrix whose rows are padded, read in place.
using PaddedView = Eigen::Map<const RowMatrix, Eigen::Unaligned, Eigen::OuterStride<>>;

/// A result with the names of what its rows and columns stand for.
struct NamedMatrix {
  std::vector<std::string> rows, columns;
  Eigen::MatrixXd values;
};

/// Solves a ShootingProblem, which must outlive it; results are valid until the next solve. Between
/// solves the problem may change costs, references, bounds, the initial state and which knots have
/// how many controls, but not its sizes. Results have the same bits for any number of threads.
class DdpSolver {
 public:
  /// Allocates everything; the guess is the initial state at every knot and zero controls. Throws
  /// Error for options out of range and for problems whose sizes do not fit together.
  explicit DdpSolver(ShootingProblem& problem, DdpOptions options = {});
  ~DdpSolver();
  DdpSolver(DdpSolver&&) noexcept;
  DdpSolver& operator=(DdpSolver&&) noexcept;

  const DdpOptions& options() const;
  /// May allocate. Throws Error as the constructor does.
  void set_options(DdpOptions options);
  /// Allocates nothing. Anything but a number >= 0 means no time at all.
  void set_time_budget(double seconds);
  /// Allocates nothing; at most what the options said when the solver was made or given options.
  void set_max_iterations(int iterations);

  /// Where the next solve starts: xs (N + 1) x nx, us N x max_controls, a row per knot. Without a
  /// call it starts where the last one ended. Throws Error for other sizes.
  void set_guess(const Eigen::Ref<const RowMatrix>& xs, const Eigen::Ref<const RowMatrix>& us);
  /// The same from plain memory, laid out as TrajectoryView says; throws nothing.
  void set_guess(const TrajectoryView& guess);

  /// Iterates until one of StopReason. Allocates nothing and throws nothing of its own: what the
  /// callback or a function of the problem throws, in any thread, reaches the caller. The
  /// trajectory is then the last one that was evaluated, and the next solve starts from it as
  /// usual.
  const DdpSummary& solve();
  const DdpSummary& summary() const;
  std::string text() const;  ///< summary().text() with the problem's names

  MatrixView xs() const;  ///< (N + 1) x nx
  MatrixView us() const;  ///< N x max_controls; entries past a knot's nu mean nothing
  /// Policy u = u_k + feedforward + gain (x (-) x_k) about the iterate that was expanded last;
  /// after convergence about the solution, with a feedforward of zero. nu; nu x ndx.
  VectorView feedforward(int knot) const;
  PaddedView gain(int knot) const;
  /// Value function about the same iterate: ndx; ndx x ndx. Knots 0 to N.
  VectorView value_gradient(int knot) const;
  PaddedView value_hessian(int knot) const;
  /// The same with names of controls and of entries of dx.
  NamedMatrix named_gain(int knot) const;
  NamedMatrix named_value_hessian(int knot) const;

  /// Cost of the present trajectory by term and by knot. Allocates.
  CostReport cost_report() const;
  /// Largest entry of the gradient of the Lagrangian by the controls at the present trajectory,
  /// with the multipliers that make its gradient by the states vanish; entries that push against a
  /// bound do not count. Infinite where a knot cannot be evaluated. Cost per unit of control.
  double optimality_error();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish

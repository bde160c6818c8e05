// Derivatives of one knot at one state, from the problem and from finite differences.
#pragma once

#include <map>

#include "base/to_size.hpp"
#include "derivatives/check_blocks.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish::ocp {

/// Returns the unit of each entry of z = (u, dx). Random states and finite differences are scaled
/// by these units: 1 for angles, and the robot's length for lengths. Units of torques and forces
/// grow with the robot's weight, and are about 1 for a robot of 20 kg and 1 m. `nu` may be 0.
Eigen::VectorXd check_units(const Problem& problem, int nu);

/// Derivatives of the terms and the dynamics of `knot` at state x and control u.
class CheckPoint {
 public:
  CheckPoint(Problem& problem, int knot, Eigen::VectorXd x, Eigen::VectorXd u);

  Status status() const { return status_; }
  const Eigen::VectorXd& x() const { return x_; }
  /// Returns whether a rotation residual is close to half a turn, where finite differences may
  /// jump.
  bool near_half_turn() const;

  /// Each of these functions returns a block of derivatives for each of u, q, v, tau and the force
  /// states. next_state() must not be called at the terminal knot.
  std::vector<DerivativeBlock> next_state();
  std::vector<DerivativeBlock> residual(int term);
  /// cost() and all_costs() return an empty list if a residual is close to a breakpoint of its
  /// barrier penalty.
  std::vector<DerivativeBlock> cost(int term);
  std::vector<DerivativeBlock> all_costs();
  /// Compares the constraint rows of Problem::expand() with finite differences.
  std::vector<DerivativeBlock> constraint(int term);

 private:
  /// Returns the next state (as a tangent vector from next_), the residuals and the costs of all
  /// terms in one vector.
  Eigen::VectorXd stacked(const Eigen::VectorXd& x, const Eigen::VectorXd& u);
  /// Returns the result of stacked() after entry k of z has changed by h units.
  Eigen::VectorXd moved(int k, double h);
  Eigen::MatrixXd differences(int first, int count);
  std::vector<DerivativeBlock> split(const std::string& name, const std::vector<std::string>& rows,
                                     const Eigen::MatrixXd& value, const Eigen::MatrixXd& expected,
                                     double floor, const Eigen::VectorXd& row_units = {}) const;
  void expand();
  bool near_breakpoint(int term) const;
  const CompiledTerm& term_at(int term) const { return terms_[to_size(term)]; }
  int first_row(int term) const { return first_row_[to_size(term)]; }
  int cost_row(int term) const { return first_row(static_cast<int>(terms_.size())) + term; }

  Problem& problem_;
  int knot_, nu_, nz_;
  Eigen::VectorXd units_;  ///< Unit of each entry of z, nz entries
  Eigen::VectorXd x_, u_;
  int costs_;  ///< Number of costs; constraints follow
  const std::vector<CompiledTerm>& terms_;
  std::vector<int> first_row_;  ///< First row in stacked() of each term, then of each cost
  Status status_ = Status::Ok;
  Eigen::VectorXd next_, here_;
  Eigen::MatrixXd dynamics_;  ///< Derivative of the next state by z, ndx x nz
  Eigen::VectorXd gradient_;  ///< Gradient of the cost by z, nz entries
  RowMatrix rows_;            ///< Derivatives of all constraint rows by z
  std::map<std::pair<int, double>, Eigen::VectorXd> cache_;  ///< Results of moved(), by (k, h)
};

}  // namespace burnish::ocp

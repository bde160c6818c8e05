// One knot at one state: its derivatives, and the same from differences.
#pragma once

#include <map>

#include "derivatives/check_blocks.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish::ocp {

/// Units of the entries of z = (u, dx) that states are drawn and differences made in: 1 for angles,
/// the robot's length for lengths; for torques and forces about 1 on a robot of 20 kg and 1 m, and
/// more as its weight is. nu may be 0.
Eigen::VectorXd check_units(const Problem& problem, int nu);

class CheckPoint {
 public:
  CheckPoint(Problem& problem, int knot, Eigen::VectorXd x, Eigen::VectorXd u);

  Status status() const { return status_; }
  const Eigen::VectorXd& x() const { return x_; }
  /// Whether a rotation residual is so close to half a turn that differences may jump.
  bool near_half_turn() const;

  /// Blocks by u, q, v and tau. Nothing at the end of the horizon.
  std::vector<DerivativeBlock> next_state();
  std::vector<DerivativeBlock> residual(int term);
  /// Empty where a barrier has its seam too close by.
  std::vector<DerivativeBlock> cost(int term);
  std::vector<DerivativeBlock> all_costs();
  /// The rows of a constraint as expand() gives them.
  std::vector<DerivativeBlock> constraint(int term);

 private:
  /// The next state as a tangent from that at x, residuals and costs of all terms.
  Eigen::VectorXd stacked(const Eigen::VectorXd& x, const Eigen::VectorXd& u);
  Eigen::VectorXd moved(int k, double h);
  Eigen::MatrixXd differences(int first, int count);
  std::vector<DerivativeBlock> split(const std::string& name, const std::vector<std::string>& rows,
                                     const Eigen::MatrixXd& value, const Eigen::MatrixXd& expected,
                                     double floor, const Eigen::VectorXd& row_units = {}) const;
  void expand();
  bool near_seam(int term) const;
  const CompiledTerm& term_at(int term) const { return terms_[static_cast<std::size_t>(term)]; }
  int first_row(int term) const { return first_row_[static_cast<std::size_t>(term)]; }
  int cost_row(int term) const { return first_row(static_cast<int>(terms_.size())) + term; }

  Problem& problem_;
  int knot_, nu_, nz_;
  Eigen::VectorXd units_;  ///< nz
  Eigen::VectorXd x_, u_;
  int costs_;  ///< how many terms are costs; constraints follow
  const std::vector<CompiledTerm>& terms_;
  std::vector<int> first_row_;  ///< of each term in the stacked values, then of the costs
  Status status_ = Status::Ok;
  Eigen::VectorXd next_, here_;
  Eigen::MatrixXd dynamics_;  ///< ndx x nz
  Eigen::VectorXd gradient_;  ///< nz
  RowMatrix rows_;            ///< of all constraints, by z
  std::map<std::pair<int, double>, Eigen::VectorXd> cache_;
};

}  // namespace burnish::ocp

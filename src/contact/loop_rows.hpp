// Errors and Jacobian of the loops of a model at one configuration, along all directions that the
// model constrains, redundant or not.
#pragma once

#include <utility>

#include "burnish/contact/contact_set.hpp"
#include "contact/contact_kinematics.hpp"

namespace burnish {

/// Constraint rows of all loops, in the order of the loops. Only the constructor allocates.
class LoopRows {
 public:
  explicit LoopRows(const Model& model);

  int rows() const { return set_.rows(); }
  const ContactSet& set() const { return set_; }
  /// Computes errors and Jacobian at `q` (nq), which must be a valid configuration.
  void update(const Eigen::VectorXd& q);
  const Eigen::VectorXd& error() const { return error_; }  ///< One error per row [m, rad]
  const Eigen::MatrixXd& jacobian() const { return J_; }   ///< Jacobian, rows x nv
  /// Returns the Jacobian with linear rows divided by the longest lever arms (row_size.hpp).
  Eigen::MatrixXd by_reach() const;
  /// Returns the mass matrix (nv x nv) at the last configuration.
  Eigen::MatrixXd mass_matrix() const;

 private:
  Tree tree_;
  ContactSet set_;
  Kinematics<double> kinematics_;
  std::vector<ContactState<double>> states_;
  Eigen::VectorXd at_rest_, error_;
  Eigen::MatrixXd J_;
};

/// Linearly independent rows that span all rows of a matrix.
struct IndependentRows {
  std::vector<int> rows;  ///< Indices of the rows, ascending
  double weakest = 1.0;   ///< Smallest length of a row at the time of its choice; at most 1
};
/// Chooses independent rows of J one by one. After each choice, the remaining rows are made
/// orthogonal to the chosen row. The next choice is the first row with at least half the length of
/// the longest remaining row. Stops when no remaining row is longer than `min_length`.
IndependentRows independent_rows(const Eigen::MatrixXd& J, double min_length);

}  // namespace burnish

// Errors and Jacobian of the loops of a model, as described, at one configuration.
#pragma once

#include <utility>

#include "burnish/contact/contact_set.hpp"
#include "contact/contact_kinematics.hpp"

namespace burnish {

/// Allocates when made. Rows are those of all loops, in their order.
class LoopRows {
 public:
  explicit LoopRows(const Model& model);

  int rows() const { return set_.rows(); }
  const ContactSet& set() const { return set_; }
  /// Loads the configuration q (nq), which is one.
  void update(const Eigen::VectorXd& q);
  const Eigen::VectorXd& error() const { return error_; }  ///< rows, m and rad
  const Eigen::MatrixXd& jacobian() const { return J_; }   ///< rows x nv
  /// The same with the entries of linear rows in units of what the joints could do (row_size.hpp).
  Eigen::MatrixXd by_reach() const;
  /// nv x nv, at the last configuration.
  Eigen::MatrixXd mass_matrix() const;

 private:
  Tree tree_;
  ContactSet set_;
  Kinematics<double> kinematics_;
  std::vector<ContactState<double>> states_;
  Eigen::VectorXd at_rest_, error_;
  Eigen::MatrixXd J_;
};

/// Rows that span all rows of J, chosen one after the other: the one of which most is left, and of
/// those within a factor of two the first. Rows shorter than `least` are none.
struct IndependentRows {
  std::vector<int> rows;  ///< ascending
  double weakest = 1.0;   ///< length that was left of the last one chosen
};
IndependentRows independent_rows(const Eigen::MatrixXd& J, double least);

}  // namespace burnish

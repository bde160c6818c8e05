// Floating-point operations of the kernels per state, for benchmark programs.
#pragma once

#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Numbers of operations. Signs, comparisons and selections do not count.
struct Operations {
  long add = 0;  ///< Additions and subtractions
  long multiply = 0, divide = 0, root = 0;
  long trigonometric = 0;  ///< Sines, cosines and arc tangents
};

/// Operations of three evaluations.
struct OperationCounts {
  Operations inverse_derivatives;  ///< tau, dtau/dq, dtau/dv at given a and lambda
  Operations dynamics;             ///< a and lambda at given tau
  Operations derivatives;          ///< a, lambda and their six derivative blocks at given tau
};

/// Counts the operations of one run of the kernels at q (nq), v and tau (nv each). Throws Error for
/// contacts that ContactSet rejects.
OperationCounts count_operations(const Model& model, const std::vector<ContactSpec>& contacts,
                                 const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& tau);

}  // namespace burnish

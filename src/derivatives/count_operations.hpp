// Floating-point operations per state of the kernels. Part of programs that measure, of no library.
#pragma once

#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Signs, comparisons and choices are free.
struct Operations {
  long add = 0;  ///< and subtract
  long multiply = 0, divide = 0, root = 0;
  long trigonometric = 0;  ///< sine, cosine, arc tangent
};

struct OperationCounts {
  Operations inverse_derivatives;  ///< tau, dtau/dq, dtau/dv at given a and lambda
  Operations dynamics;             ///< a and lambda at given tau
  Operations derivatives;          ///< the same, and their six derivative blocks
};

/// Runs the kernels once, on a scalar that counts, from q (nq) and v, tau (nv) on. Throws Error as
/// ContactSet does.
OperationCounts count_operations(const Model& model, const std::vector<ContactSpec>& contacts,
                                 const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& tau);

}  // namespace burnish

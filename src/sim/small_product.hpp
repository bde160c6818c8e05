// Products of small matrices with rounding that does not depend on memory addresses. Eigen computes
// some entries of a product with vector instructions, which round differently from scalar ones.
// Which entries these are depends on the address of the result. With the functions below, a run
// gives the same bits in every thread.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// Adds `factor` times the product A B to C. C must not be A or B.
template <class A, class B, class C>
void add_product(double factor, const A& a, const B& b, C& c) {
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      double sum = 0.0;
      for (Eigen::Index k = 0; k < a.cols(); ++k) sum += a(i, k) * b(k, j);
      c(i, j) += factor * sum;
    }
}

/// Sets C to the product A B. C must have the right size, and must not be A or B.
template <class A, class B, class C>
void multiply(const A& a, const B& b, C& c) {
  c.setZero();
  add_product(1.0, a, b, c);
}

}  // namespace burnish

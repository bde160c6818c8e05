// Products of small matrices that round alike wherever they lie. Which entries of a product without
// a temporary Eigen takes in vectors, which round otherwise than scalars, depends on the address of
// the result; a run has the same bits in any thread.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// C += factor A B. C is neither A nor B.
template <class A, class B, class C>
void add_product(double factor, const A& a, const B& b, C& c) {
  for (Eigen::Index j = 0; j < b.cols(); ++j)
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      double sum = 0.0;
      for (Eigen::Index k = 0; k < a.cols(); ++k) sum += a(i, k) * b(k, j);
      c(i, j) += factor * sum;
    }
}

/// C = A B, of C's size. C is neither A nor B.
template <class A, class B, class C>
void multiply(const A& a, const B& b, C& c) {
  c.setZero();
  add_product(1.0, a, b, c);
}

}  // namespace burnish

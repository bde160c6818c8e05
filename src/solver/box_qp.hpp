// Small quadratic program with bounds, solved by projected Newton steps (Bertsekas 1982; Tassa,
// Mansard, Todorov, "Control-limited differential dynamic programming", 2014).
#pragma once

#include <vector>

#include "base/to_size.hpp"

namespace burnish {

/// Minimises 1/2 x^T Q x + q^T x subject to lower <= x <= upper.
struct BoxProblem {
  int size = 0;
  const double* hessian = nullptr;  ///< Q, row-major; only the upper triangle is read
  int stride = 0;                   ///< Entries between the starts of two rows of Q
  const double* gradient = nullptr;
  int gradient_step = 1;  ///< Entry i of q is gradient[i * gradient_step]
  const double* lower = nullptr;
  const double* upper = nullptr;
};

struct BoxQpResult {
  /// False if Q, restricted to entries away from the bounds, is not positive definite or not
  /// finite. In this case, x is the best point found.
  bool positive_definite = true;
  int iterations = 0;  ///< Number of Newton steps
};

/// Solves box problems of up to `capacity` entries. Ends after finitely many steps without a
/// tolerance: when a full Newton step stays inside the box and leaves the set of clamped entries
/// unchanged, or when no step length lowers the cost. Does not allocate after construction.
class BoxQp {
 public:
  explicit BoxQp(int capacity);

  /// Solves `problem`. `x` holds the initial guess (any point) and receives the solution.
  BoxQpResult solve(const BoxProblem& problem, double* x);
  /// Returns whether entry i of the last solution is at a bound and the gradient points outwards.
  bool clamped(int i) const { return clamped_[to_size(i)] != 0; }

 private:
  double cost(const BoxProblem& problem, const double* x);
  void update_gradient(const BoxProblem& problem, const double* x);
  bool update_clamped(const BoxProblem& problem, const double* x);
  bool factorize(const BoxProblem& problem);
  void newton_direction(const BoxProblem& problem);
  bool search(const BoxProblem& problem, double* x, bool& whole_step);

  std::vector<double> gradient_, direction_, trial_, factor_;
  std::vector<int> free_;
  std::vector<char> clamped_;
  int capacity_;
};

}  // namespace burnish

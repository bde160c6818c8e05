// A small quadratic program with bounds, by projected Newton steps (Bertsekas 1982; Tassa, Mansard,
// Todorov, "Control-limited differential dynamic programming", 2014).
#pragma once

#include <vector>

namespace burnish {

/// minimise 1/2 x^T Q x + q^T x  subject to  lower <= x <= upper.
struct BoxProblem {
  int size = 0;
  const double* hessian = nullptr;  ///< Q, row-major; only the upper triangle is read
  int stride = 0;                   ///< between rows of Q
  const double* gradient = nullptr;
  int gradient_step = 1;  ///< entry i of q stands at gradient[i * gradient_step]
  const double* lower = nullptr;
  const double* upper = nullptr;
};

struct BoxQpResult {
  /// False: Q on the free entries is not positive definite (or not finite), and x is the best point
  /// so far.
  bool positive_definite = true;
  int iterations = 0;  ///< Newton steps
};

/// Solves box problems of up to `capacity` entries. Ends after finitely many steps without a
/// tolerance: when a full Newton step on the free entries stays inside the box and leaves the set
/// of clamped ones as it is, or when no step length lowers the cost any more. Nothing is allocated
/// after construction.
class BoxQp {
 public:
  explicit BoxQp(int capacity);

  /// `x` is where to start (any point) and where the solution comes.
  BoxQpResult solve(const BoxProblem& problem, double* x);
  /// Of the last solution: x_i stands at a bound and the gradient pushes it there.
  bool clamped(int i) const { return clamped_[static_cast<std::size_t>(i)] != 0; }

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

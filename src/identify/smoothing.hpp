// Signals smoothed and differentiated by local polynomials of degree five (A. Savitzky, M. Golay,
// "Smoothing and Differentiation of Data by Simplified Least Squares Procedures", 1964): symmetric
// in time, hence without delay, and exact for what is a polynomial within the window.
#pragma once

#include <Eigen/Core>

namespace burnish::identify_detail {

class Smoother {
 public:
  /// Windows of 2 half + 1 samples, `period` s apart; half at least 3.
  Smoother(int half, double period);
  int half() const { return half_; }
  /// Weights of a window's samples for the derivative of that order.
  auto weights(int order) const { return weights_.col(order); }
  /// Derivative of order 0, 1 or 2 of a signal at the sample in the middle of a window.
  double at(const Eigen::Ref<const Eigen::VectorXd>& signal, Eigen::Index middle, int order) const {
    return weights_.col(order).dot(signal.segment(middle - half_, 2 * half_ + 1));
  }

 private:
  int half_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> weights_;
};

/// Weights of a mean over 2 half + 1 samples, the fourth power of a cosine: it lets through what is
/// slower than the window, and less than a thousandth of what is faster than 4 / window.
Eigen::VectorXd bell(int half);

}  // namespace burnish::identify_detail

// Smoothing and differentiation by local polynomials of degree five (A. Savitzky, M. Golay,
// "Smoothing and Differentiation of Data by Simplified Least Squares Procedures", 1964). The filter
// is symmetric in time, so it has no delay, and it is exact for polynomials of degree five.
#pragma once

#include <Eigen/Core>

namespace burnish::identify_detail {

class Smoother {
 public:
  /// Sets windows of 2 half + 1 samples with this period [s]; half must be at least 3.
  Smoother(int half, double period);
  int half() const { return half_; }
  /// Returns the weights of a window's samples for a derivative of this order.
  auto weights(int order) const { return weights_.col(order); }
  /// Returns a derivative (order 0, 1 or 2) at sample `middle`, the centre of the window.
  double at(const Eigen::Ref<const Eigen::VectorXd>& signal, Eigen::Index middle, int order) const {
    return weights_.col(order).dot(signal.segment(middle - half_, 2 * half_ + 1));
  }

 private:
  int half_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> weights_;
};

/// Returns the weights of a mean over 2 `half` + 1 samples, which have the shape of a cosine to the
/// fourth power. With T as the duration of the samples, the mean passes frequencies well below
/// 1 / T. Of frequencies above 4 / T, it passes less than a thousandth.
Eigen::VectorXd bell(int half);

}  // namespace burnish::identify_detail

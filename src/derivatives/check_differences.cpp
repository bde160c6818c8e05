#include "derivatives/check_differences.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr std::array<double, 3> first_steps{0.02, 0.002, 0.0002};  // rad or m

struct Estimate {
  Eigen::MatrixXd value, uncertainty;
};

/// Of sixth order in h, from h, h/2 and h/4.
Estimate extrapolate(const MovedValues& values, int n, double h) {
  const Eigen::MatrixXd d1 = central_differences(values, n, h);
  const Eigen::MatrixXd d2 = central_differences(values, n, h / 2.0);
  const Eigen::MatrixXd d3 = central_differences(values, n, h / 4.0);
  const Eigen::MatrixXd coarse = (4.0 * d2 - d1) / 3.0;
  const Eigen::MatrixXd fine = (4.0 * d3 - d2) / 3.0;
  const Eigen::MatrixXd value = (16.0 * fine - coarse) / 15.0;
  return {value, (value - fine).cwiseAbs()};
}

double largest(const Eigen::Ref<const Eigen::MatrixXd>& block) {
  double result = 0.0;
  for (Eigen::Index j = 0; j < block.cols(); ++j)
    for (Eigen::Index i = 0; i < block.rows(); ++i) {
      if (std::isnan(block(i, j))) return std::numeric_limits<double>::quiet_NaN();
      result = std::max(result, std::abs(block(i, j)));
    }
  return result;
}

bool settled(const Estimate& best, Eigen::Index split, double wanted) {
  const Eigen::Index rest = best.value.rows() - split;
  return largest(best.uncertainty.topRows(split)) <= wanted * largest(best.value.topRows(split)) &&
         largest(best.uncertainty.bottomRows(rest)) <=
             wanted * largest(best.value.bottomRows(rest));
}

}  // namespace

Eigen::MatrixXd central_differences(const MovedValues& values, int n, double step) {
  Eigen::MatrixXd result;
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd column = (values(k, step) - values(k, -step)) / (2.0 * step);
    if (k == 0) result.resize(column.size(), n);
    result.col(k) = column;
  }
  return result;
}

Eigen::MatrixXd extrapolated_differences(const MovedValues& values, int n, int split,
                                         double wanted) {
  Estimate best;
  for (const double step : first_steps) {
    const Estimate next = extrapolate(values, n, step);
    if (best.value.size() == 0) {
      best = next;
    } else {
      for (Eigen::Index j = 0; j < n; ++j) {
        for (Eigen::Index i = 0; i < best.value.rows(); ++i) {
          // A NaN is never better, and everything is better than a NaN.
          if (best.uncertainty(i, j) <= next.uncertainty(i, j)) continue;
          if (std::isnan(next.uncertainty(i, j))) continue;
          best.value(i, j) = next.value(i, j);
          best.uncertainty(i, j) = next.uncertainty(i, j);
        }
      }
    }
    if (settled(best, split, wanted)) break;
  }
  return best.value;
}

}  // namespace burnish

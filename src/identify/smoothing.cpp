#include "identify/smoothing.hpp"

#include <cmath>
#include <numbers>

#include "base/decomposition.hpp"

namespace burnish::identify_detail {

Smoother::Smoother(int half, double period) : half_(half), weights_(2 * half + 1, 3) {
  // Scales time by half a window, so that its powers stay near one.
  Eigen::MatrixXd powers(2 * half + 1, 6);
  for (int i = -half; i <= half; ++i) {
    const double x = static_cast<double>(i) / half;
    powers.row(i + half) << 1.0, x, x * x, x * x * x, x * x * x * x, x * x * x * x * x;
  }
  // Coefficients of the best-fitting polynomial: rows of (P^T P)^-1 P^T.
  const Eigen::MatrixXd fit =
      solve_positive(powers.transpose() * powers, Eigen::MatrixXd(powers.transpose()));
  const double unit = half * period;
  weights_.col(0) = fit.row(0);
  weights_.col(1) = fit.row(1) / unit;
  weights_.col(2) = 2.0 * fit.row(2) / (unit * unit);
}

Eigen::VectorXd bell(int half) {
  Eigen::VectorXd result(2 * half + 1);
  for (int i = -half; i <= half; ++i)
    result[i + half] = std::pow(std::cos(0.5 * std::numbers::pi * i / (half + 1.0)), 4);
  return result / result.sum();
}

}  // namespace burnish::identify_detail

#include "derivatives/check_differences.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

/// Largest steps of the three extrapolations, in units of the argument; chosen by hand.
constexpr std::array<double, 3> first_steps{0.02, 0.002, 4.0 * smallest_difference};

/// Derivatives with an estimate of their error.
struct Estimate {
  Eigen::MatrixXd value, uncertainty;
};

/// Extrapolates central differences with the steps h, h/2 and h/4 to sixth order in h.
Estimate extrapolate(const AllMovedValues& values, double h) {
  const Eigen::MatrixXd d1 = central_differences(values, h);
  const Eigen::MatrixXd d2 = central_differences(values, h / 2.0);
  const Eigen::MatrixXd d3 = central_differences(values, h / 4.0);
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

/// Returns true if the uncertainty of each group is at most the noise of the group, or at most
/// `wanted` times the largest entry of the group.
bool settled(const Estimate& best, const std::vector<DifferenceGroup>& groups, double wanted) {
  Eigen::Index first = 0;
  const auto is_settled = [&](Eigen::Index rows, double noise) {
    const double uncertain = largest(best.uncertainty.middleRows(first, rows));
    const double value = largest(best.value.middleRows(first, rows));
    first += rows;
    return uncertain <= std::max(wanted * value, noise);
  };
  for (const DifferenceGroup& group : groups)
    if (!is_settled(group.rows, group.noise)) return false;
  return is_settled(best.value.rows() - first, 0.0);
}

/// Replaces entries of `best` by entries of `next` with smaller uncertainty.
void improve(Estimate& best, const Estimate& next) {
  for (Eigen::Index j = 0; j < best.value.cols(); ++j)
    for (Eigen::Index i = 0; i < best.value.rows(); ++i) {
      // Keeps `best` where `next` is NaN. Replaces `best` where only `best` is NaN.
      if (best.uncertainty(i, j) <= next.uncertainty(i, j)) continue;
      if (std::isnan(next.uncertainty(i, j))) continue;
      best.value(i, j) = next.value(i, j);
      best.uncertainty(i, j) = next.uncertainty(i, j);
    }
}

/// Evaluates `values` for all n entries, one after the other.
AllMovedValues one_by_one(const MovedValues& values, int n) {
  return [&values, n](double h) {
    Eigen::MatrixXd result;
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd column = values(k, h);
      if (k == 0) result.resize(column.size(), n);
      result.col(k) = column;
    }
    return result;
  };
}

}  // namespace

Eigen::MatrixXd central_differences(const AllMovedValues& values, double step) {
  return (values(step) - values(-step)) / (2.0 * step);
}
Eigen::MatrixXd central_differences(const MovedValues& values, int n, double step) {
  return central_differences(one_by_one(values, n), step);
}

Eigen::MatrixXd extrapolated_differences(const AllMovedValues& values,
                                         const std::vector<DifferenceGroup>& groups, double wanted,
                                         double finer) {
  Estimate best;
  for (const double step : first_steps) {
    const Estimate next = extrapolate(values, finer * step);
    if (best.value.size() == 0) {
      best = next;
    } else {
      improve(best, next);
    }
    if (settled(best, groups, wanted)) break;
  }
  return best.value;
}
Eigen::MatrixXd extrapolated_differences(const MovedValues& values, int n, int split,
                                         double wanted) {
  return extrapolated_differences(one_by_one(values, n), {{split}}, wanted);
}

}  // namespace burnish

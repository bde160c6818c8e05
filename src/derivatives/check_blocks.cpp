#include "derivatives/check_blocks.hpp"

#include <cmath>
#include <limits>

namespace burnish {
namespace {

// Default tolerance of the check. It is fixed, because the scale of an error must not depend on the
// tolerance that the user chooses.
constexpr double usual_tolerance = 1e-6;

}  // namespace

BlockMismatch compare(const DerivativeBlock& block) {
  const auto rows = static_cast<Eigen::Index>(block.rows.size());
  const auto columns = static_cast<Eigen::Index>(block.columns.size());
  if (block.value.rows() != rows || block.value.cols() != columns ||
      block.expected.rows() != rows || block.expected.cols() != columns) {
    throw Error("block " + block.name +
                ": the sizes of derivatives, finite differences and names differ; wanted equal "
                "sizes");
  }
  const auto in_units = [&](Eigen::Index i, Eigen::Index j, double x) {
    const double by = block.column_units.size() > 0 ? block.column_units[j] : 1.0;
    const double of = block.row_units.size() > 0 ? block.row_units[i] : 1.0;
    return std::abs(x) * by / of;
  };
  double scale = block.floor;
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i)
      if (const double x = in_units(i, j, block.expected(i, j)); std::isfinite(x))
        scale = std::max(scale, x);
  scale = std::max(scale, block.noise / usual_tolerance);
  BlockMismatch worst;
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double deviation = in_units(i, j, block.value(i, j) - block.expected(i, j));
      double error = deviation == 0.0 ? 0.0 : deviation / scale;
      if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
      if (worst.entry.block.empty() || error > worst.error) {
        worst.error = error;
        worst.entry = {block.name,        block.rows[i],        block.columns[j],
                       block.value(i, j), block.expected(i, j), -1};
      }
    }
  }
  return worst;
}

}  // namespace burnish

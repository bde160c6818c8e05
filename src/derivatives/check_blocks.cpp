#include "derivatives/check_blocks.hpp"

#include <cmath>
#include <limits>

namespace burnish {
namespace {

// Not the one that is asked for: an error is the same number whatever it is compared with, and a
// tolerance below what rounding leaves cannot be met.
constexpr double usual_tolerance = 1e-6;

}  // namespace

BlockMismatch compare(const DerivativeBlock& block) {
  const auto rows = static_cast<Eigen::Index>(block.rows.size());
  const auto columns = static_cast<Eigen::Index>(block.columns.size());
  if (block.value.rows() != rows || block.value.cols() != columns ||
      block.expected.rows() != rows || block.expected.cols() != columns) {
    throw Error("block " + block.name + ": the sizes of derivatives, differences and names differ");
  }
  double scale = block.floor;
  for (const double x : block.expected.reshaped()) {
    if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
  }
  scale = std::max(scale, block.noise / usual_tolerance);
  BlockMismatch worst;
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double apart = std::abs(block.value(i, j) - block.expected(i, j));
      double error = apart == 0.0 ? 0.0 : apart / scale;
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

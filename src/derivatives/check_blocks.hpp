// One block of derivatives beside the same block from differences.
#pragma once

#include "burnish/derivatives/check.hpp"

namespace burnish {

struct DerivativeBlock {
  std::string name;  ///< such as "da_dq"
  std::vector<std::string> rows, columns;
  Eigen::MatrixXd value;     ///< analytic
  Eigen::MatrixXd expected;  ///< from differences
  double floor = 0.0;        ///< what the error is relative to where the block itself is smaller
  double noise = 0.0;        ///< by how much `expected` is uncertain through rounding
  /// Units of the rows' values and of what columns are by; floor and noise are in them. Empty: 1.
  Eigen::VectorXd row_units = {}, column_units = {};
};

struct BlockMismatch {
  double error = 0.0;  ///< relative to the largest entry of `expected`; infinite after a NaN
  CheckEntry entry;    ///< the worst one; its state is not set
};

/// Entries are compared in their units. Where the noise is more than 1e-6 of the largest entry, the
/// error is relative to as much more, so that noise passes with the default tolerance. Throws Error
/// when the two sides or the names differ in size.
BlockMismatch compare(const DerivativeBlock& block);

}  // namespace burnish

// Comparison of one block of analytic derivatives with finite differences.
#pragma once

#include "burnish/derivatives/check.hpp"

namespace burnish {

/// Block of derivatives, computed in two ways.
struct DerivativeBlock {
  std::string name;                        ///< Name of the block, such as "da_dq"
  std::vector<std::string> rows, columns;  ///< Names of rows and columns
  Eigen::MatrixXd value;                   ///< Analytic derivatives
  Eigen::MatrixXd expected;                ///< Finite differences
  double floor = 0.0;                      ///< Lower bound of the scale of relative errors
  double noise = 0.0;                      ///< Rounding error of `expected`
  /// Units of the rows, and units of the arguments to which the columns belong. Empty: all units
  /// are 1. `floor` and `noise` are numbers in these units.
  Eigen::VectorXd row_units = {}, column_units = {};
};

/// Largest difference between the two versions of a block.
struct BlockMismatch {
  double error = 0.0;  ///< Error relative to the scale; infinite if an entry is not finite
  CheckEntry entry;    ///< Entry with the largest error; its `state` is not set
};

/// Compares the entries of a block in their units. The scale of relative errors is the largest
/// entry of `expected`, but at least `floor` and 1e6 times `noise`. With this scale, errors as
/// small as `noise` pass the default tolerance 1e-6. Throws Error if derivatives, differences or
/// names differ in size.
BlockMismatch compare(const DerivativeBlock& block);

}  // namespace burnish

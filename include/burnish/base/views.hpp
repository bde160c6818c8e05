// Vectors and matrices as they pass through the doors of the library.
#pragma once

#include <Eigen/Core>

#include "burnish/base/abi.hpp"

namespace burnish {

/// A motion or a wrench, linear part first.
using Vector6 = Eigen::Matrix<double, 6, 1>;

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Results read in place: valid while the object that gave them lives.
using VectorView = Eigen::Map<const Eigen::VectorXd>;
using MatrixView = Eigen::Map<const RowMatrix>;

}  // namespace burnish

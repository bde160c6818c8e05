// Vector and matrix types of the public API.
#pragma once

#include <Eigen/Core>

// The library and its users exchange Eigen objects. The library and its users must therefore be
// compiled with the same alignment and the same allocator for Eigen. By default, these two settings
// depend on -march. With different settings, one side could free memory with another allocator than
// the one that allocated it, which is an error.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16 &&
                  EIGEN_MALLOC_ALREADY_ALIGNED == 0,
              "burnish is built with EIGEN_MAX_ALIGN_BYTES=16, EIGEN_MAX_STATIC_ALIGN_BYTES=16 and "
              "EIGEN_MALLOC_ALREADY_ALIGNED=0 so that its Eigen types and their memory have one "
              "layout for every -march; link burnish::burnish in CMake, or define the three on the "
              "command line");

namespace burnish {

/// A motion (velocity or acceleration) or a wrench, linear part first.
using Vector6 = Eigen::Matrix<double, 6, 1>;
/// Wrenches, one per column: force [N], then moment [Nm].
using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Read-only view of a result, without a copy. The view is valid as long as the object that
/// returned it exists.
using VectorView = Eigen::Map<const Eigen::VectorXd>;
using MatrixView = Eigen::Map<const RowMatrix>;

}  // namespace burnish

// Vectors and matrices as they pass through the doors of the library.
#pragma once

#include <Eigen/Core>

// What crosses the library's boundary is the same for every target: Eigen's alignment depends on
// -march unless it is pinned, and memory allocated under one rule must not be freed under another.
// The alignment of types is one thing, the allocator another: whether Eigen's memory comes from
// malloc or from its own aligned allocator hangs on -march too, unless it is told.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16 &&
                  EIGEN_MALLOC_ALREADY_ALIGNED == 0,
              "burnish is built with EIGEN_MAX_ALIGN_BYTES=16, EIGEN_MAX_STATIC_ALIGN_BYTES=16 and "
              "EIGEN_MALLOC_ALREADY_ALIGNED=0 so that its Eigen types and their memory have one "
              "layout for every -march; link burnish::burnish in CMake, or define the three on the "
              "command line");

namespace burnish {

/// A motion or a wrench, linear part first.
using Vector6 = Eigen::Matrix<double, 6, 1>;

using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// Results read in place: valid while the object that gave them lives.
using VectorView = Eigen::Map<const Eigen::VectorXd>;
using MatrixView = Eigen::Map<const RowMatrix>;

}  // namespace burnish

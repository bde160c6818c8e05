// Keeps what crosses the library's boundary the same for every target: Eigen's alignment depends on
// -march unless it is pinned, and memory allocated under one rule must not be freed under another.
#pragma once

#include <Eigen/Core>

// The alignment of types is one thing, the allocator another: whether Eigen's memory comes from
// malloc or from its own aligned allocator hangs on -march too, unless it is told.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16 && EIGEN_MAX_STATIC_ALIGN_BYTES == 16 &&
                  EIGEN_MALLOC_ALREADY_ALIGNED == 0,
              "burnish is built with EIGEN_MAX_ALIGN_BYTES=16, EIGEN_MAX_STATIC_ALIGN_BYTES=16 and "
              "EIGEN_MALLOC_ALREADY_ALIGNED=0 so that its Eigen types and their memory have one "
              "layout for every -march; link burnish::burnish in CMake, or define the three on the "
              "command line");

// The reciprocal of a Cholesky pivot's root, which marks the pivots that are none.
#pragma once

#include <limits>

#include "math/scalar.hpp"

namespace burnish {

/// 1 / sqrt(pivot), zero where the pivot is weak: a factor goes on as if that row were not there.
template <class S>
BURNISH_INLINE S reciprocal_root(const S& pivot, const auto& weak) {
  return S(1.0) / square_root(select(weak, S(std::numeric_limits<double>::infinity()), pivot));
}

}  // namespace burnish

// Reciprocal square root of a Cholesky pivot, with zero for weak pivots.
#pragma once

#include <limits>

#include "math/scalar.hpp"

namespace burnish {

/// Returns 1 / sqrt(pivot), or zero where the mask `weak` is true. With zero, the factorization
/// continues as if the row of this pivot did not exist.
template <class S>
BURNISH_INLINE S reciprocal_root(const S& pivot, const auto& weak) {
  return S(1.0) / square_root(select(weak, S(std::numeric_limits<double>::infinity()), pivot));
}

}  // namespace burnish

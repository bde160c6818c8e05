// Infinity and NaN.
#pragma once

#include <limits>

namespace burnish::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace burnish::test

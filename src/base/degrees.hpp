// Conversion of angles to degrees.
#pragma once

#include <numbers>

namespace burnish {

inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace burnish

// Quintic polynomial of a motion from rest to rest.
#pragma once

namespace burnish::pressing {

/// Value and first two derivatives of a quintic polynomial of x. The polynomial rises from 0 to 1
/// between x=0 and x=1, at rest at both ends.
struct Quintic {
  double s, ds, ds2;
};
inline Quintic quintic(double x) {
  if (x <= 0.0) return {0.0, 0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0, 0.0};
  return {x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * x * x * (1.0 - x) * (1.0 - x),
          60.0 * x * (1.0 - x) * (1.0 - 2.0 * x)};
}
constexpr double quintic_speed = 1.875;  ///< Largest value of the first derivative `ds`.

}  // namespace burnish::pressing

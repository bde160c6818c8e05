#include <algorithm>
#include <cmath>

#include "burnish/dynamics/reference.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"

namespace burnish {
namespace {

/// Smooth step from 0 to 1 over unit time, with its first two derivatives. Velocity and
/// acceleration are zero at both ends.
struct Growth {
  double value, rate, acceleration;
};
Growth growth(double s) {
  if (s >= 1.0) return {1.0, 0.0, 0.0};
  return {s * s * s * (10.0 + s * (-15.0 + 6.0 * s)), 30.0 * s * s * (1.0 - s) * (1.0 - s),
          60.0 * s * (1.0 - s) * (1.0 - 2.0 * s)};
}

}  // namespace

TaskPoint CirclePath::at(double t) const noexcept {
  t = std::max(t, 0.0);
  const Eigen::Matrix3d axes = Reference::surface_with_normal(normal_world).rotation;
  const Growth g = growth(t / start_up);
  const double r = radius * g.value, dr = radius * g.rate / start_up,
               ddr = radius * g.acceleration / (start_up * start_up);
  const double c = std::cos(rate * t), s = std::sin(rate * t);
  const Eigen::Vector3d out = c * axes.col(0) + s * axes.col(1);
  const Eigen::Vector3d along = c * axes.col(1) - s * axes.col(0);
  TaskPoint point;
  point.p_world = center_world + r * out;
  point.v_world = dr * out + r * rate * along;
  point.a_world = (ddr - r * rate * rate) * out + 2.0 * dr * rate * along;
  point.force = force;
  return point;
}

}  // namespace burnish

// Sliding distance of a round tip on a plane, without its rolling.
#pragma once

#include <Eigen/Geometry>

namespace burnish::pressing {

/// Returns the displacement along a plane by which a sphere of `radius` [m] has slid since contact
/// [m]. `normal`: normal of the plane. `contact`, `now`: placements of a frame at the sphere's
/// centre, at contact and now. The displacement by rolling, `radius` times the cross product of
/// rotation vector and normal, does not count. With radius 0, the result is the displacement of the
/// centre.
inline Eigen::Vector3d slid(const Eigen::Isometry3d& contact, const Eigen::Isometry3d& now,
                            const Eigen::Vector3d& normal, double radius) noexcept {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(now.linear() * contact.linear().transpose()));
  const Eigen::Vector3d rolled = radius * (turn.angle() * turn.axis()).cross(normal);
  const Eigen::Vector3d off = now.translation() - contact.translation() - rolled;
  return off - normal * normal.dot(off);
}

}  // namespace burnish::pressing

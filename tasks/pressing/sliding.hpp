// How far what stands or leans has slid.
#pragma once

#include <Eigen/Geometry>

namespace burnish::pressing {

/// m, along a plane: how far a ball of this radius at a frame's origin has slid from where it made
/// contact, n being the plane's normal. What it has rolled, r theta x n with theta its turn, is no
/// sliding. Without a radius that is the way of the origin.
inline Eigen::Vector3d slid(const Eigen::Isometry3d& contact, const Eigen::Isometry3d& now,
                            const Eigen::Vector3d& normal, double radius) noexcept {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(now.linear() * contact.linear().transpose()));
  const Eigen::Vector3d rolled = radius * (turn.angle() * turn.axis()).cross(normal);
  const Eigen::Vector3d off = now.translation() - contact.translation() - rolled;
  return off - normal * normal.dot(off);
}

}  // namespace burnish::pressing

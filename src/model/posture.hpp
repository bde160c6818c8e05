// Values of one joint in a posture.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "burnish/model/model.hpp"

namespace burnish {

/// Name of the joint that carries a free-flying root link.
inline constexpr std::string_view root_joint_name = "root_joint";

/// Largest difference between a follower's value in a posture and the value that its leader gives.
/// Allows for rounding in files; chosen by hand [rad, m].
inline constexpr double posture_tolerance = 1e-3;

/// Returns a rotation that maps z to the unit vector `axis`; the identity for `axis` = z.
Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& axis);

/// Returns the kind of a moving joint.
JointKind kind_of(JointType type);

/// Returns the number of values of a joint in a posture: 1, 3 (x, y, angle), 4 (quaternion), 7
/// (position, quaternion), or 0 for a fixed joint.
std::size_t posture_size(JointType type);
std::size_t posture_size(JointKind kind);

/// Throws Error unless `values` has `size` finite entries. If `size` is 4 or 7, the last four
/// entries are a quaternion whose length must be 1 to within 1e-3. Callers must normalise it.
void check_posture_values(const std::string& origin, const std::string& joint,
                          std::span<const double> values, std::size_t size);

/// Returns the placement of the child link's frame in the joint's frame. `values` must have passed
/// check_posture_values(). For a planar joint, x and y are along the first two columns of
/// rotation_from_z(axis), as in q.
Eigen::Isometry3d displacement(const JointSpec& joint, std::span<const double> values);

}  // namespace burnish

// Values of one joint as a posture states them.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "burnish/model/model.hpp"

namespace burnish {

/// Name of the joint that carries a free-flying root link.
inline constexpr std::string_view root_joint_name = "root_joint";

/// By how much the value of a follower may miss the one that its leader gives, rad or m: files are
/// rounded.
inline constexpr double posture_tolerance = 1e-3;

/// Rotation that takes z to the unit vector `axis`; the identity for z itself.
Eigen::Matrix3d rotation_from_z(const Eigen::Vector3d& axis);

/// Kind of a joint that moves.
JointKind kind_of(JointType type);

/// How many numbers a posture states for a joint: 1, 3 (x, y, angle), 4 (quaternion),
/// 7 (p, quaternion), or 0.
std::size_t posture_size(JointType type);
std::size_t posture_size(JointKind kind);

/// Throws Error unless `values` has `size` finite entries and, of 4 or 7, a quaternion of unit
/// length to 1e-3 (files are rounded; it is normalised where it is used).
void check_posture_values(const std::string& origin, const std::string& joint,
                          std::span<const double> values, std::size_t size);

/// Placement of the child link's frame in the joint's frame at zero, for values that passed
/// check_posture_values. For a planar joint x and y are along the first two columns of
/// rotation_from_z(axis), as in q.
Eigen::Isometry3d displacement(const JointSpec& joint, std::span<const double> values);

}  // namespace burnish

// Meaning of the entries of a joint in q and v.
#pragma once

#include "burnish/model/model.hpp"

namespace burnish {

/// Returns the number of a joint's last entries in q that form a unit vector: 4 for a quaternion, 2
/// for a (cos, sin) pair, else 0.
constexpr int unit_entries(JointKind kind) {
  if (kind == JointKind::Revolute || kind == JointKind::Prismatic) return 0;
  return kind == JointKind::FreeFlyer || kind == JointKind::Ball ? 4 : 2;
}

/// Returns the number of a joint's first entries in q and v that are translations. The others are
/// rotations.
constexpr int sliding_entries(JointKind kind) {
  if (kind == JointKind::Prismatic) return 1;
  if (kind == JointKind::Planar) return 2;
  return kind == JointKind::FreeFlyer ? 3 : 0;
}

/// Returns the unit of entry `entry` of a joint's q: "rad", "m", or "-" for quaternions, cosines
/// and sines.
constexpr const char* unit_of_q(JointKind kind, int entry) {
  if (kind == JointKind::Revolute) return "rad";
  return entry < sliding_entries(kind) ? "m" : "-";
}

/// Returns the unit of a quantity at entry k of v: `sliding` for a sliding joint, `turning` for a
/// turning joint.
inline const char* unit_of_v(const Model& model, int k, const char* turning, const char* sliding) {
  const Joint& joint = model.joints[static_cast<std::size_t>(model.joint_of_v[k])];
  return k - joint.v_index < sliding_entries(joint.kind) ? sliding : turning;
}

}  // namespace burnish

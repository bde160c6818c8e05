// What the entries of a joint in q and v are.
#pragma once

#include "burnish/model/model.hpp"

namespace burnish {

/// How many of a joint's last entries in q have unit length together: 4 of a quaternion, 2 of a
/// (cos, sin) pair, or 0.
constexpr int unit_entries(JointKind kind) {
  if (kind == JointKind::Revolute || kind == JointKind::Prismatic) return 0;
  return kind == JointKind::FreeFlyer || kind == JointKind::Ball ? 4 : 2;
}

/// How many of a joint's first entries in v, and in q, are translations; the rest turn.
constexpr int sliding_entries(JointKind kind) {
  if (kind == JointKind::Prismatic) return 1;
  if (kind == JointKind::Planar) return 2;
  return kind == JointKind::FreeFlyer ? 3 : 0;
}

/// Unit of entry `entry` of a joint's q; quaternions, cosines and sines have none: "-".
constexpr const char* unit_of_q(JointKind kind, int entry) {
  if (kind == JointKind::Revolute) return "rad";
  return entry < sliding_entries(kind) ? "m" : "-";
}

}  // namespace burnish

// Conversion between a twist in body axes and the entries of v of a joint with several entries.
#pragma once

#include "burnish/model/model.hpp"
#include "math/spatial.hpp"

namespace burnish {

/// Reads the twist of a planar joint (v_x, v_y, w_z), a free-flyer (v, w) or a ball (w) from
/// entries that are `stride` numbers apart.
template <class S>
BURNISH_INLINE Motion<S> load_twist(JointKind kind, const S* from, int stride = 1) {
  if (kind == JointKind::Planar)
    return {{from[0], from[stride], S(0.0)}, {S(0.0), S(0.0), from[2 * stride]}};
  const Vec3<S> first{from[0], from[stride], from[2 * stride]};
  if (kind == JointKind::Ball) return {Vec3<S>::zero(), first};
  return {first, {from[3 * stride], from[4 * stride], from[5 * stride]}};
}

/// Writes the twist m into the joint's entries, without components that the joint does not have.
template <class S>
BURNISH_INLINE void store_twist(JointKind kind, const Motion<S>& m, S* to, int stride = 1) {
  const Vec3<S>& first = kind == JointKind::Ball ? m.angular : m.linear;
  to[0] = first.x;
  to[stride] = first.y;
  to[2 * stride] = kind == JointKind::Planar ? m.angular.z : first.z;
  if (kind != JointKind::FreeFlyer) return;
  to[3 * stride] = m.angular.x;
  to[4 * stride] = m.angular.y;
  to[5 * stride] = m.angular.z;
}

}  // namespace burnish

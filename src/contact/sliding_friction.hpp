// Smoothed Coulomb friction on a sliding tool (SlidingFriction). The contact constrains the normal
// n. Friction acts at the point c, the tool's origin p shifted by the radius r against n. nu is the
// twist of the tool relative to the base, and v its linear velocity at c. With
//   c = p - r n,   v_t = v - n (n . v),   s = v_t / sqrt(|v_t|^2 + speed^2),
// the force on the tool is lambda (n - coefficient s). The friction wrench per unit of lambda
// depends on the state. If a change of q turns the axes by w, it changes these quantities by
//   dn = w x n,   dc = dp - r dn,   dv = dnu(c) + nu.angular x dc,
//   dv_t = dv - n (dn . v + n . dv) - dn (n . v),
//   ds = (dv_t - s (s . dv_t)) / sqrt(|v_t|^2 + speed^2).
// A change of joint velocities leaves n and c constant. All vectors are in world axes.
#pragma once

#include "contact/compiled_contact.hpp"
#include "dynamics/kinematics.hpp"

namespace burnish {

/// State of the friction of one contact, filled by update_contact().
template <class S>
struct Sliding {
  S coefficient;
  Vec3<S> n, c;
  Motion<S> nu;  ///< Twist of the tool relative to the base, about the world's origin
  Vec3<S> v, s;  ///< Velocity v [m/s]; direction s of sliding, shorter than 1
  S per_speed;   ///< 1 / sqrt(|v_t|^2 + speed^2) [s/m]
  /// Friction wrench on the tool per unit of lambda, about the world's origin
  Force<S> per_normal;
  S normal_force = S(0.0);  ///< Normal force lambda, filled by set_contact_force() [N]
};

/// Returns the change of the friction force, per unit of lambda, when the tangential velocity
/// changes by dv_across while the normal n and the point c of friction are constant.
template <class S>
BURNISH_INLINE Vec3<S> friction_force_change(const Sliding<S>& at, const Vec3<S>& dv_across) {
  const Vec3<S> ds = (dv_across - at.s * dot(at.s, dv_across)) * at.per_speed;
  return ds * -at.coefficient;
}

/// Effect of one entry of v on a contact with friction. Motions are about the world's origin.
template <class S>
struct SlidingEntry {
  Motion<S> tool, relative;  ///< Tool twist at a unit rate: in the world, and relative to the base
  Motion<S> dnu_dq;          ///< Derivative of nu by this entry of q, in world axes
  Vec3<S> w_axes;            ///< Angular velocity of the axes at a unit rate
};

template <class S>
BURNISH_INLINE SlidingEntry<S> sliding_entry(int tool_axis, int base_axis, const Vec3<S>& w_axes,
                                             const Motion<S>& v_tool, const Motion<S>& v_base,
                                             const Kinematics<S>& kinematics) {
  SlidingEntry<S> entry{Motion<S>::zero(), Motion<S>::zero(), Motion<S>::zero(), w_axes};
  if (tool_axis >= 0) {
    const AxisState<S>& k = kinematics.axes[tool_axis];
    entry.tool = entry.relative = k.axis;
    entry.dnu_dq = cross(k.axis, v_tool) + k.parent_rate;
  }
  if (base_axis >= 0) {
    const AxisState<S>& k = kinematics.axes[base_axis];
    entry.relative = entry.relative - k.axis;
    entry.dnu_dq = entry.dnu_dq - (cross(k.axis, v_base) + k.parent_rate);
  }
  return entry;
}

/// Returns the derivative of per_normal by entry k of q. `p` is the tool's origin.
template <class S>
BURNISH_INLINE Force<S> sliding_by_q(const SlidingFriction& friction, const Sliding<S>& at,
                                     const Vec3<S>& p, const SlidingEntry<S>& entry) {
  const Vec3<S> dn = cross(entry.w_axes, at.n);
  const Vec3<S> dc = at_point(entry.tool, p).linear - dn * S(friction.radius);
  const Vec3<S> dv = at_point(entry.dnu_dq, at.c).linear + cross(at.nu.angular, dc);
  const Vec3<S> dv_across = dv - at.n * (dot(dn, at.v) + dot(at.n, dv)) - dn * dot(at.n, at.v);
  const Vec3<S> df = friction_force_change(at, dv_across);
  return {df, cross(dc, at.per_normal.linear) + cross(at.c, df)};
}

/// Returns the derivative of per_normal by entry k of v.
template <class S>
BURNISH_INLINE Force<S> sliding_by_v(const Sliding<S>& at, const Motion<S>& relative) {
  const Vec3<S> dv = at_point(relative, at.c).linear;
  const Vec3<S> df = friction_force_change(at, Vec3<S>(dv - at.n * dot(at.n, dv)));
  return {df, cross(at.c, df)};
}

}  // namespace burnish

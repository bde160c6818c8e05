// Coulomb friction of a tool that slides, smoothed (SlidingFriction). With n the held normal, c the
// point where it acts, r below the tool's origin p along n, and v the velocity there of the tool
// seen from the base,
//   c = p - r n,   v_t = v - n (n . v),   s = v_t / sqrt(|v_t|^2 + speed^2),
// the force on the tool is lambda (n - coefficient s): a wrench for lambda of one that changes with
// the state. A step of q changes it by
//   dn = w x n (w: of the axes),   dc = dp - r dn,   dv = dnu(c) + nu.angular x dc,
//   dv_t = dv - n (dn . v + n . dv) - dn (n . v),
//   ds = (dv_t - s (s . dv_t)) / sqrt(|v_t|^2 + speed^2),
// and a step of v by dv = J_c dv. All in world axes.
#pragma once

#include "contact/compiled_contact.hpp"
#include "dynamics/kinematics.hpp"

namespace burnish {

template <class S>
struct Sliding {
  S coefficient;
  Vec3<S> n, c;
  Motion<S> nu;  ///< of the tool against the base, about the world's origin
  Vec3<S> v, s;  ///< m/s; of a length below one
  S per_speed;   ///< 1 / sqrt(|v_t|^2 + speed^2), s/m
  Force<S>
      per_normal;  ///< wrench of friction on the tool for lambda of one, about the world's origin
  S normal_force = S(0.0);  ///< N, lambda along n: set_contact_force
};

/// Fills all but the normal force. p, m: the tool's origin. The speed is friction.fade_speed() /
/// pace.
template <class S>
BURNISH_INLINE void update_sliding(const SlidingFriction& friction, const S& coefficient,
                                   const Vec3<S>& normal, const S& pace, const Vec3<S>& p,
                                   const Motion<S>& nu, Sliding<S>& at) {
  at.coefficient = coefficient;
  at.n = normal;
  at.c = p - normal * S(friction.radius);
  at.nu = nu;
  at.v = at_point(nu, at.c).linear;
  const Vec3<S> across = at.v - normal * dot(normal, at.v);
  const S speed = S(friction.fade_speed()) / pace;
  at.per_speed = S(1.0) / square_root(S(dot(across, across) + speed * speed));
  at.s = across * at.per_speed;
  const Vec3<S> force = at.s * -coefficient;
  at.per_normal = {force, cross(at.c, force)};
}

/// Change of the friction's force, for lambda of one, with one of v across a normal that stays.
template <class S>
BURNISH_INLINE Vec3<S> rubbing_change(const Sliding<S>& at, const Vec3<S>& dv_across) {
  const Vec3<S> ds = (dv_across - at.s * dot(at.s, dv_across)) * at.per_speed;
  return ds * -at.coefficient;
}

/// An entry of v as friction sees it: what it moves tool and base by, and how their twists change
/// with it, about the world's origin; what it turns the axes by.
template <class S>
struct SlidingEntry {
  Motion<S> tool, relative;
  Motion<S> dnu_dq;  ///< seen from the world
  Vec3<S> w_axes;
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

/// Derivative of per_normal by q_k, p being the tool's origin.
template <class S>
BURNISH_INLINE Force<S> sliding_by_q(const SlidingFriction& friction, const Sliding<S>& at,
                                     const Vec3<S>& p, const SlidingEntry<S>& entry) {
  const Vec3<S> dn = cross(entry.w_axes, at.n);
  const Vec3<S> dc = at_point(entry.tool, p).linear - dn * S(friction.radius);
  const Vec3<S> dv = at_point(entry.dnu_dq, at.c).linear + cross(at.nu.angular, dc);
  const Vec3<S> dv_across = dv - at.n * (dot(dn, at.v) + dot(at.n, dv)) - dn * dot(at.n, at.v);
  const Vec3<S> df = rubbing_change(at, dv_across);
  return {df, cross(dc, at.per_normal.linear) + cross(at.c, df)};
}

/// Derivative of per_normal by v_k.
template <class S>
BURNISH_INLINE Force<S> sliding_by_v(const Sliding<S>& at, const Motion<S>& relative) {
  const Vec3<S> dv = at_point(relative, at.c).linear;
  const Vec3<S> df = rubbing_change(at, Vec3<S>(dv - at.n * dot(at.n, dv)));
  return {df, cross(at.c, df)};
}

}  // namespace burnish

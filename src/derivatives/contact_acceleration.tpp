// Definitions of contact_acceleration.hpp, for any scalar.
#pragma once

#include "contact/contact_kinematics.tpp"
#include "derivatives/contact_acceleration.hpp"
#include "math/logarithm.hpp"

namespace burnish {
namespace contact_detail {

/// Motions at a unit rate of one entry k of v, and derivatives by this entry.
template <class S>
struct EntryMotion {
  Motion<S> tool, base;            ///< Tool and base twists: S_k or zero; about the world's origin
  Vec3<S> w_axes;                  ///< Angular velocity of the reference's axes
  Motion<S> relative;              ///< tool - base: twist of the tool relative to the base
  Motion<S> xi;                    ///< Twist of the tool frame relative to the reference
  Motion<S> dnu_dq;                ///< Derivative of nu in tool axes
  Motion<S> dalpha_dq, dalpha_dv;  ///< Derivatives of a_L in tool axes
  Motion<S> tool_rate;             ///< psi'_k if k moves the tool, else zero
  Vec3<S> curved_turn;  ///< Part of w_axes due to a surface; valid if the axes follow a surface
};

/// Adds the rotation of axes that follow a surface.
template <class S>
BURNISH_INLINE void follow_surface(const ContactState<S>& state, EntryMotion<S>& m) {
  m.curved_turn = curved_turn(state, m.relative);
  m.w_axes += m.curved_turn;
  m.xi = turning_at(state.p, m.tool.angular - m.w_axes);
}

/// Computes the motions of one entry of v. `two_bodies` is false if the base is the world and only
/// the tool moves the reference; then terms that are zero are skipped.
template <bool two_bodies, class S>
BURNISH_INLINE EntryMotion<S> entry_motion(
    const CompiledContact& contact, const ContactSupport& entry, const Kinematics<S>& kinematics,
    const InverseDynamics<S>& id, const ContactState<S>& state, const ContactAccelerations<S>& at) {
  const bool tool_moves = !two_bodies || entry.moves_tool();
  const Motion<S> zero = Motion<S>::zero();
  EntryMotion<S> m;
  m.tool = tool_moves ? kinematics.axes[entry.tool_axis].axis : zero;
  m.base = two_bodies && entry.moves_base() ? kinematics.axes[entry.base_axis].axis : zero;
  m.w_axes = zero.angular;
  if (entry.reference.axes >= 0) m.w_axes = kinematics.axes[entry.reference.axes].axis.angular;
  m.tool_rate = tool_moves ? kinematics.axes[entry.tool_axis].parent_rate : zero;
  m.xi = seen_from_reference(contact, state, m.tool, m.w_axes, [&] {
    return reference_twist(entry.reference, state.origin, kinematics);
  });
  if (two_bodies && entry.carries_both()) {
    // Tool and base move as one body or not at all, so the derivatives in tool axes are zero.
    m.relative = m.dnu_dq = m.dalpha_dq = m.dalpha_dv = zero;
    m.curved_turn = zero.angular;
    return m;
  }
  const int k = tool_moves ? entry.tool_axis : entry.base_axis;
  const AxisState<S>* moving = &kinematics.axes[k];
  const Motion<S>* moving_acc = &id.axis_acc[k];
  AxisState<S> difference;
  Motion<S> difference_acc;
  if (two_bodies && tool_moves && entry.moves_base()) {
    // The entry moves tool and base along different axes. All terms below are linear in the axis,
    // so they can be computed from the difference of the two axes.
    const AxisState<S>& of_base = kinematics.axes[entry.base_axis];
    difference = {moving->axis - of_base.axis, moving->parent_rate - of_base.parent_rate,
                  moving->rate_sum - of_base.rate_sum};
    difference_acc = *moving_acc - id.axis_acc[entry.base_axis];
    moving = &difference;
    moving_acc = &difference_acc;
  }
  const AxisState<S>& axis = *moving;
  m.relative = axis.axis;
  m.dnu_dq = axis.parent_rate;
  // Computes psi''_k without gravity: the second line removes the part of gravity.
  m.dalpha_dq = *moving_acc;
  m.dalpha_dq.linear += cross(at.gravity, axis.axis.angular);
  m.dalpha_dv = axis.rate_sum - cross(state.v_tool, axis.axis);
  if constexpr (two_bodies) {
    const Motion<S> carried = cross(axis.axis, state.v_base);
    m.dnu_dq += carried;
    m.dalpha_dq += cross(axis.axis, at.a_base) + cross(axis.parent_rate, state.v_base);
    m.dalpha_dv += carried;
  }
  m.dalpha_dq = m.dalpha_dq - cross(state.v_tool, m.dnu_dq);
  if (two_bodies && !tool_moves) {
    m.relative = -m.relative;
    m.dnu_dq = -m.dnu_dq;
    m.dalpha_dq = -m.dalpha_dq;
    m.dalpha_dv = -m.dalpha_dv;
  }
  if (contact.reference.is_curved) follow_surface(state, m);
  return m;
}

/// Returns true if only the tool's body moves: the base is the world, and the reference is fixed to
/// the tool's body or the world.
inline bool moves_with_tool_alone(const CompiledContact& contact) {
  const auto is_still_or_tool = [&](int body) { return body < 0 || body == contact.tool_body; };
  return contact.base_body < 0 && is_still_or_tool(contact.reference.origin_body) &&
         is_still_or_tool(contact.reference.axes_body);
}
/// Returns false if xi is always zero, because the reference is fixed to the tool.
inline bool xi_matters(const CompiledContact& contact) {
  const CompiledReference& reference = contact.reference;
  return reference.axes_body != contact.tool_body || reference.origin_body != contact.tool_body;
}
/// Returns false if the twist eta in alpha = X (a_L + eta x nu) is always zero.
inline bool eta_matters(const CompiledContact& contact) {
  return contact.spec.acceleration == Acceleration::Classical ||
         (contact.spec.acceleration == Acceleration::TimeDerivative && xi_matters(contact));
}

/// Derivatives, in tool axes, of eta's angular part for a reference with its origin at the tool.
template <class S>
struct TurningRates {
  Vec3<S> dq, dv;
};
/// Returns the TurningRates of axes that follow a surface of the base. The angular part of eta is
/// then the angular part of nu minus the angular velocity of the axes relative to the base. `step`
/// and `dv` are the changes of position and velocity of the tool's point, both relative to the
/// base.
template <class S>
BURNISH_INLINE TurningRates<S> following_rates(const ContactState<S>& state,
                                               const EntryMotion<S>& m) {
  const Vec3<S> step = at_point(m.relative, state.p).linear;
  const Vec3<S> dv = at_point(m.dnu_dq, state.p).linear +
                     cross(m.relative.angular, at_point(state.nu, state.p).linear);
  const CurvedAxes<S>& at = state.curved;
  const Vec3<S> dw = at.turn_rate_change(step, at.normal_change(step), dv);
  return {m.dnu_dq.angular - dw + cross(m.relative.angular, at.w),
          m.relative.angular - m.curved_turn};
}
template <class S>
BURNISH_INLINE TurningRates<S> turning_rates(const CompiledContact& contact,
                                             const ContactSupport& entry,
                                             const Kinematics<S>& kinematics,
                                             const ContactState<S>& state,
                                             const EntryMotion<S>& m) {
  if (contact.reference.is_curved && contact.spec.acceleration != Acceleration::Classical)
    return following_rates(state, m);
  const int body = contact.reference.axes_body;
  if (body < 0 || contact.spec.acceleration == Acceleration::Classical)
    return {m.tool_rate.angular, m.tool.angular};
  if (body == contact.base_body) return {m.dnu_dq.angular, m.relative.angular};
  // w_A is the angular velocity of the body A to which the axes are fixed. Its derivative in tool
  // axes is psi'_k + (S_k - T_k) x w_A. Entry k moves the tool along T_k and A along S_k.
  const Vec3<S> turned = m.w_axes - m.tool.angular;
  Vec3<S> axes_rate = cross(turned, kinematics.bodies[body].v.angular);
  if (entry.reference.axes >= 0)
    axes_rate += kinematics.axes[entry.reference.axes].parent_rate.angular;
  return {m.tool_rate.angular - axes_rate, -turned};
}

/// Returns the derivative by q_k of the pose error's components in the reference. The result is
/// given as a motion at the reference's origin, in world axes.
template <class S>
BURNISH_INLINE Motion<S> error_derivative(const CompiledContact& contact,
                                          const ContactState<S>& state,
                                          const LogCoefficients<S>& log, const EntryMotion<S>& m) {
  const Motion<S> relative = at_point(m.relative, state.p);
  const Vec3<S> tool_at_p = at_point(m.tool, state.p).linear;
  Motion<S> d;
  if (contact.spec.error == PoseError::Split) {
    d.linear = tool_at_p - at_point(m.base, state.target_p).linear;
    d.angular = d_log_rotation(log, state.rotation_error, relative.angular);
  } else {
    d = d_log_placement(log, state.error, relative);
    d.linear += cross(m.tool.angular, state.error.linear);
  }
  d.angular += cross(m.tool.angular, state.rotation_error);
  if (contact.reference.at_tool)
    return {d.linear - cross(m.w_axes, state.error.linear),
            d.angular - cross(m.w_axes, state.error.angular)};
  // Converts d to the derivative of the error as a motion about the world's origin. In the last
  // line, xi - tool is -V_k, with V_k the twist of the reference.
  d.linear += cross(tool_at_p, state.error.angular) + cross(state.p, d.angular);
  if (contact.reference.at_world && contact.reference.axes_body < 0) return d;
  const Motion<S> error = moving_at(state.p, state.error.linear, state.error.angular);
  return at_point(d + cross(m.xi - m.tool, error), state.origin);
}

}  // namespace contact_detail

template <class S>
ContactAccelerations<S> contact_accelerations(const Tree& tree, const CompiledContact& contact,
                                              const Kinematics<S>& kinematics,
                                              const InverseDynamics<S>& id,
                                              const ContactState<S>& state) {
  ContactAccelerations<S> at;
  at.gravity = lift<S>(tree.gravity);
  const Motion<S> gravity{at.gravity, Vec3<S>::zero()};
  const auto of = [&](int body) {
    return body < 0 ? Motion<S>::zero()
                    : kinematics.bodies[body].a_bias + id.a_joint[body] + gravity;
  };
  at.a_base = of(contact.base_body);
  at.alpha = of(contact.tool_body) - at.a_base + cross(state.eta, state.nu);
  if (contact.base_body >= 0) at.alpha += cross(state.v_tool, state.v_base);
  return at;
}

namespace contact_detail {

/// Derivatives of alpha by q_k and v_k in world axes, at the reference's origin.
template <class S>
struct EntryRates {
  Motion<S> dq, dv;
};

/// Motions nu and alpha at the tool's origin. They do not depend on the entry of v.
template <class S>
struct AtTool {
  Motion<S> nu, alpha;
};

/// Computes the EntryRates of a reference with its origin at the tool. eta and xi then rotate
/// about the tool's point, so only their angular parts count. Skips angular rows unless the contact
/// constrains rotation.
template <class S>
BURNISH_INLINE EntryRates<S> rates_at_tool(const CompiledContact& contact,
                                           const ContactSupport& entry,
                                           const Kinematics<S>& kinematics,
                                           const ContactState<S>& state, const AtTool<S>& there,
                                           const EntryMotion<S>& m) {
  EntryRates<S> r{at_point(m.dalpha_dq, state.p), at_point(m.dalpha_dv, state.p)};
  if (eta_matters(contact)) {
    const TurningRates<S> eta = turning_rates(contact, entry, kinematics, state, m);
    const Vec3<S>& w = state.eta.angular;
    const Motion<S> dnu = at_point(m.dnu_dq, state.p), axis = at_point(m.relative, state.p);
    r.dq.linear += cross(eta.dq, there.nu.linear) + cross(w, dnu.linear);
    r.dv.linear += cross(eta.dv, there.nu.linear) + cross(w, axis.linear);
    if (contact.holds_rotation) {
      r.dq.angular += cross(eta.dq, there.nu.angular) + cross(w, dnu.angular);
      r.dv.angular += cross(eta.dv, there.nu.angular) + cross(w, axis.angular);
    }
  }
  if (xi_matters(contact)) {
    r.dq.linear += cross(m.xi.angular, there.alpha.linear);
    if (contact.holds_rotation) r.dq.angular += cross(m.xi.angular, there.alpha.angular);
  }
  return r;
}

/// Computes the EntryRates of a reference with any origin.
template <class S>
BURNISH_INLINE EntryRates<S> rates_anywhere(
    const CompiledContact& contact, const ContactSupport& entry, const Kinematics<S>& kinematics,
    const ContactState<S>& state, const ContactAccelerations<S>& at, const EntryMotion<S>& m) {
  const CompiledReference& reference = contact.reference;
  EntryRates<S> r{m.dalpha_dq + cross(m.xi, at.alpha), m.dalpha_dv};
  if (eta_matters(contact)) {
    Motion<S> eta_dq = m.tool_rate, eta_dv = m.xi;
    if (contact.spec.acceleration == Acceleration::Classical) {
      eta_dq = turning_at(state.p, m.tool_rate.angular);
      eta_dv = turning_at(state.p, m.tool.angular);
    } else if (reference.origin_body >= 0 || reference.axes_body >= 0) {
      // The twist of the reference is V = v_tool - eta, and entry k moves the tool along T_k. The
      // derivative of V in tool axes is dV/dq_k - T_k x V.
      eta_dq += cross(m.tool, state.v_tool - state.eta) -
                reference_twist_by_q(reference, entry.reference, state.origin, kinematics);
    }
    r.dq += cross(eta_dq, state.nu) + cross(state.eta, m.dnu_dq);
    r.dv += cross(eta_dv, state.nu) + cross(state.eta, m.relative);
  }
  if (reference.at_world) return r;
  return {at_point(r.dq, state.origin), at_point(r.dv, state.origin)};
}

/// Subtracts the constrained rows of a motion, times their gains, from out[row * stride].
template <class S>
BURNISH_INLINE void subtract_rows(const CompiledContact& contact, const ContactState<S>& state,
                                  const Motion<S>& m, const S* gain, S* out, int stride) {
  for (const int d : contact.directions) {
    *out -= gain[d] * component(state.axes, m, d);
    out += stride;
  }
}

template <bool two_bodies, class S>
void acceleration_derivatives(const CompiledContact& contact, const Kinematics<S>& kinematics,
                              const InverseDynamics<S>& id, const ContactState<S>& state,
                              const ContactAccelerations<S>& at, StateDerivatives<S> minus) {
  const int stride = minus.stride;
  const AtTool<S> there{at_point(state.nu, state.p), at_point(at.alpha, state.p)};
  const ContactSpec& spec = contact.spec;
  S kd[6], kp[6];  // gains of constrained directions, scaled by the step ratio
  for (const int d : contact.directions) {
    kd[d] = state.step_ratio * S(spec.kd[d]);
    if (contact.proportional) kp[d] = state.step_ratio * state.step_ratio * S(spec.kp[d]);
  }
  LogCoefficients<S> log{S(0.0), S(0.0), S(0.0)};
  if (contact.proportional) log = log_coefficients(state.rotation_angle);
  for (const ContactSupport& entry : contact.influences) {
    const auto m = entry_motion<two_bodies>(contact, entry, kinematics, id, state, at);
    const EntryRates<S> rates = contact.reference.at_tool
                                    ? rates_at_tool(contact, entry, kinematics, state, there, m)
                                    : rates_anywhere(contact, entry, kinematics, state, at, m);
    S* out_q = minus.dq + entry.v;
    S* out_v = minus.dv + entry.v;
    int r = 0;
    for (const int d : contact.directions) {
      out_q[r * stride] = -component(state.axes, rates.dq, d);
      out_v[r++ * stride] = -component(state.axes, rates.dv, d);
    }
    if (contact.damped) {
      const Motion<S> nu_q = at_point(m.dnu_dq + cross(m.xi, state.nu), state.origin);
      subtract_rows(contact, state, nu_q, kd, out_q, stride);
      subtract_rows(contact, state, at_point(m.relative, state.origin), kd, out_v, stride);
    }
    if (contact.proportional)
      subtract_rows(contact, state, error_derivative(contact, state, log, m), kp, out_q, stride);
  }
}

}  // namespace contact_detail

template <class S>
void contact_acceleration_derivatives(const CompiledContact& contact,
                                      const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                      const ContactState<S>& state,
                                      const ContactAccelerations<S>& at,
                                      StateDerivatives<S> minus) {
  using contact_detail::acceleration_derivatives;
  if (contact_detail::moves_with_tool_alone(contact)) {
    acceleration_derivatives<false>(contact, kinematics, id, state, at, minus);
  } else {
    acceleration_derivatives<true>(contact, kinematics, id, state, at, minus);
  }
}

namespace contact_detail {

/// Subtracts the term for one moving body, axes fixed in the world and origin at the tool. Relative
/// to the tool, the wrench (f, m) rotates with delta_k = w_axes - w_tool, where w_axes is zero.
/// With the linear and angular parts u_j and w_j of S_j,
/// S_j . (delta_k x (f, m)) = delta_k . (f x u_j + m x w_j).
template <class S>
void subtract_turning_axes(const CompiledContact& contact, const Kinematics<S>& kinematics,
                           const ContactState<S>& state, S* dtau_dq, int stride) {
  const Force<S> force = at_point(state.force_world, state.p);
  for (const ContactSupport& row : contact.support) {
    const Motion<S> axis = at_point(kinematics.axes[row.tool_axis].axis, state.p);
    const Vec3<S> arm = cross(force.linear, axis.linear) + cross(force.angular, axis.angular);
    for (const ContactSupport& column : contact.support)
      dtau_dq[row.v * stride + column.v] +=
          dot(kinematics.axes[column.tool_axis].axis.angular, arm);
  }
}

/// Subtracts the term for any contact: dW_k - S_k x* W. W is the wrench in world axes, which moves
/// with the reference, and dW_k is the derivative of W by q_k. The sweep of inverse dynamics used
/// S_k x* W instead, the derivative of a wrench that moves with the body.
template <class S>
void subtract_general_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                                const ContactState<S>& state, S* dtau_dq, int stride) {
  const Force<S>& W = state.force_world;
  const Force<S> held = held_force(contact, state);
  for (const ContactSupport& column : contact.influences) {
    const Motion<S> zero = Motion<S>::zero();
    const Motion<S> tool = column.moves_tool() ? kinematics.axes[column.tool_axis].axis : zero;
    const Motion<S> base = column.moves_base() ? kinematics.axes[column.base_axis].axis : zero;
    Motion<S> reference = reference_twist(column.reference, state.origin, kinematics);
    if (contact.reference.is_curved && !column.carries_both())
      reference += turning_at(state.p, curved_turn(state, relative_axis(column, kinematics)));
    Force<S> dW = cross(reference, held);
    if (contact.has_friction)
      dW += friction_by_q(contact, state, column.tool_axis, column.base_axis, reference.angular,
                          kinematics);
    const Force<S> on_tool = dW - cross(tool, W);
    const Force<S> on_base = dW - cross(base, W);
    for (const ContactSupport& row : contact.support) {
      S& out = dtau_dq[row.v * stride + column.v];
      if (row.moves_tool()) out -= dot(kinematics.axes[row.tool_axis].axis, on_tool);
      if (row.moves_base()) out += dot(kinematics.axes[row.base_axis].axis, on_base);
    }
  }
}

}  // namespace contact_detail

template <class S>
void subtract_force_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                              const ContactState<S>& state, S* dtau_dq, int stride) {
  using namespace contact_detail;
  if (!moves_with_tool_alone(contact) || contact.tool_body < 0 || !contact.reference.at_tool ||
      contact.reference.is_curved || contact.has_friction) {
    subtract_general_transport(contact, kinematics, state, dtau_dq, stride);
  } else if (contact.reference.axes_body != contact.tool_body) {
    subtract_turning_axes(contact, kinematics, state, dtau_dq, stride);
  }
}

template <class S>
void subtract_friction_by_v(const CompiledContact& contact, const Kinematics<S>& kinematics,
                            const ContactState<S>& state, S* dtau_dv, int stride) {
  using contact_detail::relative_axis;
  for (const ContactSupport& column : contact.support) {
    if (column.carries_both()) continue;
    const Force<S> dW =
        sliding_by_v(state.sliding, relative_axis(column, kinematics)) * state.sliding.normal_force;
    for (const ContactSupport& row : contact.support)
      if (!row.carries_both())
        dtau_dv[row.v * stride + column.v] -= dot(relative_axis(row, kinematics), dW);
  }
}

inline bool transport_couples_branches(const CompiledContact& contact) {
  return !contact_detail::moves_with_tool_alone(contact);
}

}  // namespace burnish

// Definitions of contact_acceleration.hpp, for any scalar.
#pragma once

#include "burnish/derivatives/contact_acceleration.hpp"
#include "burnish/math/logarithm.hpp"
#include "contact/contact_kinematics.tpp"

namespace burnish {
namespace contact_detail {

/// What one entry k of v does to a contact.
template <class S>
struct EntryMotion {
  Motion<S> tool, base;  ///< S_k where it moves that body, else zero; about the world's origin
  Motion<S> relative;    ///< tool - base
  Motion<S> xi;          ///< of the tool frame seen from the reference
  Motion<S> dnu_dq;      ///< of nu seen from the tool
  Motion<S> dalpha_dq, dalpha_dv;  ///< of a_L seen from the tool
  Motion<S> tool_rate;             ///< psi'_k where it moves the tool, else zero
};

template <class S>
BURNISH_INLINE EntryMotion<S> entry_motion(
    const CompiledContact& contact, const ContactSupport& entry, const Kinematics<S>& kinematics,
    const InverseDynamics<S>& id, const ContactState<S>& state, const ContactAccelerations<S>& at) {
  const AxisState<S>& axis = kinematics.axes[entry.v];
  const Motion<S> zero = Motion<S>::zero();
  EntryMotion<S> m;
  m.tool = entry.moves_tool ? axis.axis : zero;
  m.base = entry.moves_base ? axis.axis : zero;
  m.tool_rate = entry.moves_tool ? axis.parent_rate : zero;
  m.xi = seen_from_reference(contact, state.p, m.tool, m.base);
  if (entry.moves_tool && entry.moves_base) {
    // Tool and base move as one: nothing changes seen from the tool.
    m.relative = m.dnu_dq = m.dalpha_dq = m.dalpha_dv = zero;
    return m;
  }
  m.relative = axis.axis;
  m.dnu_dq = axis.parent_rate;
  // psi''_k with gravity taken out again
  m.dalpha_dq = id.axis_acc[entry.v];
  m.dalpha_dq.linear += cross(at.gravity, axis.axis.angular);
  m.dalpha_dv = axis.rate_sum - cross(state.v_tool, axis.axis);
  if (contact.base_body >= 0) {
    const Motion<S> carried = cross(axis.axis, state.v_base);
    m.dnu_dq += carried;
    m.dalpha_dq += cross(axis.axis, at.a_base) + cross(axis.parent_rate, state.v_base);
    m.dalpha_dv += carried;
  }
  m.dalpha_dq = m.dalpha_dq - cross(state.v_tool, m.dnu_dq);
  if (entry.moves_base) {
    m.relative = -m.relative;
    m.dnu_dq = -m.dnu_dq;
    m.dalpha_dq = -m.dalpha_dq;
    m.dalpha_dv = -m.dalpha_dv;
  }
  return m;
}

/// Derivatives of eta seen from the tool: {by q, by v}.
template <class S>
struct EtaRates {
  Motion<S> dq, dv;
};
template <class S>
BURNISH_INLINE EtaRates<S> eta_rates(const CompiledContact& contact, const ContactState<S>& state,
                                     const EntryMotion<S>& m) {
  const Motion<S> zero = Motion<S>::zero();
  switch (contact.spec.acceleration) {
    case Acceleration::Spatial:
      return {zero, zero};
    case Acceleration::Classical:
      return {turning_at(state.p, m.tool_rate.angular), turning_at(state.p, m.tool.angular)};
    case Acceleration::TimeDerivative:
      break;
  }
  if (at_world_origin(contact)) return {m.tool_rate, m.tool};
  switch (contact.spec.reference.axes) {
    case Reference::Axes::Tool:
      return {zero, zero};
    case Reference::Axes::Base:
      return {turning_at(state.p, m.dnu_dq.angular), turning_at(state.p, m.relative.angular)};
    case Reference::Axes::World:
      return {turning_at(state.p, m.tool_rate.angular), turning_at(state.p, m.tool.angular)};
  }
  return {zero, zero};
}

/// Derivative by q_k of the error's components in the reference, times minus one row at a time.
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
  if (at_world_origin(contact)) {
    d.linear += cross(tool_at_p, state.error.angular) + cross(state.p, d.angular);
    return d;
  }
  const Vec3<S> w = axes_rate(contact, m.tool.angular, m.base.angular);
  return {d.linear - cross(w, state.error.linear), d.angular - cross(w, state.error.angular)};
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

template <class S>
void contact_acceleration_derivatives(const CompiledContact& contact,
                                      const Kinematics<S>& kinematics, const InverseDynamics<S>& id,
                                      const ContactState<S>& state,
                                      const ContactAccelerations<S>& at, S* minus_dq, S* minus_dv,
                                      int stride) {
  using namespace contact_detail;
  LogCoefficients<S> log{S(0.0), S(0.0), S(0.0)};
  if (contact.proportional) log = log_coefficients(state.rotation_angle);
  for (const ContactSupport& entry : contact.support) {
    const EntryMotion<S> m = entry_motion(contact, entry, kinematics, id, state, at);
    const EtaRates<S> eta = eta_rates(contact, state, m);
    const Motion<S> dq = at_point(
        m.dalpha_dq + cross(eta.dq, state.nu) + cross(state.eta, m.dnu_dq) + cross(m.xi, at.alpha),
        state.origin);
    const Motion<S> dv = at_point(
        m.dalpha_dv + cross(eta.dv, state.nu) + cross(state.eta, m.relative), state.origin);
    S* out_q = minus_dq + entry.v;
    S* out_v = minus_dv + entry.v;
    int r = 0;
    for (const int d : contact.directions) {
      out_q[r * stride] = -component(state.axes, dq, d);
      out_v[r++ * stride] = -component(state.axes, dv, d);
    }
    if (contact.damped) {
      const Motion<S> nu_q = at_point(m.dnu_dq + cross(m.xi, state.nu), state.origin);
      const Motion<S> nu_v = at_point(m.relative, state.origin);
      r = 0;
      for (const int d : contact.directions) {
        const S kd(contact.spec.kd[d]);
        out_q[r * stride] -= kd * component(state.axes, nu_q, d);
        out_v[r++ * stride] -= kd * component(state.axes, nu_v, d);
      }
    }
    if (contact.proportional) {
      const Motion<S> e = error_derivative(contact, state, log, m);
      r = 0;
      for (const int d : contact.directions)
        out_q[r++ * stride] -= S(contact.spec.kp[d]) * component(state.axes, e, d);
    }
  }
}

namespace contact_detail {

/// One moving body, origin at the tool: with delta_k = w_axes - w_tool the wrench seen from the
/// tool turns with delta_k, so that S_j . (delta_k x (f, m)) = delta_k . (f x u_j + m x w_j).
template <class S>
void subtract_turning_axes(const CompiledContact& contact, const Kinematics<S>& kinematics,
                           const ContactState<S>& state, S* dtau_dq, int stride) {
  const Force<S> force = at_point(state.force_world, state.p);
  for (const ContactSupport& row : contact.support) {
    const Motion<S> axis = at_point(kinematics.axes[row.v].axis, state.p);
    const Vec3<S> arm = cross(force.linear, axis.linear) + cross(force.angular, axis.angular);
    for (const ContactSupport& column : contact.support)
      dtau_dq[row.v * stride + column.v] += dot(kinematics.axes[column.v].axis.angular, arm);
  }
}

/// Any contact: dW_k is what the world wrench really does, S_k x* W what the sweep assumed.
template <class S>
void subtract_general_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                                const ContactState<S>& state, S* dtau_dq, int stride) {
  const Force<S>& W = state.force_world;
  const Force<S> at_p = at_point(W, state.p);
  for (const ContactSupport& column : contact.support) {
    const Motion<S>& axis = kinematics.axes[column.v].axis;
    const Motion<S> zero = Motion<S>::zero();
    const Motion<S> tool = column.moves_tool ? axis : zero;
    const Motion<S> base = column.moves_base ? axis : zero;
    Force<S> dW = Force<S>::zero();
    if (!at_world_origin(contact)) {
      const Vec3<S> w = axes_rate(contact, tool.angular, base.angular);
      dW.linear = cross(w, at_p.linear);
      dW.angular = cross(w, at_p.angular) + cross(at_point(tool, state.p).linear, at_p.linear) +
                   cross(state.p, dW.linear);
    }
    const Force<S> on_tool = dW - cross(tool, W);
    const Force<S> on_base = dW - cross(base, W);
    for (const ContactSupport& row : contact.support) {
      S& out = dtau_dq[row.v * stride + column.v];
      if (row.moves_tool) out -= dot(kinematics.axes[row.v].axis, on_tool);
      if (row.moves_base) out += dot(kinematics.axes[row.v].axis, on_base);
    }
  }
}

}  // namespace contact_detail

template <class S>
void subtract_force_transport(const CompiledContact& contact, const Kinematics<S>& kinematics,
                              const ContactState<S>& state, S* dtau_dq, int stride) {
  using namespace contact_detail;
  if (contact.base_body >= 0 || contact.tool_body < 0 || at_world_origin(contact)) {
    subtract_general_transport(contact, kinematics, state, dtau_dq, stride);
  } else if (contact.spec.reference.axes != Reference::Axes::Tool) {
    subtract_turning_axes(contact, kinematics, state, dtau_dq, stride);
  }
}

inline bool transport_couples_branches(const CompiledContact& contact) {
  return contact.base_body >= 0 && contact.tool_body >= 0;
}

}  // namespace burnish

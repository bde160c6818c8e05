// Definitions of contact_kinematics.hpp, for any scalar.
#pragma once

#include "contact/contact_kinematics.hpp"
#include "math/logarithm.hpp"

namespace burnish {
namespace contact_detail {

template <class S>
struct Pose {
  Mat3<S> R;
  Vec3<S> p;
};

/// Returns the pose, in world axes, of a frame that is fixed to `body` (-1: the world).
template <class S>
BURNISH_INLINE Pose<S> pose_of(int body, const Mat3<double>& R, const Vec3<double>& p,
                               const Kinematics<S>& kinematics) {
  if (body < 0) return {lift<S>(R), lift<S>(p)};
  const BodyState<S>& b = kinematics.bodies[body];
  return {b.R * lift<S>(R), b.p + b.R * lift<S>(p)};
}

/// Returns component d of the motion `m` along the reference axes `axes`. `m` is given in world
/// axes, about the reference's origin.
template <class S>
BURNISH_INLINE S component(const Mat3<S>& axes, const Motion<S>& m, int d) {
  return d < 3 ? dot(column(axes, d), m.linear) : dot(column(axes, d - 3), m.angular);
}

/// Returns the twist of the tool frame relative to the reference. `tool` is the twist of the tool,
/// and `w_axes` the angular velocity of the reference axes. `twist` is a function that returns the
/// twist of the reference. A reference with its origin at the tool translates with the tool.
template <class S>
BURNISH_INLINE Motion<S> seen_from_reference(const CompiledContact& contact,
                                             const ContactState<S>& state, const Motion<S>& tool,
                                             const Vec3<S>& w_axes, const auto& twist) {
  if (contact.reference.at_tool) return turning_at(state.p, tool.angular - w_axes);
  return tool - twist();
}

/// Returns the twist of the tool relative to the base at a unit rate of `entry`. The entry must not
/// move tool and base as one body.
template <class S>
BURNISH_INLINE Motion<S> relative_axis(const ContactSupport& entry,
                                       const Kinematics<S>& kinematics) {
  if (!entry.moves_base()) return kinematics.axes[entry.tool_axis].axis;
  const Motion<S> base = -kinematics.axes[entry.base_axis].axis;
  return entry.moves_tool() ? kinematics.axes[entry.tool_axis].axis + base : base;
}

/// Rotates state.axes by the smallest rotation from the normal of state.axes to the surface normal
/// at the tool.
template <class S>
void update_curved(const CompiledContact& contact, const CurvedSurface<S>& surface,
                   const Kinematics<S>& kinematics, ContactState<S>& state) {
  const CompiledReference& reference = contact.reference;
  const Pose<S> base =
      pose_of<S>(reference.axes_body, reference.fixed_in, reference.place, kinematics);
  const Vec3<S> x = transpose_times(base.R, state.p - base.p);
  CurvedAxes<S>& at = state.curved;
  at = curved_axes(surface, transpose_times(base.R, state.axes.c2), x);
  move_over(base.R, at_point(state.nu, state.p).linear, at);
  const auto turned = [&](const Vec3<S>& axis) {
    return least_rotation(at.n0, at.n, at.inverse_sum, axis);
  };
  state.axes = {turned(state.axes.c0), turned(state.axes.c1), at.n};
}

/// Fills state.sliding, except for the normal force. The smoothing speed of the friction is
/// fade_speed() / step_ratio.
template <class S>
BURNISH_INLINE void update_sliding(const CompiledContact& contact, const S& coefficient,
                                   ContactState<S>& state) {
  const SlidingFriction& friction = *contact.spec.friction;
  const Vec3<S> normal = column(state.axes, contact.directions.front());
  Sliding<S>& at = state.sliding;
  at.coefficient = coefficient;
  at.n = normal;
  at.c = state.p - normal * S(friction.radius);
  at.nu = state.nu;
  at.v = at_point(at.nu, at.c).linear;
  const Vec3<S> across = at.v - normal * dot(normal, at.v);
  const S speed = S(friction.fade_speed()) / state.step_ratio;
  at.per_speed = S(1.0) / square_root(S(dot(across, across) + speed * speed));
  at.s = across * at.per_speed;
  const Vec3<S> force = at.s * -coefficient;
  at.per_normal = {force, cross(at.c, force)};
}

template <class S>
void update_error(const CompiledContact& contact, const Pose<S>& base, ContactState<S>& state) {
  const Mat3<S> target_R = base.R * lift<S>(contact.target_R);
  state.target_p = base.p + base.R * lift<S>(contact.target_p);
  const Mat3<S> relative = transpose_times(target_R, state.tool_R);
  const Vec3<S> offset = state.p - state.target_p;
  const Vec3<S> phi = log_rotation(relative, state.rotation_angle);
  state.rotation_error = state.tool_R * phi;
  if (contact.spec.error == PoseError::Split) {
    state.error = {offset, state.rotation_error};
    return;
  }
  const auto c = log_coefficients(state.rotation_angle);
  const Motion<S> xi = log_placement(c, phi, transpose_times(target_R, offset));
  state.error = {state.tool_R * xi.linear, state.rotation_error};
}

}  // namespace contact_detail

template <class S>
void update_contact(const CompiledContact& contact, const Mat3<S>& axes,
                    const CurvedSurface<S>& surface, const S& friction,
                    const Kinematics<S>& kinematics, ContactState<S>& state) {
  using namespace contact_detail;
  const Pose<S> tool = pose_of<S>(contact.tool_body, contact.tool_R, contact.tool_p, kinematics);
  const auto twist = [&](int body) {
    return body < 0 ? Motion<S>::zero() : kinematics.bodies[body].v;
  };
  state.tool_R = tool.R;
  state.p = tool.p;
  const CompiledReference& reference = contact.reference;
  state.origin = reference.at_tool ? tool.p : reference_origin(reference, kinematics);
  state.axes = reference_axes(reference, axes, kinematics);
  state.v_tool = twist(contact.tool_body);
  state.v_base = twist(contact.base_body);
  state.nu = state.v_tool - state.v_base;
  Vec3<S> w_axes = twist(reference.axes_body).angular;
  if (reference.is_curved) {
    update_curved(contact, surface, kinematics, state);
    w_axes += state.curved.w;
  }
  switch (contact.spec.acceleration) {
    case Acceleration::Spatial:
      state.eta = Motion<S>::zero();
      break;
    case Acceleration::TimeDerivative:
      state.eta = seen_from_reference(contact, state, state.v_tool, w_axes, [&] {
        return reference_twist(reference, state.origin, kinematics);
      });
      break;
    case Acceleration::Classical:
      state.eta = turning_at(tool.p, state.v_tool.angular);
      break;
  }
  if (contact.has_friction) update_sliding(contact, friction, state);
  if (!contact.proportional) return;
  update_error(contact, pose_of<S>(contact.base_body, contact.base_R, contact.base_p, kinematics),
               state);
}

template <class S>
void contact_jacobian(const CompiledContact& contact, const Kinematics<S>& kinematics,
                      const ContactState<S>& state, S* out_by_v, int stride) {
  for (const ContactSupport& entry : contact.support) {
    S* out = out_by_v + entry.v * stride;
    if (entry.carries_both()) {
      for (std::size_t r = 0; r < contact.directions.size(); ++r) out[r] = S(0.0);
      continue;
    }
    const Motion<S> axis = at_point(contact_detail::relative_axis(entry, kinematics), state.origin);
    int r = 0;
    for (const int d : contact.directions)
      out[r++] = contact_detail::component(state.axes, axis, d);
  }
}

template <class S>
void friction_torque(const CompiledContact& contact, const Kinematics<S>& kinematics,
                     const ContactState<S>& state, S* out) {
  for (const ContactSupport& entry : contact.support)
    out[entry.v] = entry.carries_both() ? S(0.0)
                                        : dot(contact_detail::relative_axis(entry, kinematics),
                                              state.sliding.per_normal);
}

template <class S>
void contact_velocity(const CompiledContact& contact, const ContactState<S>& state, S* out) {
  const Motion<S> nu = at_point(state.nu, state.origin);
  int r = 0;
  for (const int d : contact.directions) out[r++] = contact_detail::component(state.axes, nu, d);
}

template <class S>
void contact_error(const CompiledContact& contact, const ContactState<S>& state, S* out) {
  using namespace contact_detail;
  const Motion<S> e =
      at_point(moving_at(state.p, state.error.linear, state.error.angular), state.origin);
  int r = 0;
  for (const int d : contact.directions) out[r++] = component(state.axes, e, d);
}

template <class S>
void contact_acceleration(const CompiledContact& contact, const ContactState<S>& state,
                          const Motion<S>& a_tool, const Motion<S>& a_base, S* out) {
  using namespace contact_detail;
  // The derivative of nu in tool axes is a_L = a_tool - a_base + v_tool x v_base.
  Motion<S> alpha = a_tool - a_base + cross(state.eta, state.nu);
  if (contact.base_body >= 0) alpha += cross(state.v_tool, state.v_base);
  const Motion<S> alpha_there = at_point(alpha, state.origin);
  int r = 0;
  for (const int d : contact.directions) out[r++] = component(state.axes, alpha_there, d);
  S scratch[6];
  const Vector6& kp = contact.spec.kp;
  const Vector6& kd = contact.spec.kd;
  if (contact.damped) {
    contact_velocity(contact, state, scratch);
    for (std::size_t i = 0; i < contact.directions.size(); ++i)
      out[i] += scratch[i] * (state.step_ratio * S(kd[contact.directions[i]]));
  }
  if (contact.proportional) {
    contact_error(contact, state, scratch);
    const S square = state.step_ratio * state.step_ratio;
    for (std::size_t i = 0; i < contact.directions.size(); ++i)
      out[i] += scratch[i] * (square * S(kp[contact.directions[i]]));
  }
}

template <class S>
BURNISH_INLINE Force<S> wrench_of_rows(const CompiledContact& contact, const S* lambda,
                                       const ContactState<S>& state) {
  Vec3<S> wrench[2] = {Vec3<S>::zero(), Vec3<S>::zero()};  // force, moment
  int r = 0;
  for (const int d : contact.directions) wrench[d / 3] += column(state.axes, d % 3) * lambda[r++];
  return {wrench[0], wrench[1] + cross(state.origin, wrench[0])};
}

template <class S>
void set_contact_force(const CompiledContact& contact, const S* lambda, ContactState<S>& state) {
  state.force_world = wrench_of_rows(contact, lambda, state);
  if (!contact.has_friction) return;
  state.sliding.normal_force = lambda[0];
  state.force_world += state.sliding.per_normal * lambda[0];
}

}  // namespace burnish

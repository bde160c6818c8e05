// Definitions of the templates in springs.hpp.
#pragma once

#include "dynamics/springs.hpp"
#include "math/logarithm.hpp"

namespace burnish {
namespace springs_detail {

/// Angle of a continuous joint from the rest angle of its spring, in [-pi, pi] [rad].
template <class S>
BURNISH_INLINE S angle_of(const Springs::Circle& circle, const S* q) {
  const S rest[2] = {S(circle.cosine), S(circle.sine)};
  return angle_between(rest, q + circle.q);
}

/// Returns the rotation vector of a ball, and sets theta to its length [rad].
template <class S>
BURNISH_INLINE Vec3<S> turn_of(const Springs::Ball& ball, const S* q, S& theta) {
  const S* const x = q + ball.q;
  return log_quaternion(Quaternion<S>{{x[0], x[1], x[2]}, x[3]}, theta);
}

}  // namespace springs_detail

template <class S>
void add_spring_torque(const Springs& springs, const S* q, const S* v, S* tau) {
  for (const Springs::Pull& pull : springs.pulls) tau[pull.row] += S(pull.torque);
  for (const Springs::Linear& entry : springs.linear)
    tau[entry.row] += S(entry.by_q) * q[entry.q_column] + S(entry.by_v) * v[entry.column];
  for (const Springs::Circle& circle : springs.circles)
    tau[circle.row] -= S(circle.stiffness) * springs_detail::angle_of(circle, q);
  for (const Springs::Ball& ball : springs.balls) {
    S theta;
    const Vec3<S> torque = springs_detail::turn_of(ball, q, theta) * S(-ball.stiffness);
    tau[ball.row] += torque.x;
    tau[ball.row + 1] += torque.y;
    tau[ball.row + 2] += torque.z;
  }
}

template <class S>
void spring_slopes(const Springs& springs, const S* q, S* by_q) {
  S* block = by_q;
  for (const Springs::Linear& entry : springs.linear) *block++ = S(entry.by_q);
  for (const Springs::Circle& circle : springs.circles) *block++ = S(-circle.stiffness);
  for (const Springs::Ball& ball : springs.balls) {
    S theta;
    const Vec3<S> phi = springs_detail::turn_of(ball, q, theta);
    const LogCoefficients<S> c = log_coefficients(theta);
    for (int k = 0; k < 3; ++k) {
      const Vec3<S> axis{S(k == 0 ? 1.0 : 0.0), S(k == 1 ? 1.0 : 0.0), S(k == 2 ? 1.0 : 0.0)};
      const Vec3<S> slope = d_log_rotation(c, phi, axis) * S(-ball.stiffness);
      block[k] = slope.x;
      block[3 + k] = slope.y;
      block[6 + k] = slope.z;
    }
    block += 9;
  }
}

template <class S>
S spring_energy(const Springs& springs, const S* q) {
  S energy(springs.energy_at_zero);
  for (const Springs::Pull& pull : springs.pulls) energy -= S(pull.torque) * q[pull.q];
  for (const Springs::Linear& entry : springs.linear)
    energy -= S(0.5 * entry.by_q) * q[entry.q_row] * q[entry.q_column];
  for (const Springs::Circle& circle : springs.circles) {
    const S angle = springs_detail::angle_of(circle, q);
    energy += S(0.5 * circle.stiffness) * angle * angle;
  }
  for (const Springs::Ball& ball : springs.balls) {
    S theta;
    springs_detail::turn_of(ball, q, theta);
    energy += S(0.5 * ball.stiffness) * theta * theta;
  }
  return energy;
}

}  // namespace burnish

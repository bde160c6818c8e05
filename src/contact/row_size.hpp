// Size of a row of a contact's Jacobian, relative to the size that the lengths of the robot allow
// at other postures. A tiny relative size shows that the row consists of rounding errors.
#pragma once

#include "burnish/contact/contact_set.hpp"
#include "contact/contact_kinematics.hpp"

namespace burnish {

/// Rounding error of a pivot, relative to the diagonal entry of its row. Rounding errors of nearly
/// dependent earlier rows add to it.
inline constexpr double pivot_rounding = 2e-15;

/// Returns the length of the longest path from a root joint to a body's centre of mass [m].
double robot_size(const Model& model);

/// Fills `offset_weight`, and `per_reach` (inverse lever arm) of each entry of `support`. If the
/// reference's origin is not at the tool, all joints get the longest lever arm of the robot.
void set_reaches(const Model& model, CompiledContact& contact);

/// Returns the squared length of a row of the Jacobian, with linear entries divided by their
/// longest lever arms. `row` holds entry k of v at k * stride.
template <class S>
BURNISH_INLINE S row_size(const CompiledContact& contact, int direction, const S* row, int stride) {
  S sum(0.0);
  for (const ContactSupport& entry : contact.support) {
    const S x = row[entry.v * stride] * S(direction < 3 ? entry.per_reach : 1.0);
    sum += x * x;
  }
  return sum;
}

/// Returns the largest value of row_size(): 1, plus a term that grows with the distance between the
/// tool's origin `p` and the origin of the reference. If the two coincide, the term grows with the
/// distance between `p` and the world's origin instead, because of rounding errors.
template <class S>
BURNISH_INLINE S attainable_row_size(const CompiledContact& contact, int direction,
                                     const Vec3<S>& p, const Vec3<S>& origin) {
  if (direction >= 3) return S(1.0);
  const Vec3<S> arm = contact.reference.at_tool ? p : p - origin;
  return S(1.0) + dot(arm, arm) * S(contact.offset_weight);
}

}  // namespace burnish

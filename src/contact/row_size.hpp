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

/// Fills per_reach of the contact's support, and offset_weight. If the reference does not have its
/// origin at the tool, all joints get the longest lever arm of the robot.
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

/// Returns the value that row_size() can attain: 1, plus a term that grows with the distance of the
/// tool's origin `p` from the origin of the reference. If the reference has its origin at the tool,
/// the distance from the world's origin replaces it, to account for rounding errors.
template <class S>
BURNISH_INLINE S attainable_row_size(const CompiledContact& contact, int direction,
                                     const Vec3<S>& p, const Vec3<S>& origin) {
  if (direction >= 3) return S(1.0);
  const Vec3<S> arm = contact.reference.at_tool ? p : p - origin;
  return S(1.0) + dot(arm, arm) * S(contact.offset_weight);
}

}  // namespace burnish

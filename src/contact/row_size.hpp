// Whether a row of a contact's Jacobian is a motion or rounding: its size, before any
// normalisation, beside what the joints could do with these lengths at some other posture.
#pragma once

#include "burnish/contact/contact_set.hpp"
#include "contact/contact_kinematics.hpp"

namespace burnish {

/// Of a pivot's rounding, relative to the diagonal entry that it is what is left of; where the row
/// leans on rows that hardly differ from those before them, theirs comes on top.
inline constexpr double pivot_rounding = 2e-15;

/// The longest way from a joint that hangs on the world to the centre of a body's mass, m.
double robot_size(const Model& model);

/// Fills per_reach of the contact's support, and offset_weight. Where a contact is not about the
/// tool's origin, all levers are judged beside the longest way of the robot.
void set_reaches(const Model& model, CompiledContact& contact);

/// Square of a row of the Jacobian, entry by entry in units of what that entry could do; `row`
/// holds entry k of v at k * stride.
template <class S>
BURNISH_INLINE S row_size(const CompiledContact& contact, int direction, const S* row, int stride) {
  S sum(0.0);
  for (const ContactSupport& entry : contact.support) {
    const S x = row[entry.v * stride] * S(direction < 3 ? entry.per_reach : 1.0);
    sum += x * x;
  }
  return sum;
}

/// What row_size is judged beside: one, and more the further the tool's origin p is from that of
/// the reference, or for rounding's sake from the world's, m.
template <class S>
BURNISH_INLINE S could_have_been(const CompiledContact& contact, int direction, const Vec3<S>& p,
                                 const Vec3<S>& origin) {
  if (direction >= 3) return S(1.0);
  const Vec3<S> arm = contact.reference.at_tool ? p : p - origin;
  return S(1.0) + dot(arm, arm) * S(contact.offset_weight);
}

}  // namespace burnish

// Sliding friction in the contact-space system. The friction of contact j acts on the joints with
// the torques F_j lambda_j. lambda_j is the normal force of the contact, and F_j are the friction
// torques per unit of normal force. If lambda_0 = G^-1 rho are the forces without friction, the
// forces with friction are
//   lambda = lambda_0 - sum over j of R_j lambda_j,   R_j = G^-1 J M^-1 F_j.
// Their normal rows form a small system, with one row per contact with friction:
//   (1 + R at normal rows) lambda_normal = lambda_0 at normal rows.
// A pivot of this system is the inverse apparent inertia with friction, relative to its value
// without friction. If the pivot is zero, the tool jams (P. Painleve, "Sur les lois du frottement
// de glissement", 1895).
#pragma once

#include <algorithm>
#include <vector>

#include "base/to_size.hpp"
#include "contact/contact_kinematics.hpp"
#include "contact/delassus.hpp"

namespace burnish {

/// Pivot at or below which a contact jams; chosen by hand.
inline constexpr double least_friction_pivot = 1e-6;

/// Linear equations for the normal forces of all contacts with friction.
template <class S>
struct FrictionCoupling {
  FrictionCoupling(const Tree& tree, const ContactSet& set) : nv(tree.nv) {
    for (const CompiledContact& contact : set.contacts())
      max_contacts += contact.has_friction ? 1 : 0;
    const auto capacity = to_size(max_contacts);
    contacts.reserve(capacity);
    rows.reserve(capacity);
    torque.assign(capacity * to_size(nv), S(0.0));
    transformed = torque;
    response.assign(capacity * to_size(set.rows()), S(0.0));
    factor.assign(capacity * capacity, S(0.0));
    normal.assign(capacity, S(0.0));
  }

  int size() const { return static_cast<int>(contacts.size()); }
  S* torque_of(int j) { return torque.data() + j * nv; }
  S* transformed_of(int j) { return transformed.data() + j * nv; }

  int nv, max_contacts = 0;    ///< max_contacts: number of contacts with friction in the set
  std::vector<int> contacts;   ///< Active contacts with friction
  std::vector<int> rows;       ///< Index of the normal row of each of `contacts`
  std::vector<S> torque;       ///< F_j, nv entries per contact
  std::vector<S> transformed;  ///< L^-T F_j with M = L^T L, nv entries per contact
  std::vector<S> response;     ///< R_j as column j: active rows x max_contacts
  std::vector<S> factor;       ///< LU factors of the system of normal forces; diagonal: 1 / pivot
  std::vector<S> normal;       ///< Normal forces lambda_normal [N]
};

/// Lists the active contacts with friction.
template <class S>
void choose_sliding(const ContactSet& set, const ActiveContacts& active, FrictionCoupling<S>& f) {
  f.contacts.clear();
  f.rows.clear();
  for (const int c : active.contacts)
    if (set.contacts()[c].has_friction) {
      f.contacts.push_back(c);
      f.rows.push_back(active.first_row[c]);
    }
  std::fill(f.torque.begin(), f.torque.end(), S(0.0));
  std::fill(f.transformed.begin(), f.transformed.end(), S(0.0));
}

/// Factorizes the system of the normal forces. Returns the lanes in which a contact jams.
template <class S>
auto factorize_friction(FrictionCoupling<S>& f) {
  const int k = f.size();
  S* const A = f.factor.data();
  auto bad = less(S(0.0), S(0.0));
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j)
      A[i * k + j] = f.response[f.rows[i] * f.max_contacts + j] + S(i == j ? 1.0 : 0.0);
  for (int p = 0; p < k; ++p) {
    const auto jams = mask_not(less(S(least_friction_pivot), A[p * k + p]));
    bad = mask_or(bad, jams);
    A[p * k + p] = select(jams, S(0.0), S(S(1.0) / select(jams, S(1.0), A[p * k + p])));
    for (int i = p + 1; i < k; ++i) {
      A[i * k + p] = A[i * k + p] * A[p * k + p];
      for (int j = p + 1; j < k; ++j) A[i * k + j] -= A[i * k + p] * A[p * k + j];
    }
  }
  return bad;
}

/// Solves the system of the normal forces in place. Before the call, f.normal holds lambda_0 at the
/// normal rows; after the call, lambda_normal.
template <class S>
void solve_friction(FrictionCoupling<S>& f) {
  const int k = f.size();
  const S* const A = f.factor.data();
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < i; ++j) f.normal[i] -= A[i * k + j] * f.normal[j];
  for (int i = k - 1; i >= 0; --i) {
    for (int j = i + 1; j < k; ++j) f.normal[i] -= A[i * k + j] * f.normal[j];
    f.normal[i] = f.normal[i] * A[i * k + i];
  }
}

}  // namespace burnish

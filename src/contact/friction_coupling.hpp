// What sliding friction does to the contact-space system. It acts on the joints with F_j lambda_j
// for each contact j that rubs, lambda_j its normal force and F_j the torques of friction for one
// of it, and so the forces of the system without friction, lambda_0 = G^-1 rho, become
//   lambda = lambda_0 - sum over j of R_j lambda_j,   R_j = G^-1 J M^-1 F_j,
// whose normal rows are a system of one row per contact that rubs:
//   (1 + R at normal rows) lambda_normal = lambda_0 at normal rows.
// Its pivots are what is left of a row's apparent inertia; where friction takes all of it the tool
// jams (P. Painleve, "Sur les lois du frottement de glissement", 1895).
#pragma once

#include <algorithm>
#include <vector>

#include "contact/contact_kinematics.hpp"
#include "contact/delassus.hpp"

namespace burnish {

/// A contact jams where its pivot is not above this.
inline constexpr double least_friction_pivot = 1e-6;

template <class S>
struct FrictionCoupling {
  FrictionCoupling(const Tree& tree, const ContactSet& set) : nv(tree.nv) {
    for (const CompiledContact& contact : set.contacts()) most += contact.rubs ? 1 : 0;
    const auto room = static_cast<std::size_t>(most);
    contacts.reserve(room);
    rows.reserve(room);
    torque.assign(room * static_cast<std::size_t>(nv), S(0.0));
    transformed = torque;
    response.assign(room * static_cast<std::size_t>(set.rows()), S(0.0));
    factor.assign(room * room, S(0.0));
    normal.assign(room, S(0.0));
  }

  int size() const { return static_cast<int>(contacts.size()); }
  S* torque_of(int j) { return torque.data() + j * nv; }
  S* transformed_of(int j) { return transformed.data() + j * nv; }

  int nv, most = 0;            ///< contacts of the set that rub
  std::vector<int> contacts;   ///< the active ones that do
  std::vector<int> rows;       ///< the active row of each one's normal
  std::vector<S> torque;       ///< F_j, nv entries each
  std::vector<S> transformed;  ///< L^-T F_j, alike
  std::vector<S> response;     ///< R_j as column j of `most`, by row
  std::vector<S> factor;       ///< of the small system, without pivoting; 1 / pivot on its diagonal
  std::vector<S> normal;       ///< scratch: lambda_normal
};

/// Which contacts rub among the active ones.
template <class S>
void choose_rubbing(const ContactSet& set, const ActiveContacts& active, FrictionCoupling<S>& f) {
  f.contacts.clear();
  f.rows.clear();
  for (const int c : active.contacts)
    if (set.contacts()[c].rubs) {
      f.contacts.push_back(c);
      f.rows.push_back(active.first_row[c]);
    }
  std::fill(f.torque.begin(), f.torque.end(), S(0.0));
  std::fill(f.transformed.begin(), f.transformed.end(), S(0.0));
}

/// Factor of the small system, from the responses. Returns the lanes in which some contact jams.
template <class S>
auto factorize_friction(FrictionCoupling<S>& f) {
  const int k = f.size();
  S* const A = f.factor.data();
  auto bad = less(S(0.0), S(0.0));
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j)
      A[i * k + j] = f.response[f.rows[i] * f.most + j] + S(i == j ? 1.0 : 0.0);
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

/// f.normal: lambda_0 at normal rows in, lambda_normal out.
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

// Contact-space system G lambda = rho with G = J M^-1 J^T + mu 1. Proximal iterations remove the
// effect of mu (Carpentier, Budhiraja, Mansard, "Proximal and Sparse Resolution of Constrained
// Dynamic Equations", 2021).
#pragma once

#include <span>
#include <vector>

#include "burnish/contact/contact_set.hpp"
#include "contact/row_size.hpp"
#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// Active contacts and the indices of their rows.
struct ActiveContacts {
  std::vector<int> contacts;   ///< Indices of the active contacts
  std::vector<int> first_row;  ///< First row of each contact of the set, -1 if inactive
  int rows = 0;                ///< Number of rows of all active contacts
};

/// Contacts of a set at a state of the robot.
template <class S>
struct ContactsAtState {
  const ContactSet& set;
  const ActiveContacts& active;
  const std::vector<ContactState<S>>& states;  ///< State of each contact of the set
};

/// Contact-space system and its Cholesky factor, filled by update_delassus().
template <class S>
struct Delassus {
  Delassus(const Tree& tree, const ContactSet& set);

  std::vector<S> jacobian_by_v;     ///< J^T: nv x stride
  std::vector<S> T;                 ///< L^-T J^T with M = L^T L: nv x stride
  std::vector<S> factor;            ///< Cholesky factor C of G = C C^T, stride x stride, lower
  std::vector<S> inverse_diagonal;  ///< 1 / C_rr, zero at dependent rows
  std::vector<S> least_pivot;       ///< Lower bound of the pivot of each independent row of G
  std::vector<S> pivot_rounding;    ///< Rounding error of the pivot of each row
  int stride;                       ///< Number of rows if all contacts are active
  std::vector<std::vector<int>> shared_support;  ///< Entries of v coupled to both of two contacts
};

/// Fills `d`. Returns the lanes in which a row depends on earlier rows. In these lanes the factor
/// is finite but meaningless, and inverse_diagonal is zero at the dependent rows.
///
/// With mu = 0, a row is dependent if the length of its independent component is at most
/// independence_tolerance times its attainable length (row_size.hpp). With mu > 0, a row is
/// dependent if its pivot is at most 1e-12 times its diagonal entry.
template <class S>
auto update_delassus(const Tree& tree, const ContactsAtState<S>& contacts,
                     const MassMatrix<S>& mass, double mu, Delassus<S>& d);

/// Multiplies the columns `columns` of X by G^-1, in place. X has `rows` rows.
template <class S>
void solve_delassus(const Delassus<S>& d, int rows, std::span<const int> columns, S* x, int stride);

}  // namespace burnish

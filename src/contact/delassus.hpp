// The contact-space system G lambda = rho, G = J M^-1 J^T + mu 1, with proximal iterations towards
// mu = 0 (Carpentier, Budhiraja, Mansard, "Proximal and Sparse Resolution of Constrained Dynamic
// Equations", 2021).
#pragma once

#include <span>
#include <vector>

#include "burnish/contact/contact_set.hpp"
#include "contact/row_size.hpp"
#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// Rows and columns in play: which contacts are active and where their rows start.
struct ActiveContacts {
  std::vector<int> contacts;   ///< indices of the active contacts
  std::vector<int> first_row;  ///< per contact of the set, -1 when inactive
  int rows = 0;
};

/// Filled by update_delassus.
template <class S>
struct Delassus {
  Delassus(const Tree& tree, const ContactSet& set);

  std::vector<S> jacobian_by_v;  ///< J^T: nv x stride
  std::vector<S> T;              ///< L^-T J^T: nv x stride
  std::vector<S> factor;         ///< Cholesky factor C of G = C C^T, stride x stride, lower
  std::vector<S> inverse_diagonal;
  std::vector<S> least_pivot;                    ///< per row: what a pivot of G must exceed
  std::vector<S> pivot_rounding;                 ///< and what rounding may have made of it
  int stride;                                    ///< rows with every contact active
  std::vector<std::vector<int>> shared_support;  ///< entries of v coupled to both of two contacts
};

/// T and the factor of G. Returns the lanes in which some row is not independent of those before
/// it; there the factor is finite but meaningless, and inverse_diagonal is zero at those rows. With
/// mu = 0 that is a row of which no more than independence_tolerance of what could have been is
/// left beside those before it (row_size.hpp); with mu > 0 one whose pivot is not above 1e-12 of
/// its diagonal entry.
template <class S>
auto update_delassus(const Tree& tree, const ContactSet& set, const ActiveContacts& active,
                     const std::vector<ContactState<S>>& states, const MassMatrix<S>& mass,
                     double mu, Delassus<S>& d);

/// X <- G^-1 X for X of `rows` rows, its columns listed.
template <class S>
void solve_delassus(const Delassus<S>& d, int rows, std::span<const int> columns, S* x, int stride);

}  // namespace burnish

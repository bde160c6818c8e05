// Redundant contact rows that contradict each other: the right-hand side of G lambda = rho has a
// part in the null space of G = J M^-1 J^T, which no force can meet. Without it the system has a
// solution of least norm, the least-squares one, and what is left out is the contact acceleration
// that stays unmet. Nothing here runs while the proximal iterations converge.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/delassus.tpp"

namespace burnish {

/// Workspace and result of one evaluation. Allocates when made, never afterwards.
template <class S>
struct Contradiction {
  /// `set` is that of the contacts, or an empty one where no evaluation can end here.
  Contradiction(const Tree& tree, const ContactSet& set)
      : rigid(tree, set),
        basis(static_cast<std::size_t>(set.rows() * set.rows()), S(0.0)),
        unmet(static_cast<std::size_t>(set.rows()), S(0.0)) {
    listed.reserve(unmet.size());
  }

  bool found = false;       ///< in some lane of the last evaluation
  S present = S(0.0);       ///< 1 in those lanes, 0 in the others
  Delassus<S> rigid;        ///< factor of G without compliance, zero at dependent rows
  std::vector<S> basis;     ///< stride x stride: a column for each row that depends on others
  std::vector<int> listed;  ///< those columns; zero in lanes in which the row does not
  std::vector<S> unmet;     ///< per row: J a + alpha_0 + kd nu + kp e that stays, m/s^2 or rad/s^2
};

namespace contradiction_detail {

/// Orthonormalizes the columns; columns of zeros stay zero.
template <class S>
void orthonormalize(Contradiction<S>& of, int rows) {
  const int m = of.rigid.stride;
  S* const x = of.basis.data();
  for (std::size_t i = 0; i < of.listed.size(); ++i) {
    const int c = of.listed[i];
    for (std::size_t j = 0; j < i; ++j) {
      const int before = of.listed[j];
      S part(0.0);
      for (int k = 0; k < rows; ++k) part += x[k * m + before] * x[k * m + c];
      for (int k = 0; k < rows; ++k) x[k * m + c] -= part * x[k * m + before];
    }
    S square(0.0);
    for (int k = 0; k < rows; ++k) square += x[k * m + c] * x[k * m + c];
    const auto is_zero = mask_not(less(S(0.0), square));
    const S scale = S(1.0) / square_root(S(select(is_zero, S(1.0), square)));
    for (int k = 0; k < rows; ++k) x[k * m + c] = x[k * m + c] * scale;
  }
}

}  // namespace contradiction_detail

/// Fills the basis: a vector for each row that depends on those before it, all orthonormal.
/// `compliant` is the factor of G + mu 1.
template <class S>
void find_null_space(const Tree& tree, const ContactSet& set, const ActiveContacts& active,
                     const std::vector<ContactState<S>>& states, const MassMatrix<S>& mass,
                     const Delassus<S>& compliant, double mu, Contradiction<S>& of) {
  Delassus<S>& d = of.rigid;
  std::copy(compliant.jacobian_by_v.begin(), compliant.jacobian_by_v.end(),
            d.jacobian_by_v.begin());
  std::fill(d.T.begin(), d.T.end(), S(0.0));
  update_delassus(tree, set, active, states, mass, 0.0, d);
  std::fill(of.basis.begin(), of.basis.end(), S(0.0));
  of.listed.clear();
  const int m = d.stride;
  S* const n = of.basis.data();
  for (int i = 0; i < active.rows; ++i) {
    const auto dependent = mask_not(less(S(0.0), d.inverse_diagonal[i]));
    if (!any(dependent)) continue;
    of.listed.push_back(i);
    // e_i minus the combination of earlier rows that equals row i.
    n[i * m + i] = select(dependent, S(1.0), S(0.0));
    for (int k = i - 1; k >= 0; --k) {
      S sum = select(dependent, d.factor[i * m + k], S(0.0));
      for (int j = k + 1; j < i; ++j) sum += d.factor[j * m + k] * n[j * m + i];
      n[k * m + i] = -sum * d.inverse_diagonal[k];
    }
  }
  contradiction_detail::orthonormalize(of, active.rows);
  // What rounding left of other directions shrinks by mu / (mu + s) each time, as in the proximal
  // iterations.
  for (int pass = 0; pass < 2; ++pass) {
    solve_delassus(compliant, active.rows, std::span<const int>(of.listed), n, m);
    for (int k = 0; k < active.rows; ++k)
      for (const int i : of.listed) n[k * m + i] = n[k * m + i] * S(mu);
    contradiction_detail::orthonormalize(of, active.rows);
  }
}

/// Subtracts from X its part in the null space, in lanes where `share` is 1. X has `rows` rows;
/// only the listed columns change.
template <class S>
void remove_null_part(const Contradiction<S>& of, const S& share, int rows,
                      std::span<const int> columns, S* x, int stride) {
  const int m = of.rigid.stride;
  const S* const n = of.basis.data();
  for (const int i : of.listed)
    for (const int c : columns) {
      S part(0.0);
      for (int k = 0; k < rows; ++k) part += n[k * m + i] * x[k * stride + c];
      part = part * share;
      for (int k = 0; k < rows; ++k) x[k * stride + c] -= n[k * m + i] * part;
    }
}

}  // namespace burnish

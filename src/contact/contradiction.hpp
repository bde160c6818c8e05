// Redundant contact rows that contradict each other: the right-hand side of G lambda = rho has a
// component in the null space of G = J M^-1 J^T, which no contact force can produce. Once this
// component is removed, the system has a least-squares solution of minimum norm. The component
// remains as a residual contact acceleration. This code runs only if the proximal iterations do not
// converge.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/to_size.hpp"
#include "contact/delassus.tpp"

namespace burnish {

/// Workspace and result of one evaluation. Only the constructor allocates.
template <class S>
struct Contradiction {
  /// `set` contains all contacts, or no contact if the solver runs no proximal iterations.
  Contradiction(const Tree& tree, const ContactSet& set)
      : rigid(tree, set),
        basis(to_size(set.rows() * set.rows()), S(0.0)),
        unmet(to_size(set.rows()), S(0.0)) {
    listed.reserve(unmet.size());
  }

  bool found = false;       ///< Whether rows contradict each other in some lane
  S present = S(0.0);       ///< 1 in lanes with a contradiction, 0 in the others
  Delassus<S> rigid;        ///< Factored G without compliance; inverse_diagonal 0 at dependent rows
  std::vector<S> basis;     ///< Null-space basis, stride x stride: one column per dependent row
  std::vector<int> listed;  ///< Columns of `basis` that are nonzero in some lane
  std::vector<S> unmet;     ///< Residual J a + alpha_0 + kd nu + kp e of each row [m/s^2, rad/s^2]
};

namespace contradiction_detail {

/// Orthonormalizes the columns of the basis. Columns of zeros stay zero.
template <class S>
void orthonormalize(Contradiction<S>& of, int rows) {
  const int m = of.rigid.stride;
  S* const x = of.basis.data();
  for (std::size_t i = 0; i < of.listed.size(); ++i) {
    const int c = of.listed[i];
    for (std::size_t j = 0; j < i; ++j) {
      const int before = of.listed[j];
      S projection(0.0);
      for (int k = 0; k < rows; ++k) projection += x[k * m + before] * x[k * m + c];
      for (int k = 0; k < rows; ++k) x[k * m + c] -= projection * x[k * m + before];
    }
    S squared_norm(0.0);
    for (int k = 0; k < rows; ++k) squared_norm += x[k * m + c] * x[k * m + c];
    const auto is_zero = mask_not(less(S(0.0), squared_norm));
    const S scale = S(1.0) / square_root(S(select(is_zero, S(1.0), squared_norm)));
    for (int k = 0; k < rows; ++k) x[k * m + c] = x[k * m + c] * scale;
  }
}

}  // namespace contradiction_detail

/// Fills the orthonormal basis of the null space, with one vector for each row that depends on
/// earlier rows. `compliant` is the factor of G + mu 1.
template <class S>
void find_null_space(const Tree& tree, const ContactsAtState<S>& contacts,
                     const MassMatrix<S>& mass, const Delassus<S>& compliant, double mu,
                     Contradiction<S>& of) {
  const int rows = contacts.active.rows;
  Delassus<S>& d = of.rigid;
  std::copy(compliant.jacobian_by_v.begin(), compliant.jacobian_by_v.end(),
            d.jacobian_by_v.begin());
  std::fill(d.T.begin(), d.T.end(), S(0.0));
  update_delassus(tree, contacts, mass, 0.0, d);
  std::fill(of.basis.begin(), of.basis.end(), S(0.0));
  of.listed.clear();
  const int m = d.stride;
  S* const n = of.basis.data();
  for (int i = 0; i < rows; ++i) {
    const auto dependent = mask_not(less(S(0.0), d.inverse_diagonal[i]));
    if (!any(dependent)) continue;
    of.listed.push_back(i);
    // Fills column i: e_i minus the coefficients that express row i by the earlier rows.
    n[i * m + i] = select(dependent, S(1.0), S(0.0));
    for (int k = i - 1; k >= 0; --k) {
      S sum = select(dependent, d.factor[i * m + k], S(0.0));
      for (int j = k + 1; j < i; ++j) sum += d.factor[j * m + k] * n[j * m + i];
      n[k * m + i] = -sum * d.inverse_diagonal[k];
    }
  }
  contradiction_detail::orthonormalize(of, rows);
  // Each pass reduces the components outside the null space, which are rounding errors. It scales
  // a component along an eigenvector of G with eigenvalue s by mu / (mu + s).
  for (int pass = 0; pass < 2; ++pass) {
    solve_delassus(compliant, rows, std::span<const int>(of.listed), n, m);
    for (int k = 0; k < rows; ++k)
      for (const int i : of.listed) n[k * m + i] = n[k * m + i] * S(mu);
    contradiction_detail::orthonormalize(of, rows);
  }
}

/// Removes the null-space component from columns `columns` of X, in lanes where `selected` is 1.
/// X has `rows` rows.
template <class S>
void remove_null_part(const Contradiction<S>& of, const S& selected, int rows,
                      std::span<const int> columns, S* x, int stride) {
  const int m = of.rigid.stride;
  const S* const n = of.basis.data();
  for (const int i : of.listed)
    for (const int c : columns) {
      S projection(0.0);
      for (int k = 0; k < rows; ++k) projection += n[k * m + i] * x[k * stride + c];
      projection = projection * selected;
      for (int k = 0; k < rows; ++k) x[k * stride + c] -= n[k * m + i] * projection;
    }
}

}  // namespace burnish

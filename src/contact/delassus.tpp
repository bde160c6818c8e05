// Definitions of delassus.hpp, for any scalar.
#pragma once

#include <algorithm>
#include <iterator>

#include "base/to_size.hpp"
#include "contact/delassus.hpp"
#include "math/gram.hpp"
#include "math/reciprocal_root.hpp"

namespace burnish {

template <class S>
Delassus<S>::Delassus(const Tree& tree, const ContactSet& set)
    : jacobian_by_v(to_size(tree.nv * set.rows()), S(0.0)),
      T(to_size(tree.nv * set.rows()), S(0.0)),
      factor(to_size(set.rows() * set.rows()), S(0.0)),
      inverse_diagonal(to_size(set.rows()), S(0.0)),
      least_pivot(to_size(set.rows()), S(0.0)),
      pivot_rounding(to_size(set.rows()), S(0.0)),
      stride(set.rows()) {
  for (const CompiledContact& a : set.contacts())
    for (const CompiledContact& b : set.contacts()) {
      std::vector<int> shared;
      std::set_intersection(a.coupled.begin(), a.coupled.end(), b.coupled.begin(), b.coupled.end(),
                            std::back_inserter(shared));
      shared_support.push_back(shared);
    }
}

namespace delassus_detail {

/// Multiplies the first `columns` columns of X by L^-T, in place. X is stored as
/// x[v * stride + column]. The columns must be and remain zero outside contact.coupled.
template <class S>
void transform_coupled(const Tree& tree, const CompiledContact& contact, const MassMatrix<S>& mass,
                       S* x, int stride, int columns) {
  const int n = tree.nv;
  for (std::size_t s = contact.coupled.size(); s-- > 0;) {
    const int i = contact.coupled[s];
    S* ti = x + i * stride;
    for (int r = 0; r < columns; ++r) ti[r] = ti[r] * mass.inverse_diagonal[i];
    for (int j = tree.parent_of_v[i]; j >= 0; j = tree.parent_of_v[j]) {
      const S l = mass.factor[i * n + j];
      S* tj = x + j * stride;
      for (int r = 0; r < columns; ++r) tj[r] -= l * ti[r];
    }
  }
}

/// Computes the columns of T = L^-T J^T that belong to one contact.
template <class S>
void transform_jacobian(const Tree& tree, const CompiledContact& contact, const MassMatrix<S>& mass,
                        int first, Delassus<S>& d) {
  const int rows = static_cast<int>(contact.directions.size());
  for (const int k : contact.coupled)
    for (int r = first; r < first + rows; ++r)
      d.T[k * d.stride + r] = d.jacobian_by_v[k * d.stride + r];
  transform_coupled(tree, contact, mass, d.T.data() + first, d.stride, rows);
}

/// Sets the lower bounds of the pivots of a contact's rows: independence_tolerance squared, times
/// the squared length that a row can attain in the metric of M^-1. The bound of a row of zeros is
/// NaN; no pivot exceeds it.
template <class S>
void set_pivot_bounds(const CompiledContact& contact, const ContactState<S>& state, int first,
                      Delassus<S>& d) {
  constexpr double min_fraction = independence_tolerance * independence_tolerance;
  for (std::size_t i = 0; i < contact.directions.size(); ++i) {
    const int r = first + static_cast<int>(i), direction = contact.directions[i];
    const S size = row_size(contact, direction, d.jacobian_by_v.data() + r, d.stride);
    const S ratio = S(1.0) + attainable_row_size(contact, direction, state.p, state.origin) / size;
    d.least_pivot[r] = d.factor[r * d.stride + r] * ratio * S(min_fraction);
    d.pivot_rounding[r] = d.factor[r * d.stride + r] * S(burnish::pivot_rounding);
  }
}

/// Factorizes the lower triangle of G = C C^T in place. Returns the lanes with dependent rows.
template <class S>
auto cholesky(int rows, Delassus<S>& d) {
  auto bad = less(S(0.0), S(0.0));
  const int m = d.stride;
  S* const c = d.factor.data();
  for (int k = 0; k < rows; ++k) {
    const S min_pivot = d.least_pivot[k] + d.pivot_rounding[k];
    const auto weak = mask_not(less(min_pivot, c[k * m + k]));
    bad = mask_or(bad, weak);
    const S reciprocal = reciprocal_root(c[k * m + k], weak);
    d.inverse_diagonal[k] = reciprocal;
    const S uncertain = d.pivot_rounding[k] * reciprocal * reciprocal;
    for (int i = k + 1; i < rows; ++i) {
      const S x = c[i * m + k] * reciprocal;
      c[i * m + k] = x;
      d.pivot_rounding[i] += x * x * uncertain;
    }
    for (int i = k + 1; i < rows; ++i) {
      const S x = c[i * m + k];
      for (int j = k + 1; j <= i; ++j) c[i * m + j] -= x * c[j * m + k];
    }
  }
  return bad;
}

}  // namespace delassus_detail

template <class S>
auto update_delassus(const Tree& tree, const ContactsAtState<S>& contacts,
                     const MassMatrix<S>& mass, double mu, Delassus<S>& d) {
  using namespace delassus_detail;
  const ContactSet& set = contacts.set;
  const ActiveContacts& active = contacts.active;
  const auto rows_of = [&](int c) { return static_cast<int>(set.contacts()[c].directions.size()); };
  for (const int c : active.contacts)
    transform_jacobian(tree, set.contacts()[c], mass, active.first_row[c], d);
  const StridedView<const S> t{d.T.data(), d.stride};
  for (const int a : active.contacts)
    for (const int b : active.contacts) {
      if (b > a) break;
      const int i = active.first_row[a], j = active.first_row[b];
      gram<Gram::Set>(t, t, d.shared_support[a * set.size() + b], i, i + rows_of(a), j,
                      j + rows_of(b), StridedView<S>{d.factor.data(), d.stride});
    }
  if (mu > 0.0) {
    for (int r = 0; r < active.rows; ++r) {
      d.factor[r * d.stride + r] += S(mu);
      d.least_pivot[r] = d.factor[r * d.stride + r] * S(1e-12);
      d.pivot_rounding[r] = S(0.0);
    }
  } else {
    for (const int c : active.contacts)
      set_pivot_bounds(set.contacts()[c], contacts.states[c], active.first_row[c], d);
  }
  return cholesky(active.rows, d);
}

namespace delassus_detail {

/// Multiplies C columns of X by G^-1, in place. The sums of these columns stay in registers.
template <int C, class S>
void solve_columns(const Delassus<S>& d, int rows, const int* columns, S* x, int stride) {
  const S* const c = d.factor.data();
  const int m = d.stride;
  S sum[C];
  const auto load = [&](int i) {
    for (int s = 0; s < C; ++s) sum[s] = x[i * stride + columns[s]];
  };
  const auto subtract = [&](int k, const S& by) {
    for (int s = 0; s < C; ++s) sum[s] -= by * x[k * stride + columns[s]];
  };
  const auto store = [&](int i) {
    for (int s = 0; s < C; ++s) x[i * stride + columns[s]] = sum[s] * d.inverse_diagonal[i];
  };
  for (int i = 0; i < rows; ++i) {
    load(i);
    for (int k = 0; k < i; ++k) subtract(k, c[i * m + k]);
    store(i);
  }
  for (int i = rows - 1; i >= 0; --i) {
    load(i);
    for (int k = i + 1; k < rows; ++k) subtract(k, c[k * m + i]);
    store(i);
  }
}

}  // namespace delassus_detail

template <class S>
void solve_delassus(const Delassus<S>& d, int rows, std::span<const int> columns, S* x,
                    int stride) {
  using delassus_detail::solve_columns;
  const int* column = columns.data();
  auto remaining = columns.size();
  for (; remaining >= 6; remaining -= 6, column += 6) solve_columns<6>(d, rows, column, x, stride);
  if (remaining >= 3) {
    solve_columns<3>(d, rows, column, x, stride);
    remaining -= 3;
    column += 3;
  }
  for (; remaining > 0; --remaining, ++column) solve_columns<1>(d, rows, column, x, stride);
}

}  // namespace burnish

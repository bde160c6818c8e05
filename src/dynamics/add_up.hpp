// Results per axis, added up to results per entry of v: S^T x and S^T X S, the axes being scaled
// already. Only for trees whose axes share entries.
#pragma once

#include <algorithm>

#include "dynamics/tree.hpp"

namespace burnish {

/// by_v (nv) from by_axis (axes).
template <class S>
void add_up(const Tree& tree, const S* by_axis, S* by_v) {
  std::fill_n(by_v, tree.nv, S(0.0));
  for (int k = 0; k < tree.axes; ++k) by_v[tree.v_of_axis[k]] += by_axis[k];
}

/// Calls visit(i, j) for every axis i and every axis j on its way to the root, itself included.
inline void for_related_axes(const Tree& tree, const auto& visit) {
  for (int i = 0; i < tree.axes; ++i)
    for (int j = i; j >= 0; j = tree.parent_of_axis[j]) visit(i, j);
}

/// A symmetric matrix, of which entries (i, j) for ancestors j of i count: by_v's lower triangle.
template <class S>
void add_up_symmetric(const Tree& tree, const S* by_axis, S* by_v) {
  std::fill_n(by_v, tree.nv * tree.nv, S(0.0));
  for_related_axes(tree, [&](int i, int j) {
    const int a = tree.v_of_axis[i], b = tree.v_of_axis[j];
    const S& x = by_axis[i * tree.axes + j];
    S& sum = by_v[std::max(a, b) * tree.nv + std::min(a, b)];
    sum += x;
    if (a == b && i != j) sum += x;
  });
}

/// Any matrix, of which entries of related axes count.
template <class S>
void add_up_square(const Tree& tree, const S* by_axis, S* by_v) {
  std::fill_n(by_v, tree.nv * tree.nv, S(0.0));
  for_related_axes(tree, [&](int i, int j) {
    const int a = tree.v_of_axis[i], b = tree.v_of_axis[j];
    by_v[a * tree.nv + b] += by_axis[i * tree.axes + j];
    if (i != j) by_v[b * tree.nv + a] += by_axis[j * tree.axes + i];
  });
}

}  // namespace burnish

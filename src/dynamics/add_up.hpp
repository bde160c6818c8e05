// Sums over axes, for trees in which several axes have the same entry of v (see tree.hpp). The
// inputs are vectors and matrices with one entry per axis, the outputs have one entry per entry of
// v. The axes of followers must be scaled already.
#pragma once

#include <algorithm>

#include "dynamics/tree.hpp"

namespace burnish {

/// Computes by_v (nv entries) from by_axis (one entry per axis).
template <class S>
void add_up(const Tree& tree, const S* by_axis, S* by_v) {
  std::fill_n(by_v, tree.nv, S(0.0));
  for (int k = 0; k < tree.axes; ++k) by_v[tree.v_of_axis[k]] += by_axis[k];
}

/// Calls visit(i, j) for every axis i and every axis j on the path from i to the root, including i.
inline void for_related_axes(const Tree& tree, const auto& visit) {
  for (int i = 0; i < tree.axes; ++i)
    for (int j = i; j >= 0; j = tree.parent_of_axis[j]) visit(i, j);
}

/// Computes by_v (nv x nv, lower triangle) from a symmetric matrix with one row per axis. Reads the
/// entries (i, j) for ancestors j of i.
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

/// Sums a general matrix over axes. Reads entries (i, j) and (j, i) for ancestors j of i.
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

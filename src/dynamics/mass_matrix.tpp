// Definitions of the templates in mass_matrix.hpp.
#pragma once

#include "base/to_size.hpp"
#include "dynamics/add_up.hpp"
#include "dynamics/articulated.tpp"
#include "dynamics/mass_matrix.hpp"

namespace burnish {

template <class S>
MassMatrix<S>::MassMatrix(const Tree& tree)
    : composite(tree.joints.size()),
      composite_bias(tree.joints.size()),
      mass(to_size(tree.nv * tree.nv), S(0.0)),
      bias(to_size(tree.nv), S(0.0)),
      factor(to_size(tree.nv * tree.nv), S(0.0)),
      inverse_diagonal(to_size(tree.nv), S(0.0)) {
  if (tree.shares_entries()) {
    mass_by_axis.assign(to_size(tree.axes * tree.axes), S(0.0));
    bias_by_axis.assign(to_size(tree.axes), S(0.0));
    added.assign(to_size(tree.nv), S(0.0));
  }
  if (!tree.deep) return;
  row_force.assign(to_size(tree.nv), Force<S>::zero());
  articulated.resize(tree.joints.size());
}

template <class S>
void update_mass_and_bias(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m) {
  const int n = tree.axes;
  S* const mass = tree.shares_entries() ? m.mass_by_axis.data() : m.mass.data();
  S* const bias = tree.shares_entries() ? m.bias_by_axis.data() : m.bias.data();
  for (int i = 0; i < tree.bodies(); ++i) {
    m.composite[i] = kinematics.bodies[i].inertia;
    m.composite_bias[i] = kinematics.bodies[i].force_bias;
  }
  for (int i = tree.bodies() - 1; i >= 0; --i) {
    const TreeJoint& joint = tree.joints[i];
    for (int r = joint.axis; r < joint.axis + joint.nv; ++r) {
      const Force<S> force = m.composite[i] * kinematics.axes[r].axis;
      bias[r] = dot(kinematics.axes[r].axis, m.composite_bias[i]);
      S* row = mass + r * n;
      for (int c = r; c >= 0; c = tree.parent_of_axis[c])
        row[c] = dot(kinematics.axes[c].axis, force);
      row[r] += S(tree.armature[r]);
    }
    if (joint.parent >= 0) {
      m.composite[joint.parent] += m.composite[i];
      m.composite_bias[joint.parent] += m.composite_bias[i];
    }
  }
  if (!tree.shares_entries()) return;
  add_up_symmetric(tree, mass, m.mass.data());
  add_up(tree, bias, m.bias.data());
  for (int k = 0; k < tree.axes; ++k) {
    const int body = tree.joint_of_axis[k], follower = tree.joints[body].follower;
    const double factor = follower < 0 ? 1.0 : tree.followers[follower].multiplier;
    bias[k] = added_about_origin(kinematics, m, body, k) * S(std::max(1.0, factor * factor));
  }
  add_up(tree, bias, m.added.data());
}

template <class S>
auto factorize(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m) {
  if (tree.deep) return factorize_articulated(tree, kinematics, m);
  const int n = tree.nv;
  const auto& parent = tree.parent_of_v;
  for (int i = 0; i < n; ++i)
    for (int j = i; j >= 0; j = parent[j]) m.factor[i * n + j] = m.mass[i * n + j];
  auto bad = less(S(0.0), S(0.0));
  for (int k = n - 1; k >= 0; --k) {
    S* row = &m.factor[k * n];
    const int body = tree.joint_of_axis[k];
    const auto weak = mask_not(less(least_mass_pivot(tree, kinematics, m, body, k), row[k]));
    bad = mask_or(bad, weak);
    const S reciprocal = reciprocal_root(row[k], weak);
    m.inverse_diagonal[k] = reciprocal;
    for (int i = parent[k]; i >= 0; i = parent[i]) row[i] = row[i] * reciprocal;
    for (int i = parent[k]; i >= 0; i = parent[i]) {
      const S x = row[i];
      S* above = &m.factor[i * n];
      for (int j = i; j >= 0; j = parent[j]) above[j] -= x * row[j];
    }
  }
  return bad;
}

template <class S>
void solve_transposed(const Tree& tree, const MassMatrix<S>& m, S* x) {
  const int n = tree.nv;
  for (int i = n - 1; i >= 0; --i) {
    x[i] = x[i] * m.inverse_diagonal[i];
    const S xi = x[i];
    for (int j = tree.parent_of_v[i]; j >= 0; j = tree.parent_of_v[j])
      x[j] -= m.factor[i * n + j] * xi;
  }
}

template <class S>
void solve_factor(const Tree& tree, const MassMatrix<S>& m, S* x) {
  const int n = tree.nv;
  for (int i = 0; i < n; ++i) {
    S sum = x[i];
    for (int j = tree.parent_of_v[i]; j >= 0; j = tree.parent_of_v[j])
      sum -= m.factor[i * n + j] * x[j];
    x[i] = sum * m.inverse_diagonal[i];
  }
}

}  // namespace burnish

// Joint-space mass matrix M, bias b, and the factorization M = L^T L, which keeps the sparsity of
// the tree: L_ij is nonzero only if j is i or an ancestor of i (Featherstone, "Efficient
// Factorization of the Joint-Space Inertia Matrix for Branched Kinematic Trees", 2005).
#pragma once

#include <vector>

#include "dynamics/kinematics.hpp"

namespace burnish {

/// Mass matrix and bias, filled by update_mass_and_bias, and factor, filled by factorize.
template <class S>
struct MassMatrix {
  explicit MassMatrix(const Tree& tree);

  std::vector<Inertia<S>> composite;     ///< Inertia of the subtree of each body, in world axes
  std::vector<Force<S>> composite_bias;  ///< Bias force of the subtree of each body
  /// M, nv x nv, row-major [kg m^2]. Only entries (i, j) for ancestors j of i are set.
  std::vector<S> mass;
  std::vector<S> bias;              ///< Coriolis, centrifugal and gravity forces b(q, v), nv
  std::vector<S> factor;            ///< L, stored like mass
  std::vector<S> inverse_diagonal;  ///< 1 / L_ii, nv
  // Only for trees in which an entry of v can have several axes:
  std::vector<S> mass_by_axis, bias_by_axis;
  std::vector<S> added;  ///< Magnitude of the terms in each diagonal entry of M, nv
  // Only for deep trees (articulated.hpp), in world axes about the world's origin:
  std::vector<Force<S>> row_force;  ///< nv forces with L_kj = row_force[k] . (axis of entry j)
  std::vector<ArticulatedInertia<S>> articulated;  ///< Articulated-body inertia of each body
};

/// Computes M(q) from composite inertias, and b(q, v). Armature is added to the diagonal of M.
template <class S>
void update_mass_and_bias(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// Computes L with M = L^T L, after update_mass_and_bias with the same kinematics. Returns the
/// lanes in which M is not positive definite: a pivot does not exceed least_mass_pivot. In these
/// lanes the factor is finite but meaningless, and inverse_diagonal is zero at such pivots.
template <class S>
auto factorize(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// Replaces x (nv) by L^-T x.
template <class S>
void solve_transposed(const Tree& tree, const MassMatrix<S>& m, S* x);
/// Replaces x (nv) by L^-1 x.
template <class S>
void solve_factor(const Tree& tree, const MassMatrix<S>& m, S* x);

}  // namespace burnish

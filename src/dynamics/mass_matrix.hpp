// The joint-space mass matrix M, the bias b, and the factorisation M = L^T L that keeps the tree's
// sparsity (Featherstone, "Efficient Factorization of the Joint-Space Inertia Matrix for Branched
// Kinematic Trees", 2005): L_ij is non-zero only where j is an ancestor of i.
#pragma once

#include <vector>

#include "dynamics/kinematics.hpp"

namespace burnish {

/// Filled by update_mass_and_bias; the factor by factorize.
template <class S>
struct MassMatrix {
  explicit MassMatrix(const Tree& tree);

  std::vector<Inertia<S>> composite;     ///< per body: of its subtree, world coordinates
  std::vector<Force<S>> composite_bias;  ///< per body: bias force of its subtree
  std::vector<S> mass;    ///< nv x nv row-major, kg m^2; entry (i, j) for ancestors j of i
  std::vector<S> bias;    ///< nv, b(q, v): Coriolis, centrifugal and gravity forces
  std::vector<S> factor;  ///< L, stored like mass
  std::vector<S> inverse_diagonal;  ///< nv, 1 / L_ii
  // Of trees whose axes share entries of v alone:
  std::vector<S> mass_by_axis, bias_by_axis;
  std::vector<S> added;  ///< nv, the sums about the world's origin that M's diagonal is made of
  // Of deep trees alone (articulated.hpp), world axes, about the world's origin:
  std::vector<Force<S>> row_force;                 ///< nv: row k of L is S_j . row_force[k]
  std::vector<ArticulatedInertia<S>> articulated;  ///< per body
};

/// M(q) by composite inertias and b(q, v), from the kinematics. Armature is on M's diagonal.
template <class S>
void update_mass_and_bias(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// M = L^T L, after update_mass_and_bias with the same kinematics. Returns the lanes whose M is not
/// positive definite (a pivot not above least_mass_pivot); there the factor is finite but
/// meaningless, and inverse_diagonal is zero at the entries to blame.
template <class S>
auto factorize(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// x <- L^-T x, x: nv.
template <class S>
void solve_transposed(const Tree& tree, const MassMatrix<S>& m, S* x);
/// x <- L^-1 x, x: nv.
template <class S>
void solve_factor(const Tree& tree, const MassMatrix<S>& m, S* x);

}  // namespace burnish

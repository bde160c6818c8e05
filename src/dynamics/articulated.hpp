// The mass matrix of a deep tree, solved in as many steps as it has joints.
//
// Eliminating joints from the tips to the root leaves articulated-body inertias (Featherstone,
// Rigid Body Dynamics Algorithms, chapter 7). Entry k's, projected on its axis, is row k of the
// factor of M = L^T L as one force: L_kj = S_j . row_force_k for all ancestors j. A row thus costs
// 6 multiplications an entry, and a solve 24 an entry of v, however deep the tree is; working on L
// itself costs half the depth for either. Shallow trees are better off with L.
#pragma once

#include <vector>

#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// What factorize() does for deep trees: fills row_force, the factor and its diagonal, and returns
/// the weak lanes.
template <class S>
auto factorize_articulated(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// Solves with a mass matrix that factorize_articulated() prepared, from the same kinematics. Where
/// that found a lane weak, its results are finite but meaningless. Allocates only when it is made.
template <class S>
class ArticulatedSolver {
 public:
  explicit ArticulatedSolver(const Tree& tree);

  /// x = -M^-1 rhs; both nv x `columns`, row-major with `stride` entries from row to row.
  void solve_negative(const Kinematics<S>& kinematics, const MassMatrix<S>& m, const S* rhs, S* x,
                      int columns, int stride);
  /// x = M^-1, nv x nv.
  void invert(const Kinematics<S>& kinematics, const MassMatrix<S>& m, S* x);

 private:
  /// Entries of v in one unbranched chain; forces and motions of a block of columns pass from one
  /// to the next.
  struct Segment {
    int first, end;
    int parent;  ///< segment, -1 at the root
  };
  template <int C>
  void pull(const Segment& segment, int end, const Kinematics<S>& kinematics,
            const MassMatrix<S>& m, const auto& right_side, S* x);
  template <int C>
  void push(const Segment& segment, const Kinematics<S>& kinematics, const MassMatrix<S>& m, S* x);
  template <int C>
  void solve_block(const Kinematics<S>& kinematics, const MassMatrix<S>& m, const S* rhs, S* x,
                   int stride);
  template <int C>
  void invert_block(const Kinematics<S>& kinematics, const MassMatrix<S>& m, int segment,
                    int column, S* x);

  int n_, stride_ = 0;
  std::vector<Segment> segments_;
  std::vector<Force<S>> pulled_;   ///< per segment and column: what its children pass on
  std::vector<Motion<S>> pushed_;  ///< per segment and column: what its children start from
};

}  // namespace burnish

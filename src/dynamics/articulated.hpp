// Solver for the mass matrix of deep trees, with a cost that is linear in the number of joints.
//
// Eliminating the joints from the tips to the root leaves articulated-body inertias (Featherstone,
// Rigid Body Dynamics Algorithms, chapter 7). At entry k, this inertia times the axis, scaled, is a
// force that represents row k of the factor L of M = L^T L: L_kj = S_j . row_force_k for all
// ancestors j. An entry of a row then costs 6 multiplications, and a solve costs 24 per entry of v,
// for any depth. If a solver uses the entries of L, both costs grow with the depth of the tree, but
// are smaller for shallow trees.
#pragma once

#include <vector>

#include "dynamics/mass_matrix.hpp"

namespace burnish {

/// Version of factorize() for deep trees. Fills row_force, factor and inverse_diagonal, and returns
/// the lanes whose M is not positive definite.
template <class S>
auto factorize_articulated(const Tree& tree, const Kinematics<S>& kinematics, MassMatrix<S>& m);

/// Solver for a mass matrix factorized by factorize_articulated() with the same kinematics. In
/// lanes in which M is not positive definite, results are finite but meaningless. Only the
/// constructor allocates.
template <class S>
class ArticulatedSolver {
 public:
  explicit ArticulatedSolver(const Tree& tree);

  /// Computes x = -M^-1 rhs. Both are nv x `columns`, row-major with leading dimension `stride`.
  void solve_negative(const Kinematics<S>& kinematics, const MassMatrix<S>& m, const S* rhs, S* x,
                      int columns, int stride);
  /// Computes x = M^-1 (nv x nv).
  void invert(const Kinematics<S>& kinematics, const MassMatrix<S>& m, S* x);

 private:
  /// Entries of v in one unbranched chain. The solver processes several columns of the right-hand
  /// side together, segment by segment.
  struct Segment {
    int first, end;
    int parent;  ///< Index of the parent segment; -1 at the root
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
  std::vector<Force<S>> pulled_;   ///< Sum of the children's forces, per segment and column
  std::vector<Motion<S>> pushed_;  ///< Motion passed to the children, per segment and column
};

}  // namespace burnish

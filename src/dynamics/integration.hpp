// Arithmetic on configurations for kernels: q (+) dq, q1 (-) q0 and their derivatives. The
// functions accept any scalar and do not allocate. model/state.hpp has versions for Eigen vectors.
#pragma once

#include <vector>

#include "dynamics/tree.hpp"

namespace burnish {

/// Computes out = q (+) dq: moves every joint with its constant twist dq for unit time. q and out
/// have nq entries. dq has nv entries, in the body axes of each joint, like v. Quaternions and
/// (cos, sin) pairs of the result have unit length even if rounding changed their length in q.
/// `out` may be q.
template <class S>
void integrate_configuration(const Tree& tree, const S* q, const S* dq, S* out);

/// Computes the dq (nv) with q0 (+) dq = q1. Rotations take the shortest path: angles are within
/// [-pi, pi].
template <class S>
void difference_configuration(const Tree& tree, const S* q0, const S* q1, S* dq);

/// Non-Euclidean tangent block: entries of v of a joint whose motions do not commute. These joints
/// are a free-flyer (6 entries, SE(3)), a planar joint (3, SE(2)) and a ball (3, SO(3)). All other
/// joints have one entry and trivial derivatives:
/// d(q (+) dq)/dq = d(q (+) dq)/d(dq) = d(q1 (-) q0)/dq1 = 1, d(q1 (-) q0)/dq0 = -1.
struct TangentBlock {
  int first;       ///< First entry of v
  int size;        ///< Number of entries of v: 6 or 3
  JointKind kind;  ///< FreeFlyer, Planar or Ball
  int q;           ///< First entry of q
};

/// Returns the blocks of a tree, in ascending order.
std::vector<TangentBlock> tangent_blocks(const Tree& tree);

/// Computes the derivatives of q (+) dq for one block: by_q = Ad(exp(dq))^-1 and by_dq = J_r(dq).
/// Increments of q and of the result are right tangent increments. dq points to the entries of the
/// block. by_q and by_dq are size x size, row-major, and must not overlap dq.
template <class S>
void integrate_jacobians(const TangentBlock& block, const S* dq, S* by_q, S* by_dq);

/// Computes the derivatives of dq = q1 (-) q0 with respect to right tangent increments of q0 and
/// q1, for one block: by_q0 = -J_l^-1(dq) = -J_r^-1(-dq) and by_q1 = J_r^-1(dq). dq points to the
/// entries of the block; its rotation must not exceed half a turn. by_q0 and by_q1 are size x size,
/// row-major, and must not overlap dq.
template <class S>
void difference_jacobians(const TangentBlock& block, const S* dq, S* by_q0, S* by_q1);

}  // namespace burnish

// Arithmetic on configurations for kernels: q (+) dq, q1 (-) q0 and their derivatives, for any
// scalar and without allocating. model/state.hpp has the same for Eigen vectors.
#pragma once

#include <vector>

#include "dynamics/tree.hpp"

namespace burnish {

/// q (+) dq: moves every joint along its own twist dq for unit time. q, out: nq, dq: nv (body axes
/// of each joint, as v). Rotations of the result have unit length; q may be off by rounding.
/// `out` may be q.
template <class S>
void integrate_configuration(const Tree& tree, const S* q, const S* dq, S* out);

/// The dq (nv) with q0 (+) dq = q1 (nq each), shortest for rotations: angles are within [-pi, pi].
template <class S>
void difference_configuration(const Tree& tree, const S* q0, const S* q1, S* dq);

/// A joint whose entries of v do not commute, so that the derivatives below are no identities: a
/// free-flyer (6, SE(3)), a planar joint (3, SE(2)) or a ball (3, SO(3)). Every other joint has one
/// entry, and there
/// d(q (+) dq)/dq = d(q (+) dq)/d(dq) = d(q1 (-) q0)/dq1 = 1, d(q1 (-) q0)/dq0 = -1.
struct TangentBlock {
  int first;       ///< entry of v
  int size;        ///< 6 or 3
  JointKind kind;  ///< FreeFlyer, Planar or Ball
  int q;           ///< first entry of q
};

/// The blocks of a tree, ascending.
std::vector<TangentBlock> tangent_blocks(const Tree& tree);

/// Derivatives of q (+) dq of one block, as right tangent increments of the result by the right
/// tangent increment of q and by dq: by_q = Ad(exp(dq))^-1 and by_dq = J_r(dq).
/// dq: the block's own entries (whole vector + block.first). by_q, by_dq: size x size, row-major;
/// neither may be dq.
template <class S>
void integrate_jacobians(const TangentBlock& block, const S* dq, S* by_q, S* by_dq);

/// Derivatives of dq = q1 (-) q0 of one block by the right tangent increments of q0 and q1:
/// by_q0 = -J_l^-1(dq) = -J_r^-1(-dq) and by_q1 = J_r^-1(dq). Arguments as above; the rotation in
/// dq is at most half a turn.
template <class S>
void difference_jacobians(const TangentBlock& block, const S* dq, S* by_q0, S* by_q1);

}  // namespace burnish

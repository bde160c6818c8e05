// Riccati recursion: computes the value function of a knot, and the policy, from the value function
// of the next knot.
//
// With z = (du, dx), the knot's quadratic cost (h, H), dx' = F z + gap, and V'(dx') = vx'^T dx' +
// 1/2 dx'^T Vxx' dx':
//   w = vx' + Vxx' gap,   Q = H + F^T Vxx' F,   q = h + F^T w,
//   du = k + K dx minimises 1/2 z^T Q z + q^T z  (within bounds, if given),
//   Vxx = Qxx - L^T L,  vx = qx - L^T l,  R^T R = Quu,  L = R^-T Qux,  l = R^-T qu.
// SecondOrder dynamics are F = T P + E. P gives dv' = P z, T = (step B; 1; 0) maps dv' to dx', and
// E holds the parts of z that pass through. With V = Vxx', U = V T, W = T^T U and M = U^T E, only
// P, which has nv rows, enters dense products:
// F^T V F = P^T (W P + M) + M^T P + E^T V E.
//
// A thread team shares one knot: each worker computes some columns of Y and G, some rows of Qxx and
// some columns of the gains. Each worker computes the small matrices U, W, M and the factor of Quu
// itself, because passing them between cores would take longer. The team synchronises three times
// per knot (four times with bounds). Every entry is the same sum whichever worker computes it.
#pragma once

#include <vector>

#include "base/thread_team.hpp"
#include "burnish/solver/shooting_problem.hpp"
#include "solver/box_qp.hpp"
#include "solver/buffer.hpp"
#include "solver/dense.hpp"

namespace burnish {

/// Sizes of the memory that a recursion reads and writes. Rows are padded to whole vectors.
struct RiccatiLayout {
  RiccatiLayout(const StateShape& state, int max_controls);

  int expansion_stride;  ///< Entries between the starts of rows of hessian and dynamics
  int expansion_rows;    ///< Rows of the Hessian's memory, at least nz
  int value_stride;      ///< Entries between the starts of rows of Vxx; entries of vx
  int gain_stride;       ///< Entries between the starts of rows of K
  int spare;             ///< Number of unused entries after the last row of each memory block
};

/// Value function V(dx) = gradient^T dx + 1/2 dx^T hessian dx + constant, where dx = x (-) the
/// iterate's x.
struct ValueStorage {
  double* gradient;  ///< value_stride entries
  double* hessian;   ///< ndx x value_stride, both triangles
};

/// Policy u = u of the iterate + feedforward + gain dx. Other libraries often write u - K dx.
struct PolicyStorage {
  double* feedforward;  ///< k: nu entries
  double* gain;         ///< K: nu x gain_stride
};

/// Bounds of u at a knot, nu entries each, and the iterate's u. Null: no bounds.
struct ControlBox {
  const double* lower = nullptr;
  const double* upper = nullptr;
  const double* u = nullptr;
};

/// Rows C z that add the quadratic cost 1/2 sum w (C z)^2 to a knot.
struct WeightedRows {
  const double* rows = nullptr;      ///< C: count x nz
  const double* weighted = nullptr;  ///< w C
  int stride = 0;                    ///< Entries between the starts of rows, of both matrices
  int count = 0;
  const double* diagonal = nullptr;  ///< Added to the diagonal of the Hessian, nz entries
  const double* gradient = nullptr;  ///< Replaces the gradient of the expansion, nz entries
};

/// One knot of the recursion: what a step reads, and the memory that it writes.
struct RiccatiKnot {
  const KnotExpansion& expansion;
  int controls;
  const double* gap;     ///< End of the step minus the next state of the iterate, ndx entries
  ValueStorage next;     ///< Value function of the next knot, read
  PolicyStorage policy;  ///< Policy of this knot, written
  ValueStorage value;    ///< Value function of this knot, written
  double* hessian_gap;   ///< Vxx' gap, value_stride entries, written
};

/// Terms that a step adds to the cost of its knot, and bounds of its control.
struct RiccatiTerms {
  double regularization = 0.0;         ///< Added to the diagonal of Quu
  ControlBox box = {};                 ///< Bounds of the control
  const WeightedRows* rows = nullptr;  ///< Quadratic cost of constraint rows; null: none
};

/// Result of a recursion step: change of cost that the policy predicts.
struct RiccatiStep {
  /// First control at which Quu is not positive definite or not finite; -1: none.
  int failed_control = -1;
  double slope = 0.0;          ///< qu^T k
  double curvature = 0.0;      ///< k^T Quu k
  double gap_slope = 0.0;      ///< vx'^T gap
  double gap_curvature = 0.0;  ///< gap^T Vxx' gap
};

/// Riccati recursion with its workspace. Does not allocate after construction.
class RiccatiRecursion {
 public:
  /// `workers` is the largest size of a thread team.
  RiccatiRecursion(const StateShape& state, int max_controls, int workers = 1);

  const RiccatiLayout& layout() const { return layout_; }

  /// Number of multiplications of a knot with `controls` controls. Counts only terms of third order
  /// in the sizes.
  double multiplications(int controls, DynamicsForm form) const;

  /// Writes the value function of the terminal knot from its expansion.
  void terminal(const KnotExpansion& expansion, ValueStorage value) const;
  /// Writes the value function of a terminal knot with constraint rows.
  void terminal(const KnotExpansion& expansion, const WeightedRows& rows, ValueStorage value);

  /// Computes one knot backwards. With a box, policy.feedforward is the initial guess of the box
  /// QP, and the gains of clamped controls are zero.
  ///
  /// Every worker of a team calls step() with identical arguments except its own `team`, and may
  /// then call step() for the preceding knot. Every worker's result contains failed_control; only
  /// the leader's result contains the other fields.
  RiccatiStep step(const RiccatiKnot& at, const RiccatiTerms& terms, const ThreadTeam& team = {});

  /// Returns the factor of Quu of the last step; valid only without bounds and with one worker.
  dense::Factor factor() const { return {y_.data(), y_stride_, own_[0].inverse_diagonal.data()}; }

  /// Repeats a step for another gradient (nz entries). Reads results of the step: `factor` of Quu,
  /// the gains and at.hessian_gap. Overwrites `gradient`; writes the feedforward and the gradient
  /// of the value function.
  void resolve(const RiccatiKnot& at, const dense::Factor& factor, double* gradient);

 private:
  struct Knot;  ///< Arguments of a step and a worker's ranges
  /// Workspace of each worker: U^T (nv x ndx), W (nv x nv), M (nv x nz), rows of V E, and R with
  /// the worker's columns of L.
  struct Own {
    Buffer u, w, m, passed, inverse_diagonal, factor;
  };

  void load_cost(const Knot& knot);
  void project_value(const Knot& knot);
  void project_steps(const Knot& knot);
  void add_to_controls(const Knot& knot);
  void add_passed_to_controls(const Knot& knot);
  const double* pass_filtered(const Knot& knot, int c);
  void cross_gap(const Knot& knot, const double* gap, double* hessian_gap, RiccatiStep& result);
  void add_gradient(const Knot& knot, const double* gradient);
  void add_rows(const Knot& knot, const WeightedRows& rows);
  void add_to_states(const Knot& knot);
  void add_passed_to_states(const Knot& knot);
  void add_passed_controls_to_states(const Knot& knot);
  void clamp(const Knot& knot, const ControlBox& box, double* k, RiccatiStep& result);
  int factorize(const Knot& knot, const PolicyStorage& policy);
  void reduce(const Knot& knot, const ValueStorage& value);
  void conclude(const Knot& knot, bool bounded, const PolicyStorage& policy, RiccatiStep& result);

  StateShape state_;
  RiccatiLayout layout_;
  // Y = [Quu | Qux | qu] with the upper triangle of Quu; lower triangle of Qxx; gradient q.
  Buffer y_, qxx_, gradient_;
  int y_stride_;
  Buffer g_;       ///< G = W P + M: nv x nz. Dense form: G = Vxx' F, ndx x nz
  Buffer w_next_;  ///< w = vx' + Vxx' gap
  Buffer l_;       ///< [L | l] of a team; a single worker keeps it in Y
  Buffer box_lower_, box_upper_;
  Buffer column_;  ///< Feedforward, one SIMD vector per control
  std::vector<Own> own_;
  BoxQp box_qp_;
};

}  // namespace burnish

// The Riccati recursion: from the value function of the rest of a horizon to that of one knot
// earlier, and the policy in between.
//
// With z = (du, dx), the knot's quadratic cost (h, H), dx' = F z + gap, and V'(dx') = vx'^T dx' +
// 1/2 dx'^T Vxx' dx':
//   w = vx' + Vxx' gap,   Q = H + F^T Vxx' F,   q = h + F^T w,
//   du = k + K dx minimises 1/2 z^T Q z + q^T z  (within the bounds, where there are any),
//   Vxx = Qxx - L^T L,  vx = qx - L^T l,  R^T R = Quu,  L = R^-T Qux,  l = R^-T qu.
// SecondOrder dynamics are F = T P + E, T: dv' -> dx' = (step B; 1; 0), E the parts of z that pass
// through. With U = Vxx' T, W = T^T U and M = U^T E, only P, which has nv rows, meets a dense
// product: F^T V F = P^T (W P + M) + M^T P + E^T V E.
#pragma once

#include "burnish/ocp/shooting_problem.hpp"
#include "burnish/solver/box_qp.hpp"
#include "burnish/solver/buffer.hpp"

namespace burnish {

/// Sizes of the memory that a recursion reads and writes; rows are padded to whole vectors.
struct RiccatiLayout {
  RiccatiLayout(const StateShape& state, int max_controls);

  int expansion_stride;  ///< entries between rows of hessian and dynamics
  int expansion_rows;    ///< rows of the hessian's memory, more than nz
  int value_stride;      ///< of Vxx, and entries of vx
  int gain_stride;       ///< of K
  int spare;             ///< entries that every block of memory is longer than its rows
};

/// V(dx) = gradient^T dx + 1/2 dx^T hessian dx (and a constant), dx = x (-) the iterate's x.
struct ValueStorage {
  double* gradient;  ///< value_stride entries
  double* hessian;   ///< ndx x value_stride, both triangles
};

/// u = u of the iterate + feedforward + gain dx. Beware of signs elsewhere: many write u - K dx.
struct PolicyStorage {
  double* feedforward;  ///< k: nu entries
  double* gain;         ///< K: nu x gain_stride
};

/// Bounds of u at a knot, nu entries each, and the iterate's u. Null: unbounded.
struct ControlBox {
  const double* lower = nullptr;
  const double* upper = nullptr;
  const double* u = nullptr;
};

/// What one step says about the cost that its policy saves.
struct RiccatiStep {
  /// First control at which Quu is not positive definite (or not a number); -1: none.
  int failed_control = -1;
  double slope = 0.0;          ///< qu^T k
  double curvature = 0.0;      ///< k^T Quu k
  double gap_slope = 0.0;      ///< vx'^T gap
  double gap_curvature = 0.0;  ///< gap^T Vxx' gap
};

/// One recursion's workspace. Nothing is allocated after construction.
class RiccatiRecursion {
 public:
  RiccatiRecursion(const StateShape& state, int max_controls);

  const RiccatiLayout& layout() const { return layout_; }

  /// The value function of the end: the terminal cost's expansion.
  void terminal(const KnotExpansion& expansion, ValueStorage value) const;

  /// One knot backwards. `regularization` is added to the diagonal of Quu. `hessian_gap` receives
  /// Vxx' gap (value_stride entries). Where a box is given, policy.feedforward is read first: the
  /// guess from which its quadratic program starts; gains of clamped controls are zero.
  RiccatiStep step(const KnotExpansion& expansion, int controls, const double* gap,
                   ValueStorage next, double regularization, const ControlBox& box,
                   PolicyStorage policy, ValueStorage value, double* hessian_gap);

 private:
  void load_cost(const KnotExpansion& expansion);
  void add_dense(const KnotExpansion& expansion, const ValueStorage& next);
  void add_second_order(const KnotExpansion& expansion, const ValueStorage& next);
  void project_value(const KnotExpansion& expansion, const ValueStorage& next);
  void add_products(const KnotExpansion& expansion);
  void add_passed(const KnotExpansion& expansion, const ValueStorage& next);
  void clamp(const ControlBox& box, double* k, RiccatiStep& result);

  StateShape state_;
  RiccatiLayout layout_;
  int nu_ = 0, nz_ = 0, filtered_controls_ = 0;
  // Y = [Quu | Qux | qu], upper triangle of Quu; Qxx, lower; the gradient q.
  Buffer y_, qxx_, gradient_;
  int y_stride_;
  // U^T: nv x ndx; W: nv x nv; M and G = W P + M: nv x nz. Dense: G = Vxx' F, ndx x nz.
  Buffer u_, w_, m_, g_, passed_;
  Buffer w_next_;  ///< w = vx' + Vxx' gap
  Buffer inverse_diagonal_, solution_, box_lower_, box_upper_;
  BoxQp box_qp_;
};

}  // namespace burnish
